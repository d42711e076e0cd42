// SPDX-License-Identifier: BSD-3-Clause
#include "VTKFile.h"

#include "FileMeshBridge.h"
#include "LegacyVTKFile.h"
#include "StringArrays.h"
#include "VTKMessages.h"
#include "VTKVersions.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLGenericDataObjectReader.h>

#include <algorithm>

namespace marrow
{
namespace
{
/// The least number of points of a cell by its type; -1 for types that are not read.
int LeastPoints(int type)
{
  switch (type)
  {
    case VTK_QUADRATIC_EDGE:
    case VTK_QUADRATIC_POLYGON:
      return 3;
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_QUADRATIC_LINEAR_QUAD:
      return 6;
    case VTK_BIQUADRATIC_TRIANGLE:
      return 7;
    case VTK_QUADRATIC_QUAD:
      return 8;
    case VTK_BIQUADRATIC_QUAD:
      return 9;
    case VTK_QUADRATIC_TETRA:
      return 10;
    case VTK_QUADRATIC_LINEAR_WEDGE:
      return 12;
    case VTK_QUADRATIC_PYRAMID:
      return 13;
    case VTK_QUADRATIC_WEDGE:
      return 15;
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
      return 18;
    case VTK_QUADRATIC_HEXAHEDRON:
      return 20;
    case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
      return 24;
    case VTK_TRIQUADRATIC_HEXAHEDRON:
      return 27;
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_BEZIER_TRIANGLE:
    case VTK_TRIANGLE:
      return 3;
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_QUADRILATERAL:
    case VTK_QUAD:
    case VTK_PIXEL:
    case VTK_TETRA:
      return 4;
    case VTK_PYRAMID:
      return 5;
    case VTK_WEDGE:
      return 6;
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
      return 8;
    case VTK_PENTAGONAL_PRISM:
      return 10;
    case VTK_HEXAGONAL_PRISM:
      return 12;
    case VTK_EMPTY_CELL:
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
    case VTK_LINE:
    case VTK_POLY_LINE:
    case VTK_TRIANGLE_STRIP:
    case VTK_POLYGON:
    case VTK_POLYHEDRON:
      return 0;
    default:
      return -1;
  }
}

/// VTK's filters read as many points as a cell of its type has.
std::string CheckTypes(vtkUnstructuredGrid* grid)
{
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    const int least = LeastPoints(type);
    if (least < 0 || (type == VTK_POLYHEDRON && !versions::HasPolyhedronFaces(grid)))
    {
      return "cell " + std::to_string(cell) + " is of type " + std::to_string(type) +
        ", which cannot be read";
    }
    if (grid->GetCells()->GetCellSize(cell) < least)
    {
      return "cell " + std::to_string(cell) + " has too few points for its type " +
        std::to_string(type);
    }
  }
  return {};
}

void Fill(const LegacyCells& from, vtkCellArray* to)
{
  std::vector<vtkIdType> ids;
  to->AllocateExact(
    static_cast<vtkIdType>(from.Size()), static_cast<vtkIdType>(from.Points.size()));
  for (std::size_t cell = 0; cell < from.Size(); ++cell)
  {
    ids.assign(
      from.Points.begin() + from.Starts[cell], from.Points.begin() + from.Starts[cell + 1]);
    to->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
}

vtkSmartPointer<vtkDataSet> ToDataSet(const LegacyVTKData& data)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(data.Points.size()));
  for (std::size_t i = 0; i < data.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), data.Points[i].data());
  }
  vtkNew<vtkCellArray> cells;
  vtkSmartPointer<vtkPointSet> result;
  if (data.IsGrid)
  {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    Fill(data.Cells, cells);
    grid->SetCells(std::vector<int>(data.CellTypes).data(), cells);
    result = grid;
  }
  else
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkCellArray> vertices;
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkCellArray> strips;
    Fill(data.Vertices, vertices);
    Fill(data.Lines, lines);
    Fill(data.Polygons, cells);
    Fill(data.Strips, strips);
    mesh->SetVerts(vertices);
    mesh->SetLines(lines);
    mesh->SetPolys(cells);
    mesh->SetStrips(strips);
    result = mesh;
  }
  result->SetPoints(points);
  AddArrays(data.PointArrays, result->GetPointData());
  AddArrays(data.CellArrays, result->GetCellData());
  AddArrays(data.FieldArrays, result->GetFieldData());
  for (const auto& [name, strings] : data.FieldStrings)
  {
    SetStrings(result->GetFieldData(), name.c_str(), strings);
  }
  return result;
}

std::string CheckCells(vtkCellArray* cells, vtkIdType numberOfPoints)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return {};
  }
  const vtkIdType numberOfCells = cells->GetNumberOfCells();
  vtkDataArray* offsets = cells->GetOffsetsArray();
  vtkDataArray* connectivity = cells->GetConnectivityArray();
  vtkIdType end = 0;
  for (vtkIdType i = 0; i <= numberOfCells; ++i)
  {
    const auto next = static_cast<vtkIdType>(offsets->GetTuple1(i));
    if (next < end || next > connectivity->GetNumberOfTuples())
    {
      return "its cells are not where it says, from cell " +
        std::to_string(std::max<vtkIdType>(i - 1, 0)) + " on";
    }
    end = next;
  }
  for (vtkIdType i = 0; i < connectivity->GetNumberOfTuples(); ++i)
  {
    const auto id = static_cast<vtkIdType>(connectivity->GetTuple1(i));
    if (id < 0 || id >= numberOfPoints)
    {
      return "a cell uses point " + std::to_string(id) + ", but the " +
        std::to_string(numberOfPoints) + " points are numbered from 0";
    }
  }
  return {};
}

std::string CheckArrays(vtkDataSetAttributes* data, vtkIdType size, const char* where)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array && array->GetNumberOfTuples() != size)
    {
      return std::string("the array \"") + (array->GetName() ? array->GetName() : "") + "\" has " +
        std::to_string(array->GetNumberOfTuples()) + " values for " + std::to_string(size) + " " +
        where;
    }
  }
  return {};
}

std::string Check(vtkDataSet* data)
{
  const vtkIdType numberOfPoints = data->GetNumberOfPoints();
  std::string error = CheckArrays(data->GetPointData(), numberOfPoints, "points");
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* cells :
      { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
    {
      error = error.empty() ? CheckCells(cells, numberOfPoints) : error;
    }
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    error = error.empty() ? CheckCells(grid->GetCells(), numberOfPoints) : error;
    error = error.empty() ? CheckTypes(grid) : error;
  }
  return error.empty() ? CheckArrays(data->GetCellData(), data->GetNumberOfCells(), "cells")
                       : error;
}
}

std::string ReadVTKFile(
  const std::string& content, const std::string& fileName, vtkSmartPointer<vtkDataSet>& data)
{
  const std::size_t first = content.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  const bool isXML = first != std::string::npos && content[first] == '<';
  std::string error;
  if (isXML)
  {
    const VTKMessages messages;
    vtkNew<vtkXMLGenericDataObjectReader> reader;
    reader->SetFileName(fileName.c_str());
    reader->Update();
    data = vtkDataSet::SafeDownCast(reader->GetOutput());
    error = messages.FirstError();
  }
  else
  {
    LegacyVTKData legacy;
    error = ReadLegacyVTKFile(content, fileName, legacy);
    if (!error.empty())
    {
      return error;
    }
    data = ToDataSet(legacy);
  }
  if (error.empty())
  {
    error = data ? Check(data) : "it holds no data set";
  }
  return error.empty() ? error : NotValid(fileName, "VTK", error);
}
}
