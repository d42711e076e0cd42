// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_VTKVersions_h
#define marrow_VTKVersions_h

#include <vtkAlgorithm.h>
#include <vtkCellTypes.h>
#include <vtkDataSet.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersionMacros.h>

/// What differs between VTK 9.1 and later ones, each with the version that brought it. No other file
/// asks for VTK's version.
namespace marrow::versions
{
/// Whether the filter is to stop. VTK 9.3, and the VTK of ParaView 5.11 (9.2.20220823), ask the filters
/// downstream too.
inline bool CheckAbort(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220823)
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
}

/// Whether the grid knows the faces of its polyhedra. VTK 9.4 has another array for them, and 9.6 no longer the
/// old one.
inline bool HasPolyhedronFaces(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  return grid->GetPolyhedronFaces() != nullptr;
#else
  return grid->GetFaces() != nullptr;
#endif
}

/// The types of the cells. VTK 9.6 renamed it.
inline void GetDistinctCellTypes(vtkDataSet* data, vtkCellTypes* types)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  data->GetDistinctCellTypes(types);
#else
  data->GetCellTypes(types);
#endif
}
}

#endif
