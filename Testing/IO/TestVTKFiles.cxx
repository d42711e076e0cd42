// SPDX-License-Identifier: BSD-3-Clause
#include "MeshReading.h"

#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <fstream>

using marrow::test::Read;
using marrow::test::Reading;
using marrow::test::ReadText;
using marrow::test::TemporaryFile;

namespace
{
using Ids = std::vector<vtkIdType>;
using Values = std::vector<double>;

const std::string Legacy = "# vtk DataFile Version 3.0\nmade by hand\nASCII\n";
const std::string Square = "POINTS 4 float\n0 0 0 1 0 0 1 1 0 0 1 0\n";

/// A line, a quad, a pixel, a strip of two triangles and a quadratic triangle, each with its number.
vtkSmartPointer<vtkUnstructuredGrid> MixedGrid()
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 9; ++i)
  {
    const int row = i / 3;
    points->InsertNextPoint(i % 3, row, 0.0);
  }
  grid->SetPoints(points);
  const std::pair<int, Ids> cells[] = { { VTK_LINE, { 0, 1 } }, { VTK_QUAD, { 0, 1, 4, 3 } },
    { VTK_PIXEL, { 1, 2, 4, 5 } }, { VTK_TRIANGLE_STRIP, { 3, 4, 6, 7 } },
    { VTK_QUADRATIC_TRIANGLE, { 4, 8, 6, 5, 7, 3 } } };
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (const auto& [type, ids] : cells)
  {
    grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
    numbers->InsertNextValue(static_cast<int>(numbers->GetNumberOfValues()));
  }
  grid->GetCellData()->AddArray(numbers);
  return grid;
}

void ExpectMixedSurface(const Reading& reading)
{
  EXPECT_EQ(reading.Messages, "");
  ASSERT_EQ(reading.Mesh->GetNumberOfCells(), 5);
  ASSERT_EQ(reading.Mesh->GetNumberOfPolys(), 5);
  const Ids cells[] = { { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 3, 4, 6 }, { 6, 4, 7 }, { 4, 8, 6 } };
  const double numbers[] = { 1, 2, 3, 3, 4 };
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_EQ(reading.Cell(i), cells[i]);
    EXPECT_EQ(reading.Face("Number", i), (Values{ numbers[i] }));
  }
}
}

TEST(VTKFiles, SurfacesOfUnstructuredGridsKeepTheirOrder)
{
  const TemporaryFile legacy(".vtk");
  vtkNew<vtkUnstructuredGridWriter> legacyWriter;
  legacyWriter->SetInputData(MixedGrid());
  legacyWriter->SetFileTypeToBinary();
  legacyWriter->SetFileName(legacy.Name());
  legacyWriter->Write();
  ExpectMixedSurface(Read(legacy.Name()));

  const TemporaryFile xml(".vtu");
  vtkNew<vtkXMLUnstructuredGridWriter> xmlWriter;
  xmlWriter->SetInputData(MixedGrid());
  xmlWriter->SetFileName(xml.Name());
  xmlWriter->Write();
  ExpectMixedSurface(Read(xml.Name()));
}

TEST(VTKFiles, VolumesByTheirOuterSurface)
{
  const Reading reading = ReadText(".vtk",
    Legacy +
      "DATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n0 0 0 1 0 0 0 1 0 0 0 1 0.1 1 1\n"
      "CELLS 2 10\n4 0 1 2 3\n4 1 2 3 4\nCELL_TYPES 2\n10 10\nCELL_DATA 2\nSCALARS part int 1\n"
      "LOOKUP_TABLE default\n7 8\n");
  EXPECT_EQ(reading.Messages, "");
  EXPECT_EQ(reading.Mesh->GetNumberOfPolys(), 6) << "all but the face between the two";
  EXPECT_EQ(reading.Face("part", 0), (Values{ 7 }));
  EXPECT_EQ(reading.Face("part", 5), (Values{ 8 }));
}

TEST(VTKFiles, PolygonsOfAnyNumberOfCornersButNoLines)
{
  const Reading reading = ReadText(".vtk",
    Legacy + "DATASET POLYDATA\n" + Square +
      "LINES 1 3\n2 0 1\nPOLYGONS 3 12\n4 0 1 2 3\n3 0 1 2\n2 0 1\nCELL_DATA 4\nSCALARS Label long "
      "1\n"
      "LOOKUP_TABLE default\n9 1 2 3\n");
  EXPECT_EQ(reading.Messages, "");
  ASSERT_EQ(reading.Mesh->GetNumberOfCells(), 3);
  EXPECT_EQ(reading.Cell(0), (Ids{ 0, 1, 2, 3 }));
  EXPECT_EQ(reading.Cell(2), (Ids{ 0, 1, 1 }));
  EXPECT_EQ(reading.Face("Label", 2), (Values{ 3 }));
}

TEST(VTKFiles, SaysWhatIsWrong)
{
  const std::string polygons = Legacy + "DATASET POLYDATA\n" + Square;
  const std::pair<std::string, std::string> cases[] = {
    { "", "it does not begin with \"# vtk DataFile\"." },
    { "hello\n", "it does not begin with" },
    { "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n",
      "line 4 has \"STRUCTURED_POINTS\"" },
    { polygons + "LINES 1 3\n2 0 1\n", "holds no surface" },
    { polygons + "POLYGONS 1 4\n3 0 1 7\n",
      "cell 0 of its POLYGONS uses point 7, but the 4 points are numbered from 0." },
    { polygons + "POLYGONS 1 4\n3 0 1\n", "it ends within its cells." },
    { polygons + "POLYGONS 1 4\n4 0 1 2\n", "cell 0 has more points than are there." },
    { polygons + "POLYGONS 1 4\n3 0 x 2\n", "line 8 has no number where its cells need one." },
    { polygons + "POLYGONS 2000000000 4\n3 0 1 2\n",
      "line 8 follows what cannot be understood: \"POLYGONS\"" },
    { Legacy + "DATASET POLYDATA\nPOINTS 2000000000 float\n0 0 0\n",
      "line 6 follows what cannot be" },
    { polygons + "POLYGONS 1 4\n3 0 1 2\nCELL_DATA 2\nSCALARS a int 1\nLOOKUP_TABLE default\n1 2\n",
      "the array \"a\" has 2 values for 1 cells." },
    { Legacy + "DATASET UNSTRUCTURED_GRID\n" + Square + "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n10\n",
      "cell 0 has too few points for its type 10." },
    { Legacy + "DATASET UNSTRUCTURED_GRID\n" + Square + "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n99\n",
      "cell 0 is of type 99, which cannot be read." },
    { Legacy + "DATASET UNSTRUCTURED_GRID\n" + Square + "CELLS 1 3\n2 0 1\n",
      "it has 1 cells but types of 0." },
  };
  for (const auto& [text, message] : cases)
  {
    const Reading reading = ReadText(".vtk", text);
    EXPECT_TRUE(reading.Has(message)) << "expected: " << message << "\nheard: " << reading.Messages;
    EXPECT_EQ(reading.Mesh->GetNumberOfPoints(), 0);
  }
  EXPECT_TRUE(ReadText(".vtp", "<VTKFile type=\"PolyData\"").Has("is not a valid VTK file"));
}

TEST(VTKFiles, XMLCutAnywhereIsOneError)
{
  const TemporaryFile whole(".vtu");
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(MixedGrid());
  writer->SetFileName(whole.Name());
  writer->Write();
  const std::string text = whole.Text();
  for (std::size_t size = 0; size + 20 < text.size(); size += 97)
  {
    EXPECT_TRUE(ReadText("cut.vtu", text.substr(0, size)).Has("is not a valid VTK file")) << size;
  }
}
