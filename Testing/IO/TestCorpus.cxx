// SPDX-License-Identifier: BSD-3-Clause
// Files that are sound, odd or broken, made by hand or found by the fuzzers of Testing/Fuzz (in Found).
#include "MeshReading.h"
#include "vtkMarrowSegmentReader.h"

#include <filesystem>
#include <set>

using marrow::test::ErrorObserver;
using marrow::test::Read;
using marrow::test::Reading;

namespace
{
namespace fs = std::filesystem;

std::vector<fs::path> Files()
{
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(MARROW_TEST_DATA "/Corpus"))
  {
    if (entry.is_regular_file())
    {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The first error without what VTK puts before and behind it.
std::string SentenceOf(const std::string& messages)
{
  std::string sentence = messages.substr(0, messages.find("\n\n"));
  sentence.erase(0, sentence.find("): ") + 3);
  return sentence;
}

void ExpectOneSentence(const std::string& sentence, const fs::path& file)
{
  EXPECT_NE(sentence.find(file.filename().string()), std::string::npos) << sentence;
  EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  EXPECT_EQ(sentence.back(), '.') << sentence;
}
}

TEST(Corpus, EveryFileIsASoundMeshOrOneSentence)
{
  std::set<std::string> endings;
  for (const fs::path& file : Files())
  {
    endings.insert(file.extension().string());
    if (file.extension() == ".seg")
    {
      continue;
    }
    const Reading reading = Read(file.c_str());
    if (!reading.Messages.empty())
    {
      ExpectOneSentence(SentenceOf(reading.Messages), file);
      EXPECT_EQ(reading.Mesh->GetNumberOfPoints(), 0) << file;
      continue;
    }
    ASSERT_GT(reading.Mesh->GetNumberOfPolys(), 0) << file;
    EXPECT_EQ(reading.Mesh->GetNumberOfCells(), reading.Mesh->GetNumberOfPolys()) << file;
    for (vtkIdType cell = 0; cell < reading.Mesh->GetNumberOfCells(); ++cell)
    {
      for (const vtkIdType point : reading.Cell(cell))
      {
        ASSERT_TRUE(point >= 0 && point < reading.Mesh->GetNumberOfPoints()) << file;
      }
    }
  }
  EXPECT_EQ(
    endings, (std::set<std::string>{ ".obj", ".off", ".ply", ".seg", ".stl", ".vtk", ".vtp" }));
}

TEST(Corpus, OneCubeInEveryFormatIsOneMesh)
{
  const Reading cube = Read(MARROW_TEST_DATA "/Corpus/cube.off");
  for (const char* name : { "cube-crlf.off", "cube-binary.off", "cube.ply", "cube-no-newline.ply",
         "cube-little-endian.ply", "cube-big-endian.ply", "cube.obj" })
  {
    const Reading other = Read((std::string(MARROW_TEST_DATA "/Corpus/") + name).c_str());
    EXPECT_EQ(other.Messages, "") << name;
    ASSERT_EQ(other.Mesh->GetNumberOfPoints(), 8) << name;
    ASSERT_EQ(other.Mesh->GetNumberOfPolys(), 6) << name;
    for (vtkIdType i = 0; i < 8; ++i)
    {
      EXPECT_EQ(other.Mesh->GetPoint(i)[0], cube.Mesh->GetPoint(i)[0]) << name;
    }
    for (vtkIdType i = 0; i < 6; ++i)
    {
      EXPECT_EQ(other.Cell(i), cube.Cell(i)) << name;
    }
  }
}

TEST(Corpus, SegmentFilesAreReadOrOneSentence)
{
  // One triangle: a file of one label fits.
  const Reading triangle = Read(MARROW_TEST_DATA "/Corpus/triangle.vtp");
  for (const fs::path& file : Files())
  {
    if (file.extension() != ".seg")
    {
      continue;
    }
    vtkNew<vtkMarrowSegmentReader> reader;
    const ErrorObserver errors(reader);
    reader->SetInputData(triangle.Mesh);
    reader->SetFileName(file.c_str());
    reader->Update();
    if (!errors.Text().empty())
    {
      ExpectOneSentence(SentenceOf(errors.Text()), file);
      continue;
    }
    vtkDataArray* segments = reader->GetOutput()->GetCellData()->GetArray("SegmentId");
    ASSERT_NE(segments, nullptr) << file;
    EXPECT_EQ(segments->GetNumberOfTuples(), 1) << file;
  }
}
