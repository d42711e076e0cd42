// SPDX-License-Identifier: BSD-3-Clause
#include "RequiredMeasures.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "MeshBridge.h"
#include "NodeMeasures.h"

#include <vtkMSPField.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>

namespace marrow
{
namespace
{
bool GetMeasures(vtkPolyData* mesh, SkeletonMeasures& measures)
{
  vtkPointData* points = mesh->GetPointData();
  const int size = static_cast<int>(mesh->GetNumberOfPoints());
  return GetArray(points, names::AGD, size, measures.AGD) &&
    GetArray(points, names::MSP, size, measures.MSP) &&
    GetArray(points, names::MSPCenter, size, measures.MSPCenter) &&
    GetArray(points, names::MSPValid, size, measures.MSPValid);
}

/// One sentence on the first measure that is not finite; empty if all are.
std::string FiniteError(const SkeletonMeasures& measures)
{
  const auto sentence = [](const char* name, std::size_t point)
  {
    return std::string("The array \"") + name + "\" of the mesh is not finite at point " +
      std::to_string(point) + ": remove the array, and it is computed anew.";
  };
  for (std::size_t i = 0; i < measures.MSP.size(); ++i)
  {
    if (!std::isfinite(measures.AGD[i]))
    {
      return sentence(names::AGD, i);
    }
    if (!std::isfinite(measures.MSP[i]))
    {
      return sentence(names::MSP, i);
    }
    if (!measures.MSPCenter[i].allFinite())
    {
      return sentence(names::MSPCenter, i);
    }
  }
  return {};
}
}

std::string RequireMeasures(
  vtkAlgorithm* outer, double from, double to, vtkPolyData* mesh, SkeletonMeasures& measures)
{
  if (!GetMeasures(mesh, measures))
  {
    vtkNew<vtkPolyData> bare;
    bare->ShallowCopy(mesh);
    vtkNew<vtkMSPField> field;
    WatchInner(outer, field, from, to);
    field->SetInputData(bare);
    field->Update();
    if (IsAborted(outer))
    {
      return {};
    }
    mesh->ShallowCopy(field->GetOutput());
    if (!GetMeasures(mesh, measures))
    {
      return "The measures of the mesh could not be computed: see the message of vtkMSPField.";
    }
  }
  return FiniteError(measures);
}
}
