// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MeshMeasures_h
#define marrow_MeshMeasures_h

#include "Progress.h"
#include "TriangleMesh.h"
#include "VertexMeasures.h"

namespace marrow
{
/// From where the average geodesic distance is taken.
enum class GeodesicSources
{
  Sampled, ///< 64 farthest-point samples of each component
  AllVertices
};

/// What can be set about the measures: see vtkMSPField, where the defaults are.
struct MeasureParameters
{
  int NumberOfSlices;
  GeodesicSources Sources;
};

/// All measures of a manifold mesh. False if `progress` asked to stop.
bool MeasureMesh(const TriangleMesh& mesh, const MeasureParameters& parameters,
  VertexMeasures& measures, const Progress& progress = {});
}

#endif
