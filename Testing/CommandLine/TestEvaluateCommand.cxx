// SPDX-License-Identifier: BSD-3-Clause
// marrow evaluate as a user meets it, on an octahedron cut in halves this way and that.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace fs = std::filesystem;

namespace
{
class EvaluateCommand : public testing::Test
{
protected:
  void SetUp() override
  {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    this->Folder = fs::path(MARROW_TEST_OUTPUT) / (std::string("Evaluate") + test->name());
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
    this->Write("mesh.off",
      "OFF\n6 8 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n0 0 1\n0 0 -1\n"
      "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n3 1 0 5\n3 2 1 5\n3 3 2 5\n3 0 3 5\n");
    this->Write("upper.seg", "1\n1\n1\n1\n2\n2\n2\n2\n");
    this->Write("right.seg", "1\n2\n2\n1\n1\n2\n2\n1\n");
    this->Write("whole.seg", "1\n1\n1\n1\n1\n1\n1\n1\n");
  }

  void Write(const std::string& name, const std::string& text) const
  {
    std::ofstream(this->Folder / name) << text;
  }

  std::string Content(const std::string& name) const
  {
    std::ifstream file(this->Folder / name);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
  }

  /// What is printed; of an error, the message.
  std::string Run(const std::string& arguments, bool success = true) const
  {
    const std::string command = "cd '" + this->Folder.string() +
      "' && '" MARROW_COMMAND "' evaluate " + arguments + " >stdout.txt 2>stderr.txt";
    EXPECT_EQ(std::system(command.c_str()) == 0, success) << arguments;
    return this->Content(success ? "stdout.txt" : "stderr.txt");
  }

  fs::path Folder;
};
}

TEST_F(EvaluateCommand, PrintsATable)
{
  const std::string table = this->Run("mesh.off --segments upper.seg --reference right.seg");
  EXPECT_NE(table.find("RandError                   0.5714\n"), std::string::npos) << table;
  EXPECT_NE(table.find("HammingDistance             0.5000\n"), std::string::npos) << table;
}

TEST_F(EvaluateCommand, AveragesOverReferences)
{
  const std::string csv =
    this->Run("mesh.off --segments upper.seg --reference right.seg upper.seg --csv");
  EXPECT_NE(csv.find("reference,CutDiscrepancy,HammingDistance,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("right.seg,1.22474,0.5,0.5,0.5,0.571429,0.5,0.5,0.5,"), std::string::npos)
    << csv;
  EXPECT_NE(csv.find("upper.seg,0,0,0,0,0,0,0,1,0\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("mean,0.612372,0.25,0.25,0.25,0.285714,0.25,0.25,0.75,"), std::string::npos)
    << csv;
}

TEST_F(EvaluateCommand, JsonHasNullForWhatIsUndefined)
{
  const nlohmann::json json =
    nlohmann::json::parse(this->Run("mesh.off --segments whole.seg --reference right.seg --json"));
  EXPECT_EQ(json.at("mesh"), "mesh.off");
  ASSERT_EQ(json.at("references").size(), 1u);
  EXPECT_EQ(json.at("references").at(0).at("reference"), "right.seg");
  EXPECT_TRUE(json.at("references").at(0).at("CutDiscrepancy").is_null());
  EXPECT_TRUE(json.at("mean").at("CutDiscrepancy").is_null());
  EXPECT_EQ(json.at("mean").at("RandError"), json.at("references").at(0).at("RandError"));
}

TEST_F(EvaluateCommand, JsonTakesAnyNameOfAFile)
{
  fs::copy_file(this->Folder / "right.seg", this->Folder / "right\t\xff.seg");
  const nlohmann::json json = nlohmann::json::parse(
    this->Run("mesh.off --segments upper.seg --reference 'right\t\xff.seg' --json"));
  EXPECT_EQ(json.at("references").at(0).at("reference"), "right\t\ufffd.seg");
}

TEST_F(EvaluateCommand, ErrorsNameTheFile)
{
  EXPECT_NE(this->Run("mesh.off --reference right.seg", false)
              .find("mesh.off: the mesh has no labels \"SegmentId\", nor others: name a .seg file"),
    std::string::npos);
  this->Write("short.seg", "1\n2\n");
  EXPECT_NE(
    this->Run("mesh.off --segments upper.seg --reference short.seg", false).find("short.seg"),
    std::string::npos);
  EXPECT_NE(
    this->Run("mesh.off --segments upper.seg", false).find("--reference"), std::string::npos);
}
