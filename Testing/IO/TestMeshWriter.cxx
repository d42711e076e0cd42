// SPDX-License-Identifier: BSD-3-Clause
#include "MeshBridge.h"
#include "MeshReading.h"
#include "TestMeshes.h"
#include "vtkMarrowMeshWriter.h"
#include "vtkMarrowSegmentSelector.h"

#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>

#include <filesystem>

using namespace marrow::test;

namespace
{
/// Polygons of 0 to 5 corners, one of them twice, at coordinates that a float does not hold.
vtkSmartPointer<vtkPolyData> Polygons(const std::vector<int>& segments)
{
  const Reading reading = ReadText("polygons.off",
    "OFF\n5 7 0\n0.1 0.3333333333333333 4512345.678901\n1e-300 -0.0 1\n4 4 0\n0 4 1e22\n1 2 0\n"
    "3 0 1 2\n5 0 1 2 3 4\n2 0 1\n1 3\n3 2 2 0\n3 0 1 2\n4 3 2 1 0\n");
  EXPECT_EQ(reading.Messages, "");
  if (!segments.empty())
  {
    marrow::SetIntArray(reading.Mesh->GetCellData(), "SegmentId", segments);
  }
  return reading.Mesh;
}

std::string Write(vtkPolyData* mesh, const std::string& name)
{
  vtkNew<vtkMarrowMeshWriter> writer;
  const ErrorObserver errors(writer);
  writer->SetInputData(mesh);
  writer->SetFileName(name.c_str());
  const bool isWritten = writer->Write() == 1;
  EXPECT_EQ(isWritten, errors.Text().empty());
  return errors.Text();
}

std::vector<int> SegmentsOf(vtkPolyData* mesh, const char* labels)
{
  vtkNew<vtkMarrowSegmentSelector> selector;
  selector->SetInputData(mesh);
  selector->SetLabels(labels);
  selector->Update();
  std::vector<int> segments;
  marrow::GetArray(selector->GetOutput()->GetCellData(), "SegmentId",
    static_cast<int>(mesh->GetNumberOfCells()), segments);
  return segments;
}

const std::vector<int> Segments{ 3, 0, 23, 3, 7, 5, 5 };
}

TEST(MeshWriter, WhatIsWrittenIsReadToTheLastBit)
{
  const auto mesh = Polygons(Segments);
  for (const auto& [ending, labels] :
    { std::pair<const char*, const char*>{ ".off", "colors" }, { ".ply", "SegmentId" },
      { ".obj", "groups" }, { ".vtp", "SegmentId" }, { ".vtk", "SegmentId" } })
  {
    const TemporaryFile file(ending);
    EXPECT_EQ(Write(mesh, file.Name()), "") << ending;
    const Reading reading = Read(file.Name());
    EXPECT_EQ(reading.Messages, "");
    ASSERT_EQ(reading.Mesh->GetNumberOfPoints(), 5) << ending;
    ASSERT_EQ(reading.Mesh->GetNumberOfPolys(), 7) << ending;
    for (vtkIdType i = 0; i < 5; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_EQ(reading.Mesh->GetPoint(i)[axis], mesh->GetPoint(i)[axis]) << ending << i;
      }
    }
    const Reading given{ mesh, {} };
    for (vtkIdType cell = 0; cell < 7; ++cell)
    {
      EXPECT_EQ(reading.Cell(cell), given.Cell(cell)) << ending << cell;
    }
    EXPECT_EQ(SegmentsOf(reading.Mesh, labels), Segments) << ending;
  }
}

TEST(MeshWriter, NamesOfSegmentsComeBack)
{
  auto mesh = Polygons({ 0, 1, 2, 0, 1, 2, 2 });
  vtkNew<vtkStringArray> names;
  names->SetName("SegmentName");
  for (const char* name : { "#ff0000", "left arm" })
  {
    names->InsertNextValue(name);
  }
  mesh->GetFieldData()->AddArray(names);
  const TemporaryFile obj(".obj");
  EXPECT_EQ(Write(mesh, obj.Name()), "");
  EXPECT_NE(obj.Text().find("g left arm\n"), std::string::npos);
  EXPECT_NE(obj.Text().find("g segment_2\n"), std::string::npos);
  const TemporaryFile off(".off");
  EXPECT_EQ(Write(mesh, off.Name()), "");
  EXPECT_NE(off.Text().find("3 0 1 2 255 0 0\n"), std::string::npos);
}

TEST(MeshWriter, NoTwoSegmentsHaveOneColor)
{
  std::vector<int> many{ 0, 24, 48, -1, -2, 1, 25 };
  const TemporaryFile off(".off");
  EXPECT_EQ(Write(Polygons(many), off.Name()), "");
  std::vector<int> read = SegmentsOf(Read(off.Name()).Mesh, "colors");
  std::sort(read.begin(), read.end());
  EXPECT_EQ(std::unique(read.begin(), read.end()) - read.begin(), 7);
}

TEST(MeshWriter, SaysWhatIsWrongAndLeavesNoPartOfAFile)
{
  const auto contains = [](const std::string& text, const char* part)
  { return text.find(part) != std::string::npos; };
  const auto mesh = Polygons(Segments);
  EXPECT_TRUE(contains(Write(mesh, "mesh.abc"), "must end in .off, .ply, .obj, .vtp or .vtk"));
  EXPECT_TRUE(contains(Write(mesh, "/nowhere/mesh.off"), "No such file or directory"));
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  lines->ShallowCopy(mesh);
  lines->SetLines(mesh->GetPolys());
  EXPECT_TRUE(contains(Write(lines, "mesh.off"), "cells that are no polygons"));

  // A folder with a file in it, and a disk without space.
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(::testing::TempDir()) / "marrow_full_disk";
  fs::remove_all(folder);
  fs::create_directories(folder / "taken.off");
  for (const char* ending : { ".off", ".ply", ".obj", ".vtp", ".vtk" })
  {
    fs::create_symlink("/dev/full", folder / (std::string("full") + ending));
    EXPECT_TRUE(contains(
      Write(mesh, (folder / (std::string("full") + ending)).string()), "No space left on device"))
      << ending;
  }
  EXPECT_NE(Write(mesh, (folder / "taken.off").string()), "");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 6);
  fs::remove_all(folder);
}

TEST(MeshWriter, ALinkStaysOneAndItsFileChanges)
{
  namespace fs = std::filesystem;
  const TemporaryFile file(".off", "old");
  const fs::path link = std::string(file.Name()) + ".link.off";
  fs::remove(link);
  fs::create_symlink(file.Name(), link);
  EXPECT_EQ(Write(Polygons({}), link.string()), "");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(file.Text().substr(0, 4), "OFF\n");
  fs::remove(link);
}
