// SPDX-License-Identifier: BSD-3-Clause
#include "MeshMeasures.h"

#include "AverageGeodesicDistance.h"
#include "CoarseGeodesicDistance.h"
#include "MinimumSlicePerimeter.h"
#include "SurfaceMeasures.h"

#include <cmath>
#include <utility>

namespace marrow
{
namespace
{
/// AGD is then within 0.01 of that from all vertices, as a test asks.
constexpr int NumberOfSampledSources = 64;
/// AGD changes slowly along the surface, but junctions and branches are compared by it: at 15,000 the refined
/// elephant of the accuracy tests is matched otherwise, at 5,000 an octopus and some hands.
constexpr int CoarseTriangles = 20000;

/// The share of the time that goes into AGD, as measured from 5,000 to 1,000,000 faces: the time for
/// slices grows faster with the mesh.
double ShareOfAGD(int numberOfVertices, int numberOfSources, int numberOfSlices)
{
  const double sources = numberOfSources / 64.0;
  /// Slices get longer as meshes get finer; timed, for the progress alone.
  constexpr double ofSize = 1.0e4;
  constexpr double growth = 0.3;
  const double slices = numberOfSlices / 12.0 * std::pow(numberOfVertices / ofSize, growth);
  return sources / (sources + slices);
}
}

bool MeasureMesh(const TriangleMesh& mesh, const MeasureParameters& parameters,
  VertexMeasures& measures, const Progress& progress)
{
  const int numberOfSlices = parameters.NumberOfSlices;
  const bool sampled = parameters.Sources == GeodesicSources::Sampled;
  const double share = ShareOfAGD(mesh.NumberOfVertices(),
    sampled ? NumberOfSampledSources : mesh.NumberOfVertices(), numberOfSlices);
  SliceField slices;
  const bool hasAGD = sampled
    ? ComputeCoarseGeodesicDistance(mesh, CoarseTriangles, NumberOfSampledSources, measures.AGD,
        SubProgress(progress, 0.0, share))
    : ComputeAverageGeodesicDistance(mesh, 0, measures.AGD, SubProgress(progress, 0.0, share));
  if (!hasAGD ||
    !ComputeMinimumSlicePerimeter(mesh, numberOfSlices, slices, SubProgress(progress, share, 1.0)))
  {
    return false;
  }
  measures.MSPGradient = VertexGradient(mesh, slices.Perimeter);
  measures.DihedralAngle = VertexDihedralAngles(mesh);
  measures.MSP = std::move(slices.Perimeter);
  measures.MSPCenter = std::move(slices.Center);
  measures.MSPNormal = std::move(slices.Normal);
  measures.MSPValid = std::move(slices.Valid);
  return true;
}
}
