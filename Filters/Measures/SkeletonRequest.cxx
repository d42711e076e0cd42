// SPDX-License-Identifier: BSD-3-Clause
#include "SkeletonRequest.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "MeshBridge.h"
#include "MeshCheck.h"
#include "PreparedSurface.h"
#include "SkeletonFrame.h"

#include <vtkAlgorithm.h>
#include <vtkInformationVector.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <utility>

namespace marrow
{
namespace
{
constexpr double ProgressAfterSurface = 0.05;

/// The measures of all bodies, from the input's arrays where it has them. `computed` tells which. After an
/// abort, which only IsAborted(filter) tells, they are not filled.
std::string MeasureBodies(vtkAlgorithm* filter, vtkPolyData* input, const PreparedSurface& surface,
  double from, double to, std::vector<VertexMeasures>& ofBodies, bool& computed)
{
  ofBodies.resize(surface.Bodies.size());
  computed = false;
  for (std::size_t b = 0; b < surface.Bodies.size(); ++b)
  {
    VertexMeasures& measures = ofBodies[b];
    const std::string error = ReadMeasures(input, surface, surface.Bodies[b], measures);
    if (!error.empty())
    {
      return error;
    }
    if (measures.AGD.empty() || measures.MSP.empty() || measures.MSPCenter.empty() ||
      measures.MSPValid.empty())
    {
      computed = true;
      const double size = static_cast<double>(surface.Bodies.size());
      if (!MeasureBody(surface.Bodies[b], DefaultMeasureParameters(), measures,
            ProgressOf(filter, from + (to - from) * b / size, from + (to - from) * (b + 1) / size)))
      {
        return {};
      }
    }
  }
  return {};
}
}

int RunSkeletonRequest(vtkAlgorithm* filter, const SkeletonRequest& request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* meshOutput = vtkPolyData::GetData(outputVector, 1);
  if (IsIdleProcess(outputVector, input))
  {
    return 1;
  }
  const auto fail = [&](const std::string& error)
  {
    vtkErrorWithObjectMacro(filter, << error);
    meshOutput->Initialize();
    return 0;
  };

  PreparedSurface surface;
  std::string error = PrepareSurface(input, request.MaximumFaces, BodyMode::Apart, surface,
    ProgressOf(filter, 0.0, ProgressAfterSurface));
  if (!error.empty())
  {
    return fail(error);
  }
  meshOutput->ShallowCopy(input);
  if (IsAborted(filter))
  {
    return 1;
  }
  WriteNote(surface, meshOutput);
  for (const Body& body : surface.Bodies)
  {
    error = request.Check(CheckMesh(body.Mesh));
    if (!error.empty())
    {
      return fail(error);
    }
  }
  std::vector<VertexMeasures> measures;
  bool computed = false;
  error = MeasureBodies(filter, input, surface, ProgressAfterSurface, request.ProgressAfterMeasures,
    measures, computed);
  if (!error.empty())
  {
    return fail(error);
  }
  if (IsAborted(filter))
  {
    return 1;
  }
  if (computed)
  {
    WriteMeasures(surface, measures, meshOutput);
  }

  std::vector<Skeleton> skeletons(surface.Bodies.size());
  for (std::size_t b = 0; b < surface.Bodies.size(); ++b)
  {
    const double size = static_cast<double>(surface.Bodies.size());
    const double span = 1.0 - request.ProgressAfterMeasures;
    error = request.Compute(surface.Bodies[b].Mesh, measures[b],
      ProgressOf(filter, request.ProgressAfterMeasures + span * b / size,
        request.ProgressAfterMeasures + span * (b + 1) / size),
      skeletons[b]);
    if (!error.empty())
    {
      return fail(error);
    }
    if (IsAborted(filter))
    {
      return 1;
    }
    // On the grid: what is read back from the output is then the same.
    skeletons[b] = ToFrame(std::move(skeletons[b]), CanonicalFrame());
  }
  WriteSkeletons(surface, skeletons, vtkPolyData::GetData(outputVector, 0), meshOutput);
  return 1;
}
}
