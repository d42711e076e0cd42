// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceBridge.h"

#include "ArrayNames.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

namespace marrow
{
namespace
{
template <typename Visit>
void ForEachCell(vtkCellArray* cells, Visit&& visit)
{
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    visit(size, ids);
  }
}
}

SurfaceOfPolyData ToPolygonMesh(vtkPolyData* input)
{
  SurfaceOfPolyData result;
  PolygonMesh& mesh = result.Mesh;
  mesh.Points.resize(input->GetNumberOfPoints());
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    input->GetPoint(i, mesh.Points[i].data());
  }
  // The cells of a vtkPolyData are numbered: vertices, lines, polygons, strips.
  result.NumberOfOtherCells =
    static_cast<int>(input->GetNumberOfVerts() + input->GetNumberOfLines());
  result.PolygonOfCell.assign(result.NumberOfOtherCells, -1);
  const vtkIdType numberOfPoints = input->GetNumberOfPoints();
  auto pushCorner = [&](vtkIdType id)
  { mesh.Corners.push_back(id >= 0 && id < numberOfPoints ? static_cast<int>(id) : -1); };
  auto endPolygon = [&]()
  {
    mesh.Offsets.push_back(static_cast<int>(mesh.Corners.size()));
    result.CellOfPolygon.push_back(static_cast<int>(result.PolygonOfCell.size()) - 1);
  };
  ForEachCell(input->GetPolys(),
    [&](vtkIdType size, const vtkIdType* ids)
    {
      result.PolygonOfCell.push_back(mesh.NumberOfPolygons());
      for (vtkIdType i = 0; i < size; ++i)
      {
        pushCorner(ids[i]);
      }
      endPolygon();
    });
  ForEachCell(input->GetStrips(),
    [&](vtkIdType size, const vtkIdType* ids)
    {
      result.PolygonOfCell.push_back(mesh.NumberOfPolygons());
      for (vtkIdType i = 0; i + 2 < size || i == 0; ++i)
      {
        // Every other triangle of a strip runs the other way.
        for (vtkIdType k = 0; k < 3 && i + k < size; ++k)
        {
          pushCorner(ids[i + (i % 2 == 1 && k > 0 ? 3 - k : k)]);
        }
        endPolygon();
      }
    });
  return result;
}

void SetNote(const std::string& sentence, vtkPolyData* output)
{
  vtkNew<vtkStringArray> note;
  note->SetName(names::WorkingSurfaceNote);
  note->InsertNextValue(sentence);
  output->GetFieldData()->AddArray(note);
}
}
