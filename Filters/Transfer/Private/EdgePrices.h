// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_EdgePrices_h
#define marrow_EdgePrices_h

#include "MeshSmoother.h"
#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// The width over which segments blend at their boundaries and concavity is measured, of the
/// diagonal, where many maps are blended and none of them says it; any from 0.005 to 0.02 does.
inline constexpr double BlendWidth = 0.01;

/// How concave the surface is at each edge: the angle in radians, at most 1, by which the normals
/// turn inward over the width of `smoother`, by which they are smoothed before. So neither noise nor
/// the resolution changes it. Per half-edge; of an edge's two the smaller index has it, the other and
/// those on a border have 0.
std::vector<double> EdgeConcavity(const TriangleMesh& mesh, const MeshSmoother& smoother);

/// How much the boundaries of a segmentation keep to concave edges: the c for which edges drawn with
/// a chance of length × exp(c × concavity) are on average as concave as the boundaries (the
/// likeliest c). 0 where they do not, at most 20.
double ConcavityPreference(const TriangleMesh& mesh, const std::vector<double>& concavity,
  const std::vector<int>& segmentOfTriangle);

/// The same of a mesh and its segmentation alone, with concavity measured over `width`, of the
/// diagonal.
double PreferenceOf(
  const TriangleMesh& mesh, const std::vector<int>& segmentOfTriangle, double width);

/// What it costs to run a boundary along an edge, per half-edge as above: length over the diagonal of
/// the bounding box × exp(−preference × concavity), at least a twentieth of the length: if creases
/// were free, boundaries would wander along them.
std::vector<double> EdgePrices(
  const TriangleMesh& mesh, const std::vector<double>& concavity, double preference);
}

#endif
