// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceOfDataSet.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
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

namespace marrow
{
namespace
{
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
  data->GetCellTypes(types);
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

/// A polydata's cells without area of their own may be polygons of one or two corners.
bool IsPolygonOf(vtkDataSet* data, vtkIdType cell)
{
  auto* mesh = vtkPolyData::SafeDownCast(data);
  return mesh && cell >= mesh->GetNumberOfVerts() + mesh->GetNumberOfLines() &&
    cell < mesh->GetNumberOfVerts() + mesh->GetNumberOfLines() + mesh->GetNumberOfPolys();
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

  void AddCell(vtkIdType cell)
  {
    this->Data->GetCellPoints(cell, this->Points);
    const int type = this->Data->GetCellType(cell);
    const vtkIdType size = IsPolygonOf(this->Data, cell)
      ? this->Points->GetNumberOfIds()
      : NumberOfCorners(type, this->Points->GetNumberOfIds());
    const vtkIdType* ids = this->Points->GetPointer(0);
    if (type == VTK_TRIANGLE_STRIP)
    {
      for (vtkIdType k = 0; k + 2 < size; ++k)
      {
        const vtkIdType turned = k % 2;
        this->AddPolygon(cell, { ids[k + turned], ids[k + 1 - turned], ids[k + 2] });
      }
    }
    else if (type == VTK_PIXEL)
    {
      this->AddPolygon(cell, { ids[0], ids[1], ids[3], ids[2] });
    }
    else if (size > 0)
    {
      this->Polygons->InsertNextCell(size, ids);
      this->CopyData(cell);
    }
  }

  void Finish()
  {
    this->Surface->SetPolys(this->Polygons);
    this->Surface->GetCellData()->Squeeze();
  }

private:
  void AddPolygon(vtkIdType cell, std::initializer_list<vtkIdType> ids)
  {
    this->Polygons->InsertNextCell(ids);
    this->CopyData(cell);
  }
  void CopyData(vtkIdType cell)
  {
    this->Surface->GetCellData()->CopyData(
      this->Data->GetCellData(), cell, this->Polygons->GetNumberOfCells() - 1);
  }

  vtkDataSet* Data;
  vtkPolyData* Surface;
  vtkNew<vtkCellArray> Polygons;
  vtkNew<vtkIdList> Points;
};
}

void ToSurface(vtkDataSet* data, vtkPolyData* surface)
{
  auto* mesh = vtkPolyData::SafeDownCast(data);
  if (mesh && mesh->GetNumberOfCells() == mesh->GetNumberOfPolys())
  {
    surface->ShallowCopy(mesh);
    return;
  }
  auto* points = vtkPointSet::SafeDownCast(data);
  vtkNew<vtkDataSetSurfaceFilter> outside;
  if (!points || HasVolume(data))
  {
    outside->SetInputData(data);
    outside->Update();
    data = points = outside->GetOutput();
  }
  surface->SetPoints(points->GetPoints());
  surface->GetPointData()->ShallowCopy(data->GetPointData());
  surface->GetFieldData()->ShallowCopy(data->GetFieldData());
  SurfaceBuilder builder(data, surface);
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    builder.AddCell(cell);
  }
  builder.Finish();
}
}
