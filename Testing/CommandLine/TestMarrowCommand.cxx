// SPDX-License-Identifier: BSD-3-Clause
// The marrow command as a user meets it: files in, files out, exit codes and what it says.
#include <vtkCellData.h>
#include <vtkCreatureSource.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMarrowMeshWriter.h>
#include <vtkMarrowSegmentWriter.h>
#include <vtkNew.h>
#include <vtkOBJWriter.h>
#include <vtkPLYWriter.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSTLWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace fs = std::filesystem;

namespace
{
struct Outcome
{
  int ExitCode;
  std::string Out;
  std::string Error;
};

std::string Content(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

/// Every test works in a folder of its own, so that tests may run at the same time.
class MarrowCommand : public testing::Test
{
protected:
  void SetUp() override
  {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    this->Folder = fs::path(MARROW_TEST_OUTPUT) / test->name();
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
  }

  Outcome Run(const std::string& arguments) const
  {
    const std::string command = "cd '" + this->Folder.string() + "' && '" MARROW_COMMAND "' " +
      arguments + " >stdout.txt 2>stderr.txt";
    const int status = std::system(command.c_str());
    return { WIFEXITED(status) ? WEXITSTATUS(status) : -1, Content(this->Folder / "stdout.txt"),
      Content(this->Folder / "stderr.txt") };
  }

  void ExpectSuccess(const std::string& arguments) const
  {
    // Warnings are the filters' and no matter of these tests.
    const Outcome outcome = this->Run("--quiet " + arguments);
    EXPECT_EQ(outcome.ExitCode, 0) << arguments;
    EXPECT_EQ(outcome.Error, "") << arguments;
  }

  /// An error is one line on stderr that begins with the program's name and tells what is wrong.
  void ExpectError(const std::string& arguments, const std::string& part) const
  {
    const Outcome outcome = this->Run(arguments);
    EXPECT_GT(outcome.ExitCode, 0) << arguments;
    EXPECT_EQ(std::count(outcome.Error.begin(), outcome.Error.end(), '\n'), 1) << outcome.Error;
    EXPECT_EQ(outcome.Error.rfind("marrow: ", 0), 0u) << outcome.Error;
    EXPECT_NE(outcome.Error.find(part), std::string::npos)
      << "'" << part << "' expected in: " << outcome.Error;
  }

  static vtkSmartPointer<vtkPolyData> Creature(int seed, int resolution = 2500)
  {
    vtkNew<vtkCreatureSource> creature;
    creature->SetResolution(resolution);
    creature->SetSeed(seed);
    creature->SetPose(seed == 1 ? 0.0 : 0.3);
    creature->Update();
    return creature->GetOutput();
  }

  template <typename Writer>
  void Write(vtkPolyData* mesh, const std::string& name) const
  {
    vtkNew<Writer> writer;
    writer->SetInputData(mesh);
    writer->SetFileName((this->Folder / name).c_str());
    writer->Write();
  }

  void WriteOFF(vtkPolyData* mesh, const std::string& name) const
  {
    std::ofstream file(this->Folder / name);
    file << "OFF\n" << mesh->GetNumberOfPoints() << " " << mesh->GetNumberOfCells() << " 0\n";
    file.precision(17);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const double* p = mesh->GetPoint(i);
      file << p[0] << " " << p[1] << " " << p[2] << "\n";
    }
    mesh->BuildCells();
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      mesh->GetCellPoints(cell, size, ids);
      file << "3 " << ids[0] << " " << ids[1] << " " << ids[2] << "\n";
    }
  }

  void WriteText(const std::string& name, const std::string& text) const
  {
    std::ofstream(this->Folder / name) << text;
  }

  vtkSmartPointer<vtkPolyData> Read(const std::string& name) const
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName((this->Folder / name).c_str());
    reader->Update();
    return reader->GetOutput();
  }

  fs::path Folder;
};
}

std::vector<int> SegmentsOf(vtkPolyData* mesh)
{
  vtkDataArray* array = mesh->GetCellData()->GetArray("SegmentId");
  std::vector<int> segments;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    segments.push_back(static_cast<int>(array->GetTuple1(i)));
  }
  return segments;
}

/// The lowest point of a segment: of a leg, the foot.
vtkIdType PointOfSegment(vtkPolyData* mesh, const std::vector<int>& segments, int segment)
{
  vtkIdType lowest = -1;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const vtkIdType point = mesh->GetCell(static_cast<vtkIdType>(i))->GetPointId(0);
    if (segments[i] == segment &&
      (lowest < 0 || mesh->GetPoint(point)[1] < mesh->GetPoint(lowest)[1]))
    {
      lowest = point;
    }
  }
  return lowest;
}

TEST_F(MarrowCommand, EverySubcommandHasHelpWithAnExample)
{
  for (const std::string command :
    { "measure", "skeleton", "correspond", "transfer", "collection", "render" })
  {
    const Outcome outcome = this->Run(command + " --help");
    EXPECT_EQ(outcome.ExitCode, 0);
    EXPECT_NE(outcome.Out.find("  marrow " + command + " "), std::string::npos) << outcome.Out;
  }
}

TEST_F(MarrowCommand, MeasureReadsEveryFormatAndKeepsTheMesh)
{
  const vtkSmartPointer<vtkPolyData> mesh = Creature(1);
  this->WriteOFF(mesh, "mesh.off");
  this->Write<vtkPLYWriter>(mesh, "mesh.ply");
  this->Write<vtkOBJWriter>(mesh, "mesh.obj");
  this->Write<vtkSTLWriter>(mesh, "mesh.stl");
  this->Write<vtkXMLPolyDataWriter>(mesh, "mesh.vtp");
  this->Write<vtkPolyDataWriter>(mesh, "mesh.vtk");
  for (const std::string extension : { "off", "ply", "obj", "stl", "vtp", "vtk" })
  {
    const std::string output = extension + "_out.vtp";
    this->ExpectSuccess(
      std::string("measure mesh.").append(extension).append(" -o ").append(output));
    const vtkSmartPointer<vtkPolyData> result = this->Read(output);
    // STL files repeat every point for each of its triangles: merged, they are as many as before.
    EXPECT_EQ(result->GetNumberOfPoints(), mesh->GetNumberOfPoints()) << extension;
    EXPECT_EQ(result->GetNumberOfCells(), mesh->GetNumberOfCells()) << extension;
    for (const char* name : { "AGD", "MSP", "MSPCenter", "MSPNormal", "MSPGradient", "MSPValid" })
    {
      EXPECT_TRUE(result->GetPointData()->HasArray(name)) << extension << " " << name;
    }
  }
  // The arrays of the file are kept.
  EXPECT_TRUE(this->Read("vtp_out.vtp")->GetCellData()->HasArray("SegmentId"));
}

TEST_F(MarrowCommand, SkeletonWritesTheSkeletonAndTheMesh)
{
  const vtkSmartPointer<vtkPolyData> mesh = Creature(1);
  this->WriteOFF(mesh, "mesh.off");
  this->ExpectSuccess("skeleton mesh.off -o skeleton.vtp --mesh mesh.vtp");
  const vtkSmartPointer<vtkPolyData> skeleton = this->Read("skeleton.vtp");
  EXPECT_GT(skeleton->GetNumberOfLines(), 0);
  EXPECT_TRUE(skeleton->GetPointData()->HasArray("NodeType"));
  const vtkSmartPointer<vtkPolyData> measured = this->Read("mesh.vtp");
  vtkDataArray* nodes = measured->GetPointData()->GetArray("SkeletonNodeId");
  ASSERT_NE(nodes, nullptr);
  EXPECT_EQ(nodes->GetRange()[1] + 1, skeleton->GetNumberOfPoints());
}

TEST_F(MarrowCommand, CorrespondWritesOneRowPerMatch)
{
  this->WriteOFF(Creature(1), "source.off");
  this->WriteOFF(Creature(2), "target.off");
  this->ExpectSuccess("correspond source.off target.off -o pairs.csv");
  std::istringstream table(Content(this->Folder / "pairs.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "Kind,CorrespondenceId,Source,Target");
  int nodes = 0;
  int branches = 0;
  while (std::getline(table, line))
  {
    nodes += line.rfind("node,", 0) == 0 ? 1 : 0;
    branches += line.rfind("branch,", 0) == 0 ? 1 : 0;
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 3) << line;
    EXPECT_NE(line.back(), ',') << "a match without a partner: " << line;
  }
  // A quadruped's six extremities and their branches match, and at least one junction.
  EXPECT_GE(nodes, 7);
  EXPECT_GE(branches, 6);
}

TEST_F(MarrowCommand, CorrespondHasTwoMatchers)
{
  this->WriteOFF(Creature(1), "source.off");
  this->WriteOFF(Creature(2), "target.off");
  this->ExpectSuccess("correspond source.off target.off -o tree.csv --matcher tree");
  this->ExpectSuccess("correspond source.off target.off -o default.csv");
  EXPECT_EQ(Content(this->Folder / "tree.csv"), Content(this->Folder / "default.csv"));
  this->ExpectSuccess("correspond source.off target.off -o electors.csv --matcher electors");
  std::istringstream table(Content(this->Folder / "electors.csv"));
  int nodes = 0;
  for (std::string line; std::getline(table, line);)
  {
    nodes += line.rfind("node,", 0) == 0 ? 1 : 0;
    // One to one: no lists of merged nodes.
    EXPECT_TRUE(line.rfind("node,", 0) != 0 || line.find(' ') == std::string::npos) << line;
  }
  EXPECT_GE(nodes, 5);
}

TEST_F(MarrowCommand, TransferToOneTargetWritesAFile)
{
  this->WriteOFF(Creature(1), "source.off");
  this->WriteOFF(Creature(2), "target.off");
  this->Write<vtkMarrowSegmentWriter>(Creature(1), "source.seg");
  this->ExpectSuccess("transfer source.off target.off --segments source.seg -o out.seg");
  this->ExpectSuccess("transfer source.off target.off --segments source.seg -o out.vtp");
  const vtkSmartPointer<vtkPolyData> labelled = this->Read("out.vtp");
  vtkDataArray* labels = labelled->GetCellData()->GetArray("SegmentId");
  ASSERT_NE(labels, nullptr);
  std::istringstream seg(Content(this->Folder / "out.seg"));
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    int label = -1;
    ASSERT_TRUE(seg >> label) << "line " << i;
    ASSERT_EQ(label, labels->GetTuple1(i)) << "face " << i;
  }
}

TEST_F(MarrowCommand, TransferTakesTheUsersWord)
{
  this->Write<vtkXMLPolyDataWriter>(Creature(1), "source.vtp");
  this->WriteOFF(Creature(2), "target.off");
  this->ExpectSuccess("transfer source.vtp target.off -o plain.seg");
  const std::string plain = Content(this->Folder / "plain.seg");
  this->ExpectSuccess("transfer source.vtp target.off -o second.seg --answer 1");
  EXPECT_NE(Content(this->Folder / "second.seg"), plain);
  this->ExpectError("transfer source.vtp target.off -o out.seg --answer 1000",
    "AnswerIndex is 1000, but the number of answers is");

  this->ExpectError("transfer source.vtp target.off -o out.seg --hint 1000000:1",
    "source.vtp: it has no point 1000000, only 0 to");
  this->ExpectError(
    "correspond source.vtp target.off -o out.csv --hint 1:1000000", "target.off: it has no point");
  this->ExpectError(
    "transfer source.vtp target.off -o out.seg --forbid 10-1", "is not SOURCE:TARGET");

  // What the plain result says is true of all but the first leg, which must not be itself.
  std::istringstream labels(plain);
  std::vector<int> ofFace;
  for (int label; labels >> label;)
  {
    ofFace.push_back(label);
  }
  const int leg = 5;
  const vtkIdType there = PointOfSegment(Creature(1), SegmentsOf(Creature(1)), leg);
  const vtkIdType here = PointOfSegment(Creature(2), ofFace, leg);
  const std::string pair = std::to_string(there) + ":" + std::to_string(here);
  this->ExpectSuccess("transfer source.vtp target.off -o hinted.seg --hint " + pair);
  EXPECT_EQ(Content(this->Folder / "hinted.seg"), plain);
  this->ExpectSuccess("transfer source.vtp target.off -o forbidden.seg --forbid " + pair);
  EXPECT_NE(Content(this->Folder / "forbidden.seg"), plain);
  this->ExpectSuccess("correspond source.vtp target.off -o forbidden.csv --forbid " + pair);
  this->ExpectSuccess("correspond source.vtp target.off -o plain.csv");
  EXPECT_NE(Content(this->Folder / "forbidden.csv"), Content(this->Folder / "plain.csv"));

  // Only one segment; then, with the target's own beside it, that stays and the rest is filled in.
  this->ExpectSuccess("transfer source.vtp target.off -o target.seg --only 5");
  std::istringstream only(Content(this->Folder / "target.seg"));
  for (std::size_t i = 0; i < ofFace.size(); ++i)
  {
    int label = 0;
    ASSERT_TRUE(only >> label);
    ASSERT_EQ(label, ofFace[i] == leg ? leg : -1) << "face " << i;
  }
  this->ExpectSuccess("transfer source.vtp target.off -o filled.seg --keep");
  EXPECT_EQ(Content(this->Folder / "filled.seg"), plain);
}

TEST_F(MarrowCommand, TransferCutsTheFacesAlongBoundaries)
{
  this->Write<vtkXMLPolyDataWriter>(Creature(1), "source.vtp");
  this->WriteOFF(Creature(2), "target.off");
  this->ExpectSuccess("transfer source.vtp target.off -o whole.vtp");
  this->ExpectSuccess("transfer source.vtp target.off -o cut.vtp --cut");
  const vtkSmartPointer<vtkPolyData> cut = this->Read("cut.vtp");
  EXPECT_GT(cut->GetNumberOfCells(), this->Read("whole.vtp")->GetNumberOfCells());
  EXPECT_TRUE(cut->GetCellData()->HasArray("vtkOriginalCellIds"));
  this->ExpectError("transfer source.vtp target.off -o cut.seg --cut",
    "cut.seg: a .seg file is of the target's own faces");
}

TEST_F(MarrowCommand, TransferToSeveralTargetsFillsAFolder)
{
  // The labels come with the source's own array.
  this->Write<vtkXMLPolyDataWriter>(Creature(1), "source.vtp");
  this->WriteOFF(Creature(2), "one.off");
  this->WriteOFF(Creature(3), "two.off");
  this->ExpectSuccess("transfer source.vtp one.off two.off -o labelled --skeletons");
  for (const char* name : { "one.vtp", "two.vtp" })
  {
    EXPECT_TRUE(this->Read(std::string("labelled/") + name)->GetCellData()->HasArray("SegmentId"));
  }
  for (const char* name : { "source_skeleton.vtp", "one_skeleton.vtp", "two_skeleton.vtp" })
  {
    EXPECT_GT(this->Read(std::string("labelled/") + name)->GetNumberOfLines(), 0);
  }
  this->ExpectSuccess("transfer source.vtp one.off two.off -o labels --format seg");
  EXPECT_TRUE(fs::exists(this->Folder / "labels/one.seg"));
  EXPECT_TRUE(fs::exists(this->Folder / "labels/two.seg"));
}

TEST_F(MarrowCommand, TransferWritesSegmentsInEveryFormat)
{
  this->Write<vtkXMLPolyDataWriter>(Creature(1), "source.vtp");
  this->WriteOFF(Creature(2), "target.off");
  this->ExpectSuccess("transfer source.vtp target.off -o target.seg");
  for (const auto& [format, labels] : { std::pair<std::string, std::string>{ "ply", "SegmentId" },
         { "obj", "groups" }, { "off", "colors" }, { "vtk", "SegmentId" } })
  {
    this->ExpectSuccess(std::string("transfer source.vtp target.off -o ")
                          .append(format)
                          .append(" --format ")
                          .append(format));
    const Outcome outcome = this->Run(std::string("evaluate target.off --segments ")
                                        .append(format)
                                        .append("/target.")
                                        .append(format)
                                        .append(" --labels ")
                                        .append(labels)
                                        .append(" --reference target.seg --csv"));
    EXPECT_NE(outcome.Out.find("target.seg,0,0,0,0,0,0,0,1,0"), std::string::npos)
      << format << outcome.Out << outcome.Error;
  }
}

TEST_F(MarrowCommand, NamesOfGroupsAreThoseOfTheSource)
{
  const vtkSmartPointer<vtkPolyData> mesh = Creature(1);
  this->Write<vtkMarrowMeshWriter>(mesh, "numbered.obj");
  this->WriteOFF(Creature(2), "target.off");
  std::string text = Content(this->Folder / "numbered.obj");
  for (std::size_t at = text.find("segment_"); at != std::string::npos;
       at = text.find("segment_", at))
  {
    text.replace(at, 8, "upper part");
  }
  this->WriteText("named.obj", text);
  this->ExpectSuccess("transfer named.obj target.off --labels groups -o named_target.obj");
  this->ExpectSuccess("transfer numbered.obj target.off --labels groups -o target.seg");
  const std::string written = Content(this->Folder / "named_target.obj");
  EXPECT_NE(written.find("g upper part0\n"), std::string::npos);
  EXPECT_EQ(written.find("segment_"), std::string::npos);
  const Outcome outcome =
    this->Run("evaluate named_target.obj --labels groups --reference target.seg --csv");
  EXPECT_NE(outcome.Out.find("target.seg,0,0,0,0,0,0,0,1,0"), std::string::npos) << outcome.Out;
}

TEST_F(MarrowCommand, TransferTakesTheLabelsOfAnotherFile)
{
  const vtkSmartPointer<vtkPolyData> mesh = Creature(1);
  this->WriteOFF(mesh, "source.off");
  this->WriteOFF(Creature(2), "target.off");
  this->Write<vtkXMLPolyDataWriter>(mesh, "source.vtp");
  mesh->GetCellData()->GetArray("SegmentId")->SetName("part");
  this->Write<vtkPolyDataWriter>(mesh, "labels.vtk");
  this->ExpectSuccess("transfer source.vtp target.off -o one.seg");
  this->ExpectSuccess(
    "transfer source.off target.off --segments labels.vtk --labels part -o two.seg");
  EXPECT_EQ(Content(this->Folder / "one.seg"), Content(this->Folder / "two.seg"));
  this->ExpectError("transfer labels.vtk target.off -o out.seg",
    "labels.vtk: the mesh has no labels \"SegmentId\"; it has \"part\", ");
  this->WriteText("large.ply",
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 1\nproperty list uchar int vertex_indices\nproperty int64 part\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 4294967296\n");
  this->ExpectError("transfer large.ply target.off --labels part -o out.seg",
    "large.ply: the array \"part\" of segments is 4294967296 at cell 0, beyond the range");
  this->ExpectError("transfer source.off target.off --segments large.ply --labels part -o out.seg",
    "large.ply: the array");
}

TEST_F(MarrowCommand, OneBadTargetOfManyDoesNotStopTheOthers)
{
  this->Write<vtkXMLPolyDataWriter>(Creature(1), "source.vtp");
  this->WriteOFF(Creature(2), "good.off");
  this->WriteText("bad.off", "OFF\n3 1 0\n0 0 0\n");
  const Outcome outcome =
    this->Run("--quiet transfer source.vtp bad.off absent.ply good.off -o out");
  EXPECT_EQ(outcome.ExitCode, 1);
  std::istringstream lines(outcome.Error);
  std::string line;
  std::getline(lines, line);
  EXPECT_NE(line.find("\"bad.off\" is not a valid OFF file: it ends after 1 of 3 vertices."),
    std::string::npos)
    << line;
  std::getline(lines, line);
  EXPECT_NE(line.find("Cannot read \"absent.ply\": No such file"), std::string::npos) << line;
  std::getline(lines, line);
  EXPECT_EQ(line, "marrow: 1 of 3 done; 2 failed: bad.off, absent.ply");
  EXPECT_FALSE(std::getline(lines, line)) << line;
  EXPECT_TRUE(this->Read("out/good.vtp")->GetCellData()->HasArray("SegmentId"));
  EXPECT_FALSE(fs::exists(this->Folder / "out/bad.vtp"));
}

TEST_F(MarrowCommand, OutputsAreCheckedBeforeAnythingIsComputed)
{
  // The source would be an error too, but only after the outputs.
  fs::create_directories(this->Folder / "out/one.vtp");
  this->ExpectError(
    "transfer absent.off one.off two.off -o out", "one.vtp: the file cannot be written");
  this->ExpectError("transfer absent.off one.off one_skeleton.off -o new --skeletons",
    "would both be written to new/one_skeleton.vtp");
  this->WriteText("file", "");
  this->ExpectError(
    "transfer absent.off one.off two.off -o file", "file: the folder cannot be made");
  for (const std::string command : { "measure absent.off -o ", "skeleton absent.off -o ",
         "correspond absent.off absent.off -o absent/" })
  {
    this->ExpectError(
      command + "absent/x.vtp", command[0] == 'c' ? ".csv" : "there is no folder absent");
  }
}

TEST_F(MarrowCommand, AFullDiskIsAnErrorEverywhere)
{
  this->Write<vtkXMLPolyDataWriter>(Creature(1), "source.vtp");
  this->WriteOFF(Creature(2), "target.off");
  for (const char* ending : { ".vtp", ".vtk", ".ply", ".obj", ".off", ".seg", ".csv", ".png" })
  {
    fs::create_symlink("/dev/full", this->Folder / (std::string("full") + ending));
  }
  for (const std::string ending : { "vtp", "vtk", "ply", "obj", "off", "seg" })
  {
    this->ExpectError("--quiet transfer source.vtp target.off -o full." + ending, "No space left");
  }
  this->ExpectError("--quiet measure target.off -o full.vtp", "No space left");
  this->ExpectError("--quiet skeleton target.off -o full.vtk", "No space left");
  this->ExpectError("--quiet correspond source.vtp target.off -o full.csv", "No space left");
  this->ExpectError("--quiet render target.off --tile 60 40 -o full.png", "full.png");
  this->WriteText(
    "run.sh", "'" MARROW_COMMAND "' evaluate source.vtp --reference source.vtp > /dev/full\n");
  const int status =
    std::system(("cd '" + this->Folder.string() + "' && sh run.sh 2>stderr.txt").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_NE(Content(this->Folder / "stderr.txt").find("standard output"), std::string::npos);
}

TEST_F(MarrowCommand, ThreadsDoNotChangeTheResult)
{
  this->Write<vtkXMLPolyDataWriter>(Creature(1), "source.vtp");
  this->WriteOFF(Creature(2), "target.off");
  this->ExpectSuccess("--threads 1 transfer source.vtp target.off -o one.seg");
  this->ExpectSuccess("transfer source.vtp target.off -o two.seg --threads 2");
  EXPECT_EQ(Content(this->Folder / "one.seg"), Content(this->Folder / "two.seg"));
}

TEST_F(MarrowCommand, RenderWritesAPictureOfTheTilesSize)
{
  this->Write<vtkXMLPolyDataWriter>(Creature(1), "one.vtp");
  this->Write<vtkXMLPolyDataWriter>(Creature(2), "two.vtp");
  this->ExpectSuccess("render one.vtp two.vtp two.vtp --columns 2 --tile 60 40 -o picture.png");
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((this->Folder / "picture.png").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[0], 120);
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[1], 80);
  this->ExpectError(
    "render one.vtp --skeletons one.vtp two.vtp -o picture.png", "there are 2 for 1 meshes");
}

TEST_F(MarrowCommand, RenderShowsMeasuresAndMatches)
{
  this->WriteOFF(Creature(1), "one.off");
  this->WriteOFF(Creature(2), "two.off");
  this->ExpectSuccess("measure one.off -o one.vtp");
  this->ExpectSuccess("render one.vtp --color-by AGD MSP --tile 60 40 -o measures.png");
  this->ExpectSuccess("correspond one.off two.off -o pairs.csv --skeletons first.vtp second.vtp");
  EXPECT_TRUE(this->Read("first.vtp")->GetPointData()->HasArray("CorrespondenceId"));
  this->ExpectSuccess("render one.off two.off --skeletons first.vtp second.vtp --matches --tile 60 "
                      "40 -o matches.png");
  for (const char* name : { "measures.png", "matches.png" })
  {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName((this->Folder / name).c_str());
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetDimensions()[0], 120) << name;
  }
  this->ExpectError("render one.vtp --color-by Absent -o out.png", "array Absent");
  this->ExpectError("render one.vtp --matches -o out.png", "--matches");
}

TEST_F(MarrowCommand, ErrorsOfArgumentsAndFilesAreOneSentence)
{
  const vtkSmartPointer<vtkPolyData> mesh = Creature(1);
  this->WriteOFF(mesh, "mesh.off");
  this->Write<vtkXMLPolyDataWriter>(mesh, "labelled.vtp");
  fs::create_directories(this->Folder / "other");
  this->WriteOFF(mesh, "other/mesh.off");

  this->ExpectError("", "subcommand");
  this->ExpectError("measure mesh.off", "--output is required");
  this->ExpectError("measure absent.off -o out.vtp", "Cannot read \"absent.off\": No such file");
  this->ExpectError("measure mesh.abc -o out.vtp", "must end in .off, .ply, .obj, .stl, .vtp, ");
  this->ExpectError("measure mesh.off -o out.ply", "out.ply: the name must end in .vtp or .vtk");
  this->ExpectError("measure mesh.off -o absent/out.vtp", "there is no folder absent");
  this->ExpectError("measure mesh.off -o out.vtp --threads 0", "--threads");
  this->ExpectError("transfer mesh.off mesh.off -o out.seg", "no labels \"SegmentId\"");
  this->ExpectError("transfer labelled.vtp mesh.off other/mesh.off -o out",
    "would both be written to out/mesh.vtp");
  this->ExpectError("render mesh.off -o out.jpg", "must end in .png");
}

TEST_F(MarrowCommand, ErrorsOfFiltersAndReadersAreOneSentence)
{
  this->WriteText("broken.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
  this->WriteText("empty.off", "OFF\n0 0 0\n");
  this->WriteText("broken.vtp", "<VTKFile type=\"PolyData\"");
  this->ExpectError("measure broken.off -o out.vtp", "broken.off");
  this->ExpectError("measure empty.off -o out.vtp", "empty.off");
  this->ExpectError("measure broken.vtp -o out.vtp", "broken.vtp");
  EXPECT_FALSE(fs::exists(this->Folder / "out.vtp"));

  const vtkSmartPointer<vtkPolyData> mesh = Creature(1);
  this->WriteOFF(mesh, "mesh.off");
  this->WriteText("short.seg", "1\n2\n3\n");
  this->ExpectError("transfer mesh.off mesh.off --segments short.seg -o out.seg", "short.seg");
}

TEST_F(MarrowCommand, WithoutDisplayRenderSaysSoInsteadOfAborting)
{
  this->WriteOFF(Creature(1), "mesh.off");
  ASSERT_EQ(unsetenv("DISPLAY"), 0);
  this->ExpectError("render mesh.off -o out.png", "no X display");
  ASSERT_EQ(setenv("DISPLAY", ":987", 1), 0);
  this->ExpectError("render mesh.off -o out.png", "no X display");
}
