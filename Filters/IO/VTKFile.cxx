// SPDX-License-Identifier: BSD-3-Clause
#include "VTKFile.h"

#include "FileMesh.h"
#include "TextReader.h"
#include "VTKMessages.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDataSetReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLGenericDataObjectReader.h>

#include <algorithm>

namespace marrow
{
namespace
{
/// VTK's readers allocate what a file promises, and go on when they got nothing.
std::string CheckPromises(const std::string& content)
{
  TextReader text(content, TextReader::Style::Plain);
  while (text.NextLine())
  {
    const auto& words = text.Words();
    static constexpr std::string_view keywords[] = { "POINTS", "POLYGONS", "LINES", "VERTICES",
      "TRIANGLE_STRIPS", "CELLS", "CELL_TYPES", "CELL_DATA", "POINT_DATA" };
    if (words.size() < 2 ||
      std::find(std::begin(keywords), std::end(keywords), words[0]) == std::end(keywords))
    {
      continue;
    }
    std::int64_t count = 0;
    if (ToNumber(words[1], count) &&
      (count < 0 || count > static_cast<std::int64_t>(content.size())))
    {
      return "line " + std::to_string(text.LineNumber()) + " promises more " +
        std::string(words[0]) + " than the file can hold";
    }
  }
  return {};
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
  std::string error = isXML ? std::string() : CheckPromises(content);
  if (error.empty())
  {
    const VTKMessages messages;
    if (isXML)
    {
      vtkNew<vtkXMLGenericDataObjectReader> reader;
      reader->SetFileName(fileName.c_str());
      reader->Update();
      data = vtkDataSet::SafeDownCast(reader->GetOutput());
    }
    else
    {
      vtkNew<vtkDataSetReader> reader;
      reader->ReadFromInputStringOn();
      reader->SetInputString(content);
      reader->ReadAllScalarsOn();
      reader->ReadAllVectorsOn();
      reader->ReadAllNormalsOn();
      reader->ReadAllTensorsOn();
      reader->ReadAllColorScalarsOn();
      reader->ReadAllTCoordsOn();
      reader->ReadAllFieldsOn();
      reader->Update();
      data = reader->GetOutput();
    }
    error = messages.FirstError();
  }
  if (error.empty())
  {
    error = data ? Check(data) : "it holds no data set";
  }
  return error.empty() ? error : NotValid(fileName, "VTK", error);
}
}
