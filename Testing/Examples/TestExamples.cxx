// SPDX-License-Identifier: BSD-3-Clause
// Every example and the program of the figures run, and draw what the documentation shows.
#include "ImageComparison.h"

#include <cstdio>
#include <filesystem>
#include <string>

namespace
{
/// What the program printed; the test fails if the program does.
std::string RunProgram(const std::string& command)
{
  std::string printed;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  char buffer[256];
  while (pipe && std::fgets(buffer, sizeof(buffer), pipe))
  {
    printed += buffer;
  }
  EXPECT_EQ(pipe ? pclose(pipe) : -1, 0) << command << ": " << printed;
  return printed;
}

void ExpectSamePicture(const std::string& drawn, const std::string& expected)
{
  vtkNew<vtkPNGReader> readers[2];
  readers[0]->SetFileName(drawn.c_str());
  readers[1]->SetFileName(expected.c_str());
  for (vtkPNGReader* reader : readers)
  {
    reader->Update();
  }
  EXPECT_LE(marrow::test::ImageError(readers[0]->GetOutput(), readers[1]->GetOutput()), 200.0)
    << drawn << " is not as in the documentation. If it is right, copy it to " << expected;
}

/// Runs Examples/Cxx/PROGRAM, whose picture is Documentation/images/example-NAME.png.
std::string ExpectPicture(
  const std::string& program, const std::string& name, const std::string& arguments = "")
{
  const std::string drawn = std::string(MARROW_TEST_OUTPUT) + "/example-" + name + ".png";
  const std::string expected = std::string(MARROW_IMAGES) + "/example-" + name + ".png";
  std::filesystem::create_directories(MARROW_TEST_OUTPUT);
  std::filesystem::remove(drawn);
  const std::string printed =
    RunProgram(std::string(MARROW_EXAMPLES) + "/" + program + " " + drawn + " " + arguments);
  EXPECT_TRUE(std::filesystem::exists(drawn)) << printed;
  if (std::filesystem::exists(drawn))
  {
    ExpectSamePicture(drawn, expected);
  }
  return printed;
}
}

TEST(Cxx, Measures)
{
  ExpectPicture("Measures", "measures");
}

TEST(Cxx, Skeleton)
{
  EXPECT_NE(ExpectPicture("Skeleton", "skeleton").find("nodes in 7 branches"), std::string::npos);
}

TEST(Cxx, Correspondence)
{
  ExpectPicture("Correspondence", "correspondence");
}

TEST(Cxx, Transfer)
{
  ExpectPicture("Transfer", "transfer");
}

TEST(Cxx, Collection)
{
  ExpectPicture("Collection", "collection");
}

TEST(Cxx, PickBranch)
{
  // A click on a front leg, and one beside the creature.
  const std::string leg = ExpectPicture("PickBranch", "picking", "281 142");
  EXPECT_NE(leg.find("Branch "), std::string::npos) << leg;
  const std::string nothing = std::string(MARROW_TEST_OUTPUT) + "/nothing-picked.png";
  const std::string printed =
    RunProgram(std::string(MARROW_EXAMPLES) + "/PickBranch " + nothing + " 5 5");
  EXPECT_NE(printed.find("No branch there"), std::string::npos) << printed;
}

// Those of the documentation's figures that need no meshes but Marrow's own, one for each source file.
TEST(Figures, AreAsInTheDocumentation)
{
  const std::string names[] = { "slices", "parameter-node-spacing", "correspondence-tree",
    "covering-region", "snake", "transfer", "labels" };
  const std::string folder = MARROW_TEST_OUTPUT;
  std::filesystem::create_directories(folder);
  const auto pictureOf = [](const std::string& where, const std::string& name)
  { return where + "/" + name + ".png"; };
  std::string command = std::string(MARROW_EXAMPLES) + "/marrow-figures " + folder + " none";
  for (const std::string& name : names)
  {
    std::filesystem::remove(pictureOf(folder, name));
    command.append(" ").append(name);
  }
  RunProgram(command);
  for (const std::string& name : names)
  {
    ExpectSamePicture(pictureOf(folder, name), pictureOf(MARROW_IMAGES, name));
  }
}
