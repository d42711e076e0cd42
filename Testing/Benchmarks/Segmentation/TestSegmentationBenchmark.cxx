// SPDX-License-Identifier: BSD-3-Clause
// The benchmark's program on a small collection of creatures whose labels are known.
#include <vtkCellData.h>
#include <vtkCreatureSource.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace
{
constexpr int NumberOfMeshes = 3;
constexpr int NumberOfPairs = NumberOfMeshes * (NumberOfMeshes - 1);

class SegmentationBenchmark : public testing::Test
{
protected:
  void SetUp() override
  {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    this->Folder = fs::path(MARROW_TEST_OUTPUT) / test->name();
    fs::remove_all(this->Folder);
    for (const char* kind : { "meshes", "labels", "pieces", "humans" })
    {
      fs::create_directories(this->Folder / "data" / kind);
    }
    std::string labels;
    for (int id = 1; id <= NumberOfMeshes; ++id)
    {
      labels = this->WriteCreature(id);
    }
    std::ofstream(this->Folder / "data/index.json")
      << "{ \"Creature\": { \"ids\": [1, 2, 3], \"labels\": [" << labels << "] } }\n";
  }

  /// Returns names for the labels.
  std::string WriteCreature(int id) const
  {
    vtkNew<vtkCreatureSource> creature;
    creature->SetShapeToQuadruped();
    creature->SetResolution(2500);
    creature->SetPose(0.3);
    creature->SetSeed(id);
    creature->Update();
    vtkPolyData* mesh = creature->GetOutput();
    const std::string name = std::to_string(id);
    std::ofstream off(this->Folder / "data/meshes" / (name + ".off"));
    std::ofstream label(this->Folder / "data/labels" / (name + ".seg"));
    std::ofstream piece(this->Folder / "data/pieces" / (name + ".seg"));
    std::ofstream human(this->Folder / "data/humans" / (name + "_0.seg"));
    off << "OFF\n" << mesh->GetNumberOfPoints() << " " << mesh->GetNumberOfCells() << " 0\n";
    off.precision(9);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const double* p = mesh->GetPoint(i);
      off << p[0] << " " << p[1] << " " << p[2] << "\n";
    }
    vtkDataArray* segments = mesh->GetCellData()->GetArray("SegmentId");
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      mesh->GetCellPoints(cell, corners);
      off << "3 " << corners->GetId(0) << " " << corners->GetId(1) << " " << corners->GetId(2)
          << "\n";
      for (std::ofstream* file : { &label, &piece, &human })
      {
        *file << static_cast<int>(segments->GetTuple1(cell)) << "\n";
      }
    }
    std::string names = "\"0\"";
    for (int i = 1; i <= static_cast<int>(segments->GetRange()[1]); ++i)
    {
      names += ", \"" + std::to_string(i) + "\"";
    }
    return names;
  }

  /// Exit code.
  int Run(const std::string& results, const std::string& options = "",
    const std::string& launcher = "") const
  {
    const std::string command = "cd '" + this->Folder.string() + "' && " + launcher +
      " '" MARROW_BENCHMARK "' data -o " + results + " " + options + " >stdout.txt 2>stderr.txt";
    return std::system(command.c_str());
  }

  std::string Content(const std::string& name) const
  {
    std::ifstream file(this->Folder / name);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
  }

  /// The rows of a table: column to cell.
  std::vector<std::map<std::string, std::string>> Table(const std::string& name) const
  {
    std::istringstream lines(this->Content(name));
    const auto split = [](const std::string& line)
    {
      std::vector<std::string> cells;
      std::istringstream stream(line);
      for (std::string cell; std::getline(stream, cell, ',');)
      {
        cells.push_back(cell);
      }
      return cells;
    };
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> header = split(line);
    std::vector<std::map<std::string, std::string>> rows;
    while (std::getline(lines, line))
    {
      const std::vector<std::string> cells = split(line);
      rows.emplace_back();
      for (std::size_t i = 0; i < std::min(cells.size(), header.size()); ++i)
      {
        rows.back()[header[i]] = cells[i];
      }
    }
    return rows;
  }

  fs::path Folder;
};

TEST_F(SegmentationBenchmark, MeasuresEveryOrderedPair)
{
  ASSERT_EQ(this->Run("results"), 0) << this->Content("stderr.txt");
  const auto pairs = this->Table("results/pairs.csv");
  ASSERT_EQ(pairs.size(), NumberOfPairs);
  for (const auto& pair : pairs)
  {
    EXPECT_NE(pair.at("source"), pair.at("target"));
    EXPECT_EQ(pair.at("error"), "\"\"");
    // The humans of this collection are the labels, and a label is a piece.
    EXPECT_EQ(pair.at("rand_error"), pair.at("rand_error_to_labels"));
    EXPECT_GT(std::stod(pair.at("label_accuracy")), 0.7);
    EXPECT_LE(std::stod(pair.at("same_label_pairs")), std::stod(pair.at("matched_pairs")));
  }
  const auto meshes = this->Table("results/meshes.csv");
  ASSERT_EQ(meshes.size(), NumberOfMeshes);
  for (const auto& mesh : meshes)
  {
    EXPECT_EQ(mesh.at("genus"), "0");
    EXPECT_EQ(mesh.at("loops"), "0");
    EXPECT_GT(std::stod(mesh.at("nodes_inside")), 0.9 * std::stod(mesh.at("nodes")));
  }
  const auto summary = this->Table("results/summary.csv");
  double mean = 0.0;
  double worst = 1.0;
  for (const auto& pair : pairs)
  {
    mean += std::stod(pair.at("label_accuracy")) / NumberOfPairs;
    worst = std::min(worst, std::stod(pair.at("label_accuracy")));
  }
  ASSERT_FALSE(summary.empty());
  EXPECT_EQ(summary.front().at("category"), "Creature");
  EXPECT_NEAR(std::stod(summary.front().at("label_accuracy")), mean, 1e-3);
  EXPECT_NEAR(std::stod(summary.front().at("label_accuracy_worst")), worst, 1e-3);
}

TEST_F(SegmentationBenchmark, SaysHowMuchOfATargetTheSourceHasLabelsFor)
{
  // The last mesh knows no label but 0 and 1.
  const std::string path = "data/labels/3.seg";
  std::istringstream before(this->Content(path));
  std::ofstream after(this->Folder / path);
  for (int label = 0; before >> label;)
  {
    after << std::min(label, 1) << "\n";
  }
  after.close();
  ASSERT_EQ(this->Run("results", "--quiet"), 0) << this->Content("stderr.txt");
  for (const auto& pair : this->Table("results/pairs.csv"))
  {
    const double possible = std::stod(pair.at("label_accuracy_possible"));
    EXPECT_GE(possible, std::stod(pair.at("label_accuracy")) - 1e-6);
    if (pair.at("source") == "3")
    {
      EXPECT_LT(possible, 0.95);
      EXPECT_GT(possible, 0.05);
    }
    else
    {
      EXPECT_NEAR(possible, 1.0, 1e-6);
    }
  }
}

TEST_F(SegmentationBenchmark, GoesOnWhereItWasStopped)
{
  ASSERT_EQ(this->Run("results", "--quiet"), 0) << this->Content("stderr.txt");
  const std::string whole = this->Content("results/pairs.csv");
  // What is there is kept: a changed value stays. The last row is cut off in its middle.
  std::string stopped = whole;
  const std::size_t value = stopped.find("\nCreature,1,2,") + 14;
  stopped.replace(value, stopped.find(',', value) - value, "0.123");
  stopped.resize(stopped.rfind("Creature,3,2,") + 20);
  std::ofstream(this->Folder / "results/pairs.csv") << stopped;
  ASSERT_EQ(this->Run("results", "--quiet"), 0) << this->Content("stderr.txt");
  const auto pairs = this->Table("results/pairs.csv");
  ASSERT_EQ(pairs.size(), NumberOfPairs);
  EXPECT_EQ(pairs.front().at("label_accuracy"), "0.123");
  EXPECT_GT(std::stod(pairs.back().at("label_accuracy")), 0.7);
  EXPECT_EQ(this->Content("stderr.txt"), "");
}

TEST_F(SegmentationBenchmark, MethodsAreNotMixed)
{
  ASSERT_EQ(this->Run("results", "--until skeleton"), 0) << this->Content("stderr.txt");
  EXPECT_EQ(this->Table("results/meshes.csv").size(), NumberOfMeshes);
  EXPECT_EQ(this->Table("results/pairs.csv").size(), 0u);
  EXPECT_NE(this->Run("results"), 0);
  EXPECT_NE(
    this->Content("stderr.txt").find("the results there are of another method"), std::string::npos)
    << this->Content("stderr.txt");
}

TEST_F(SegmentationBenchmark, NamesTheMatcherEverywhere)
{
  const std::string until = "--quiet --until correspondence ";
  ASSERT_EQ(this->Run("tree", until), 0) << this->Content("stderr.txt");
  ASSERT_EQ(this->Run("electors", until + "--matcher electors"), 0) << this->Content("stderr.txt");
  for (const std::string matcher : { "tree", "electors" })
  {
    const auto summary = this->Table(matcher + "/summary.csv");
    ASSERT_FALSE(summary.empty());
    for (const auto& row : summary)
    {
      EXPECT_EQ(row.at("skeleton"), "msp");
      EXPECT_EQ(row.at("matcher"), matcher);
    }
    EXPECT_EQ(std::stoi(summary.front().at("pairs")), NumberOfPairs);
    EXPECT_GT(std::stod(summary.front().at("coverage")), 0.5);
    EXPECT_NE(this->Content(matcher + "/method.txt").find("matcher " + matcher), std::string::npos);
  }
  EXPECT_NE(this->Content("stdout.txt").find("matcher electors"), std::string::npos);
  EXPECT_NE(this->Run("electors", until), 0);
  EXPECT_NE(this->Content("stderr.txt").find("matcher electors"), std::string::npos);
  EXPECT_NE(this->Run("other", until + "--matcher coin"), 0);
}

TEST_F(SegmentationBenchmark, ErrorsSayWhatIsWrong)
{
  EXPECT_NE(this->Run("results", "--category Unicorn"), 0);
  EXPECT_NE(
    this->Content("stderr.txt").find("Unicorn: there is no such category"), std::string::npos);
  // One bad mesh does not stop the others.
  std::ofstream(this->Folder / "data/labels/2.seg") << "1\n2\n";
  EXPECT_EQ(this->Run("results"), 0);
  int errors = 0;
  for (const auto& pair : this->Table("results/pairs.csv"))
  {
    errors += pair.at("error").find("2.seg: 2 integers for a mesh of") != std::string::npos;
  }
  EXPECT_EQ(errors, 4);
}

#ifdef MARROW_MPIEXEC
TEST_F(SegmentationBenchmark, RanksShareThePairs)
{
  ASSERT_EQ(this->Run("alone", "--quiet"), 0) << this->Content("stderr.txt");
  ASSERT_EQ(this->Run("shared", "--quiet --jobs 1", MARROW_MPIEXEC " -n 2 "), 0)
    << this->Content("stderr.txt");
  const auto alone = this->Table("alone/pairs.csv");
  const auto shared = this->Table("shared/pairs.csv");
  ASSERT_EQ(shared.size(), NumberOfPairs);
  for (std::size_t i = 0; i < shared.size(); ++i)
  {
    for (const char* column : { "source", "target", "label_accuracy", "rand_error", "gce" })
    {
      EXPECT_EQ(shared[i].at(column), alone[i].at(column)) << column;
    }
  }
  EXPECT_EQ(this->Table("shared/meshes.csv").size(), NumberOfMeshes);
  EXPECT_FALSE(fs::exists(this->Folder / "shared/pairs-1.csv"));
}
#endif
}
