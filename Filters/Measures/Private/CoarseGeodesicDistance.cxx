// SPDX-License-Identifier: BSD-3-Clause
#include "CoarseGeodesicDistance.h"

#include "AverageGeodesicDistance.h"
#include "NearestDownhill.h"
#include "Simplification.h"
#include "TriangleTree.h"

#include <Eigen/Geometry>

#include <array>

namespace marrow
{
namespace
{
/// Timed on meshes of 20,000 to 200,000 triangles; for the progress alone.
constexpr double ShareOfSimplification = 0.5;
/// Times the triangles that are to be left: of fewer the simplification takes longer than it saves, as timed.
constexpr double WorthSimplifying = 1.25;

/// The values at the corners of a triangle, at the point of it that is nearest to `point`.
double Interpolated(const TriangleMesh& mesh, const std::vector<double>& values, int triangle,
  const Eigen::Vector3d& point)
{
  const auto& [a, b, c] = mesh.Triangles[triangle];
  const auto& points = mesh.Points;
  const Eigen::Vector3d nearest = NearestOnTriangle(point, points[a], points[b], points[c]);
  const double areaA = (points[b] - nearest).cross(points[c] - nearest).norm();
  const double areaB = (points[c] - nearest).cross(points[a] - nearest).norm();
  const double areaC = (points[a] - nearest).cross(points[b] - nearest).norm();
  const double area = areaA + areaB + areaC;
  return area > 0.0 ? (areaA * values[a] + areaB * values[b] + areaC * values[c]) / area
                    : values[a];
}
}

bool ComputeCoarseGeodesicDistance(const TriangleMesh& mesh, int maximumTriangles,
  int numberOfSources, std::vector<double>& values, const Progress& progress)
{
  if (mesh.NumberOfTriangles() <= WorthSimplifying * maximumTriangles)
  {
    return ComputeAverageGeodesicDistance(mesh, numberOfSources, values, progress);
  }
  SimplifiedMesh coarse;
  std::vector<double> coarseValues;
  if (!SimplifyMesh(
        mesh, maximumTriangles, SubProgress(progress, 0.0, ShareOfSimplification), coarse) ||
    !ComputeAverageGeodesicDistance(coarse.Mesh, numberOfSources, coarseValues,
      SubProgress(progress, ShareOfSimplification, 1.0)))
  {
    return false;
  }
  values.assign(mesh.Points.size(), 0.0);
  const NearestDownhill nearestDownhill(coarse.Mesh);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    const int survivor = coarse.VertexOfOld[v];
    if (survivor < 0)
    {
      continue;
    }
    if (coarse.OldVertex[survivor] == v)
    {
      values[v] = coarseValues[survivor];
      continue;
    }
    const int triangle = nearestDownhill.Find(
      mesh.Points[v], TriangleMesh::TriangleOf(coarse.Mesh.Outgoing[survivor]));
    values[v] = Interpolated(coarse.Mesh, coarseValues, triangle, mesh.Points[v]);
  }
  return true;
}
}
