// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CoarseGeodesicDistance_h
#define marrow_CoarseGeodesicDistance_h

#include "Progress.h"
#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// ComputeAverageGeodesicDistance of the mesh simplified to `maximumTriangles`, if it has a quarter more than
/// that; what lies between the vertices that are left is interpolated in the nearest triangle. AGD changes slowly along
/// the surface: with 20,000 triangles and 64 sources the mean difference from all vertices is 0.001 to 0.0034, the
/// greatest 0.013 (meshes of 4,000 to 53,000 triangles), hardly more than without.
///
/// Returns false when stopped.
bool ComputeCoarseGeodesicDistance(const TriangleMesh& mesh, int maximumTriangles,
  int numberOfSources, std::vector<double>& values, const Progress& progress = Progress());
}

#endif
