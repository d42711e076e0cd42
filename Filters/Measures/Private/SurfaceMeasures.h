// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SurfaceMeasures_h
#define marrow_SurfaceMeasures_h

#include "TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// Per half-edge: the angle between the normals of its two triangles in [-π, π], positive where the
/// surface is convex, 0 on a border and beside a triangle without area.
std::vector<double> EdgeDihedralAngles(const TriangleMesh& mesh);

/// Per vertex: the mean of EdgeDihedralAngles over the incident edges that have two triangles,
/// weighted by their lengths.
std::vector<double> VertexDihedralAngles(const TriangleMesh& mesh);

/// Per vertex: the unit tangent direction along which the surface bends least. It is the main
/// direction of the sum of |angle| × length × e eᵀ over the edges, of unit direction e, of the
/// triangles around the vertex (the curvature measure of Cohen-Steiner and Morvan 2003), to which a
/// trace of the direction from the mesh's centroid is added that decides where the surface is flat.
/// Zero where the normal is.
std::vector<Eigen::Vector3d> LeastBendingDirections(
  const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& normals);

/// Per vertex q (T:3.4): 1 / |B| × sum over the edges e = (i, j) of B of (f(i) - f(j)) |e| ê, where
/// B is the triangles around q, |B| their area and ê the unit direction from j to i. Dimensionless
/// for a function f that is a length; it points to where f grows.
std::vector<Eigen::Vector3d> VertexGradient(
  const TriangleMesh& mesh, const std::vector<double>& function);
}

#endif
