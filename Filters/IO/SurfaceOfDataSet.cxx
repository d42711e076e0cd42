// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceOfDataSet.h"

#include "VTKVersions.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkCellTypes.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkFieldData.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <vector>

namespace marrow
{
namespace
{
/// Of a polygon in a vtkPolyData; those with fewer repeat their last one.
constexpr vtkIdType LeastCorners = 3;

/// The number of corners of a cell with two dimensions, which come first among its points; 0 for other
/// cells.
vtkIdType NumberOfCorners(int type, vtkIdType numberOfPoints)
{
  switch (type)
  {
    case VTK_TRIANGLE:
    case VTK_QUAD:
    case VTK_PIXEL:
    case VTK_POLYGON:
    case VTK_TRIANGLE_STRIP:
      return numberOfPoints;
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_BIQUADRATIC_TRIANGLE:
    case VTK_HIGHER_ORDER_TRIANGLE:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_BEZIER_TRIANGLE:
      return 3;
    case VTK_QUADRATIC_QUAD:
    case VTK_BIQUADRATIC_QUAD:
    case VTK_QUADRATIC_LINEAR_QUAD:
    case VTK_HIGHER_ORDER_QUAD:
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_QUADRILATERAL:
      return 4;
    case VTK_QUADRATIC_POLYGON:
      return numberOfPoints / 2;
    default:
      return 0;
  }
}

bool HasVolume(vtkDataSet* data)
{
  vtkNew<vtkCellTypes> types;
  versions::GetDistinctCellTypes(data, types);
  for (vtkIdType i = 0; i < types->GetNumberOfTypes(); ++i)
  {
    vtkNew<vtkGenericCell> cell;
    cell->SetCellType(types->GetCellType(i));
    if (cell->GetCellDimension() == 3)
    {
      return true;
    }
  }
  return false;
}

bool IsUnusual(vtkCellArray* polygons)
{
  for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
  {
    if (polygons->GetCellSize(i) < LeastCorners)
    {
      return true;
    }
  }
  return false;
}

class SurfaceBuilder
{
public:
  SurfaceBuilder(vtkDataSet* data, vtkPolyData* surface)
    : Data(data)
    , Surface(surface)
  {
    surface->GetCellData()->CopyAllOn();
    surface->GetCellData()->CopyAllocate(data->GetCellData(), data->GetNumberOfCells());
  }

  /// A cell of the data whose row of the arrays is `row`.
  void AddCell(vtkIdType row, int type, vtkIdType numberOfPoints, const vtkIdType* ids)
  {
    const vtkIdType size = NumberOfCorners(type, numberOfPoints);
    if (type == VTK_TRIANGLE_STRIP)
    {
      for (vtkIdType k = 0; k + 2 < size; ++k)
      {
        const vtkIdType turned = k % 2;
        this->AddPolygon(row, { ids[k + turned], ids[k + 1 - turned], ids[k + 2] });
      }
    }
    else if (type == VTK_PIXEL)
    {
      this->AddPolygon(row, { ids[0], ids[1], ids[3], ids[2] });
    }
    else if (NumberOfCorners(type, LeastCorners) > 0)
    {
      this->AddPolygon(row, std::vector<vtkIdType>(ids, ids + size));
    }
  }

  void Finish()
  {
    this->Surface->SetPolys(this->Polygons);
    this->Surface->GetCellData()->Squeeze();
  }

private:
  void AddPolygon(vtkIdType row, std::vector<vtkIdType> ids)
  {
    ids.resize(std::max<std::size_t>(ids.size(), LeastCorners), ids.empty() ? 0 : ids.back());
    this->Polygons->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    this->Surface->GetCellData()->CopyData(
      this->Data->GetCellData(), row, this->Polygons->GetNumberOfCells() - 1);
  }

  vtkDataSet* Data;
  vtkPolyData* Surface;
  vtkNew<vtkCellArray> Polygons;
};
}

void ToSurface(vtkDataSet* data, vtkPolyData* surface)
{
  auto* mesh = vtkPolyData::SafeDownCast(data);
  if (mesh && mesh->GetNumberOfCells() == mesh->GetNumberOfPolys() && !IsUnusual(mesh->GetPolys()))
  {
    surface->ShallowCopy(mesh);
    return;
  }
  auto* points = vtkPointSet::SafeDownCast(data);
  vtkNew<vtkDataSetSurfaceFilter> outside;
  if (!points || (!mesh && HasVolume(data)))
  {
    outside->SetInputData(data);
    outside->Update();
    data = points = mesh = outside->GetOutput();
  }
  surface->SetPoints(points->GetPoints());
  surface->GetPointData()->ShallowCopy(data->GetPointData());
  surface->GetFieldData()->ShallowCopy(data->GetFieldData());
  SurfaceBuilder builder(data, surface);
  if (mesh)
  {
    // Not cell by cell: a vtkPolyData breaks down over polygons of fewer than three corners.
    vtkIdType row = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
    for (const auto& [cells, type] : { std::pair{ mesh->GetPolys(), VTK_POLYGON },
           std::pair{ mesh->GetStrips(), VTK_TRIANGLE_STRIP } })
    {
      const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
      for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
      {
        vtkIdType size = 0;
        const vtkIdType* ids = nullptr;
        cell->GetCurrentCell(size, ids);
        builder.AddCell(row++, type, size, ids);
      }
    }
  }
  else
  {
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      data->GetCellPoints(cell, ids);
      builder.AddCell(cell, data->GetCellType(cell), ids->GetNumberOfIds(), ids->GetPointer(0));
    }
  }
  builder.Finish();
}
}
