// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ShrunkMesh_h
#define marrow_ShrunkMesh_h

#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// How far the slice of each vertex is to be trusted, in [0,1].
///
/// Round a limb neighbouring vertices have like slices. At a tip, on a flat foot or in a joint no
/// plane through the normal cuts across the part, and the least perimeter jumps up to that of a slice
/// lengthwise. The perimeter of a slice across grows along the surface no faster than on a cone of 30° half-angle
/// (slope π): the reliability is the square of the largest such function below the MSP, over the MSP.
std::vector<double> SliceReliability(const TriangleMesh& mesh, const std::vector<double>& msp,
  const std::vector<unsigned char>& valid);

/// The vertices of the shrunk mesh (correspondence paper, section 5): each at its slice centre where
/// that is reliable, and drawn towards its neighbours' where it is not. The positions minimise
/// Σ a w |x - c|² + Σ s² k |x_i - x_j|²  with a the area, w the SliceReliability, c the slice centre, k the
/// clamped cotangent weight and s a third of the local radius MSP / 2π: the smoothing knows the
/// thickness of the part, not the size of the triangles.
std::vector<Eigen::Vector3d> ShrinkMesh(const TriangleMesh& mesh, const std::vector<double>& msp,
  const std::vector<Eigen::Vector3d>& sliceCenter, const std::vector<double>& reliability);
}

#endif
