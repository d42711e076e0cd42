// SPDX-License-Identifier: BSD-3-Clause
// marrow collection as a user meets it, on a folder of bipeds.
#include <vtkCellData.h>
#include <vtkCreatureSource.h>
#include <vtkDataArray.h>
#include <vtkMarrowMeshWriter.h>
#include <vtkMarrowSegmentWriter.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace
{
struct Outcome
{
  int ExitCode;
  std::string Error;
};

class CollectionCommand : public testing::Test
{
protected:
  void SetUp() override
  {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    this->Folder = fs::path(MARROW_TEST_OUTPUT) / (std::string("Collection") + test->name());
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder / "in");
    for (int seed = 1; seed <= 3; ++seed)
    {
      const std::string name = "in/biped" + std::to_string(seed);
      vtkNew<vtkMarrowMeshWriter> mesh;
      mesh->SetInputData(Biped(seed));
      mesh->SetFileName((this->Folder / (name + ".off")).c_str());
      mesh->Write();
    }
    this->WriteSegments(1);
  }

  static vtkSmartPointer<vtkPolyData> Biped(int seed)
  {
    vtkNew<vtkCreatureSource> creature;
    creature->SetShapeToBiped();
    creature->SetResolution(5000);
    creature->SetSeed(seed);
    creature->SetPose(0.4);
    creature->Update();
    return creature->GetOutput();
  }

  void WriteSegments(int seed) const
  {
    vtkNew<vtkMarrowSegmentWriter> segments;
    segments->SetInputData(Biped(seed));
    segments->SetFileName((this->Folder / ("in/biped" + std::to_string(seed) + ".seg")).c_str());
    segments->Write();
  }

  std::string Content(const std::string& name) const
  {
    std::ifstream file(this->Folder / name);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
  }

  Outcome Run(const std::string& arguments, const std::string& before = "") const
  {
    const std::string command = "cd '" + this->Folder.string() + "' && " + before +
      " '" MARROW_COMMAND "' --quiet collection " + arguments + " >stdout.txt 2>stderr.txt";
    const int status = std::system(command.c_str());
    return { WIFEXITED(status) ? WEXITSTATUS(status) : -1, this->Content("stderr.txt") };
  }

  /// The share of the lines of a segment file that are those of the creature.
  double Accuracy(const std::string& name, int seed) const
  {
    const vtkSmartPointer<vtkPolyData> truth = Biped(seed);
    vtkDataArray* labels = truth->GetCellData()->GetArray("SegmentId");
    std::ifstream file(this->Folder / name);
    int label = 0;
    vtkIdType same = 0;
    vtkIdType lines = 0;
    for (; file >> label; ++lines)
    {
      same +=
        lines < labels->GetNumberOfTuples() && static_cast<int>(labels->GetTuple1(lines)) == label
        ? 1
        : 0;
    }
    return lines == labels->GetNumberOfTuples() ? static_cast<double>(same) / lines : 0.0;
  }

  fs::path Folder;
};
}

TEST_F(CollectionCommand, LabelsAFolderAndSumsItUp)
{
  const Outcome outcome = this->Run("in -o out --format seg");
  EXPECT_EQ(outcome.ExitCode, 0) << outcome.Error;
  EXPECT_EQ(outcome.Error, "");
  EXPECT_GT(this->Accuracy("out/biped2.seg", 2), 0.9);
  EXPECT_GT(this->Accuracy("out/biped3.seg", 3), 0.9);
  EXPECT_FALSE(fs::exists(this->Folder / "out/biped1.seg")); // it is labelled
  std::istringstream csv(this->Content("out/summary.csv"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(csv, line);)
  {
    lines.push_back(line);
  }
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].rfind("mesh,file,role,source,confidence,against,area_0,area_1", 0), 0u);
  EXPECT_EQ(lines[1].rfind("biped1,in/biped1.off,source,,1.0000", 0), 0u);
  EXPECT_EQ(lines[2].rfind("biped2,in/biped2.off,target,biped1,0.", 0), 0u);
  const auto json = nlohmann::json::parse(this->Content("out/summary.json"));
  ASSERT_EQ(json.size(), 3u);
  EXPECT_EQ(json[2]["mesh"], "biped3");
  EXPECT_EQ(json[2]["role"], "target");
  EXPECT_EQ(json[2]["areas"].size(), 7u);
}

#ifdef MARROW_HAS_DLIB
TEST_F(CollectionCommand, SaysWhatIsLearntFromThreeLabelledMeshes)
{
  this->WriteSegments(2);
  this->WriteSegments(3);
  vtkNew<vtkMarrowMeshWriter> target;
  target->SetInputData(Biped(4));
  target->SetFileName((this->Folder / "in/biped4.off").c_str());
  target->Write();
  EXPECT_EQ(this->Run("in -o out --format seg").ExitCode, 0);
  const auto json = nlohmann::json::parse(this->Content("out/summary.json"));
  ASSERT_EQ(json.size(), 4u);
  for (int row = 0; row < 3; ++row)
  {
    EXPECT_GT(json[row]["held_out_accuracy"], 0.8);
    EXPECT_GE(json[row]["held_out_accuracy_learnt"].get<double>(),
      json[row]["held_out_accuracy"].get<double>() - 0.005);
  }
  EXPECT_TRUE(json[3]["held_out_accuracy"].is_null());
  EXPECT_GT(this->Accuracy("out/biped4.seg", 4), 0.9);

  EXPECT_EQ(this->Run("in -o alone --format seg --no-learning").ExitCode, 0);
  const auto alone = nlohmann::json::parse(this->Content("alone/summary.json"));
  EXPECT_TRUE(alone[0]["held_out_accuracy"].is_null());
  EXPECT_EQ(alone[3]["learning"], 0.0);
  EXPECT_NE(this->Content("alone/summary.csv")
              .find(",learning,held_out_accuracy,held_out_accuracy_learnt,note\n"),
    std::string::npos);
}
#endif

TEST_F(CollectionCommand, AnotherRunTakesWhatIsKnown)
{
  EXPECT_EQ(this->Run("in -o out").ExitCode, 0);
  std::vector<fs::path> pairs;
  for (const auto& entry : fs::directory_iterator(this->Folder / "out/.marrow"))
  {
    pairs.push_back(entry.path());
  }
  ASSERT_EQ(pairs.size(), 3u);
  const std::string before = this->Content("out/biped3.vtp");
  const auto written = fs::last_write_time(pairs[0]);
  EXPECT_EQ(this->Run("in -o out").ExitCode, 0);
  EXPECT_EQ(fs::last_write_time(pairs[0]), written);
  EXPECT_EQ(this->Content("out/biped3.vtp"), before);
  // To correct is to add.
  this->WriteSegments(2);
  EXPECT_EQ(this->Run("in -o out").ExitCode, 0);
  EXPECT_NE(
    this->Content("out/summary.csv").find("biped2,in/biped2.off,source"), std::string::npos);
}

#ifdef MARROW_MPIEXEC
TEST_F(CollectionCommand, ProcessesShareTheWorkAndGiveTheSame)
{
  EXPECT_EQ(this->Run("in -o alone").ExitCode, 0);
  for (const std::string number : { "2", "4" })
  {
    const std::string folder = "of" + number;
    const Outcome outcome = this->Run("in -o " + folder, MARROW_MPIEXEC " -n " + number);
    EXPECT_EQ(outcome.ExitCode, 0) << outcome.Error;
    for (const std::string file : { "/biped2.vtp", "/biped3.vtp", "/summary.csv" })
    {
      EXPECT_EQ(this->Content(folder + file), this->Content("alone" + file)) << folder << file;
    }
    // Nothing was left for the first to do by itself: the maps of a pair are all in its file.
    for (const auto& entry : fs::directory_iterator(this->Folder / "alone/.marrow"))
    {
      const std::string file = "/.marrow/" + entry.path().filename().string();
      EXPECT_EQ(this->Content(folder + file), this->Content("alone" + file)) << folder << file;
    }
  }
}

TEST_F(CollectionCommand, EveryProcessDoesItsPart)
{
  // Each with a folder of its own, which is a mistake: what the others did is not found then.
  EXPECT_EQ(this->Run("in -o alone").ExitCode, 0);
  const std::string second = " : -n 1 '" MARROW_COMMAND "' --quiet collection in -o second";
  const Outcome outcome = this->Run("in -o first" + second, MARROW_MPIEXEC " -n 1");
  EXPECT_EQ(outcome.ExitCode, 0) << outcome.Error;
  const auto numberOfPairs = [this](const std::string& folder)
  {
    const fs::directory_iterator files(this->Folder / folder / ".marrow");
    return std::distance(begin(files), end(files));
  };
  EXPECT_EQ(numberOfPairs("second"), 2); // of three
  EXPECT_FALSE(fs::exists(this->Folder / "second/summary.csv"));
  EXPECT_EQ(numberOfPairs("first"), 3);
  EXPECT_EQ(this->Content("first/biped2.vtp"), this->Content("alone/biped2.vtp"));
}

TEST_F(CollectionCommand, ProcessesTellWhatIsWrongOnceAndEnd)
{
  std::ofstream(this->Folder / "in/broken.off") << "OFF\nnothing\n";
  const Outcome partly = this->Run("in -o out --format seg", MARROW_MPIEXEC " -n 2");
  EXPECT_NE(partly.ExitCode, 0);
  EXPECT_NE(partly.Error.find("3 of 4 done; 1 failed: in/broken.off"), std::string::npos)
    << partly.Error;
  const std::size_t first = partly.Error.find("is not a valid OFF file");
  ASSERT_NE(first, std::string::npos) << partly.Error;
  EXPECT_EQ(partly.Error.find("is not a valid OFF file", first + 1), std::string::npos)
    << partly.Error;
  EXPECT_GT(this->Accuracy("out/biped3.seg", 3), 0.9);
  fs::remove(this->Folder / "in/biped1.seg");
  const Outcome outcome = this->Run("in -o out", MARROW_MPIEXEC " -n 2");
  EXPECT_NE(outcome.ExitCode, 0);
  EXPECT_NE(outcome.Error.find("No mesh of the collection"), std::string::npos) << outcome.Error;
}
#else
TEST_F(CollectionCommand, ProcessesShareTheWorkAndGiveTheSame)
{
  GTEST_SKIP() << "VTK has no ParallelMPI here, or there is no mpiexec.";
}
#endif

TEST_F(CollectionCommand, ABadMeshDoesNotStopTheRest)
{
  std::ofstream(this->Folder / "in/broken.off") << "OFF\nnothing\n";
  std::ofstream(this->Folder / "in/biped2.seg") << "1\n2\n";
  std::ofstream(this->Folder / "in/notes.txt") << "not a mesh\n";
  const Outcome outcome = this->Run("in -o out --format seg");
  EXPECT_EQ(outcome.ExitCode, 1);
  EXPECT_NE(
    outcome.Error.find("2 of 4 done; 2 failed: in/biped2.off, in/broken.off"), std::string::npos)
    << outcome.Error;
  EXPECT_GT(this->Accuracy("out/biped3.seg", 3), 0.9);
  EXPECT_NE(
    this->Content("out/summary.csv").find("broken,in/broken.off,failed"), std::string::npos);
}

TEST_F(CollectionCommand, AnInterruptKeepsWhatIsDone)
{
  const Outcome stopped = this->Run("in -o out", "timeout -s INT 0.6");
  // Fast machines may have done it all.
  if (stopped.Error.find("run again to go on") != std::string::npos)
  {
    EXPECT_FALSE(fs::exists(this->Folder / "out/biped2.vtp"));
  }
  EXPECT_EQ(this->Run("in -o out").ExitCode, 0);
  EXPECT_TRUE(fs::exists(this->Folder / "out/biped2.vtp"));
}

TEST_F(CollectionCommand, WhatCannotBeIsSaid)
{
  EXPECT_NE(this->Run("in -o in").Error.find("choose another folder"), std::string::npos);
  EXPECT_NE(this->Run("nowhere -o out").Error.find("nowhere"), std::string::npos);
  fs::create_directories(this->Folder / "empty");
  EXPECT_NE(this->Run("empty -o out").Error.find("there is no mesh in it"), std::string::npos);
  fs::remove(this->Folder / "in/biped1.seg");
  EXPECT_NE(this->Run("in -o out").Error.find("No mesh of the collection"), std::string::npos);
  EXPECT_NE(this->Run("in -o out --report page.html", "env -u DISPLAY").Error.find("no X display"),
    std::string::npos);
}

TEST_F(CollectionCommand, TheReportHoldsAPictureOfEachTarget)
{
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display)
  {
    GTEST_SKIP() << "There is no display.";
  }
  EXPECT_EQ(this->Run("in -o out --report page.html").ExitCode, 0);
  const std::string page = this->Content("page.html");
  std::size_t pictures = 0;
  for (std::size_t at = page.find("data:image/png;base64,"); at != std::string::npos;
       at = page.find("data:image/png;base64,", at + 1))
  {
    ++pictures;
  }
  EXPECT_EQ(pictures, 2u);
  EXPECT_EQ(page.find("http"), std::string::npos); // nothing from elsewhere
  // What is written is the same without it.
  const std::string mesh = this->Content("out/biped2.vtp");
  EXPECT_EQ(this->Run("in -o out").ExitCode, 0);
  EXPECT_EQ(this->Content("out/biped2.vtp"), mesh);
}
