// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeWrap.h"

#include "FanSeparation.h"
#include "MeshCheck.h"
#include "SheetPairing.h"
#include "SurfaceNets.h"
#include "TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace marrow
{
namespace
{
using Field = std::function<double(const Eigen::Vector3d&)>;

/// Without the components of negative volume, which bound cavities.
TriangleMesh OuterSurface(const TriangleMesh& mesh)
{
  int count = 0;
  const std::vector<int> component = TriangleComponents(mesh, count);
  std::vector<double> volume(count, 0.0);
  const Eigen::Vector3d origin =
    mesh.Points.empty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(mesh.Points.front());
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    volume[component[t]] += (mesh.Points[mesh.Triangles[t][0]] - origin).dot(mesh.AreaVector(t));
  }
  TriangleMesh outer;
  std::vector<int> vertex(mesh.Points.size(), -1);
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (volume[component[t]] > 0.0)
    {
      outer.Triangles.push_back(mesh.Triangles[t]);
      for (int& corner : outer.Triangles.back())
      {
        if (vertex[corner] < 0)
        {
          vertex[corner] = outer.NumberOfVertices();
          outer.Points.push_back(mesh.Points[corner]);
        }
        corner = vertex[corner];
      }
    }
  }
  outer.BuildConnectivity();
  return outer;
}

TriangleMesh Extract(
  const Field& field, const Eigen::Vector3d& low, const Eigen::Vector3d& high, double spacing)
{
  // Sheets may meet in rare cells.
  MendedMesh net;
  net.Mesh = SurfaceNets(field, low, high, spacing);
  net.CellOfTriangle.resize(net.Mesh.Triangles.size());
  net.PointOfVertex.resize(net.Mesh.Points.size());
  PairSheets(net.Mesh);
  SeparateFans(net);
  return OuterSurface(net.Mesh);
}

/// The share of the triangles' area whose middles lie within `reach` of a surface.
double CoveredShare(const TriangleMesh& mesh, const std::vector<int>& triangles,
  const TriangleMesh& surface, double reach)
{
  const TriangleTree tree(surface);
  double area = 0.0;
  double covered = 0.0;
  for (int t : triangles)
  {
    const double own = mesh.Area(t);
    area += own;
    covered += tree.Nearest(mesh.Centroid(t), reach).Triangle >= 0 ? own : 0.0;
  }
  return area > 0.0 ? covered / area : 0.0;
}
}

TriangleMesh WrapVolume(
  const TriangleMesh& mesh, const std::vector<int>& triangles, double spacing, int mostCells)
{
  Eigen::Vector3d low = mesh.Points[mesh.Triangles[triangles.front()][0]];
  Eigen::Vector3d high = low;
  for (int t : triangles)
  {
    for (int corner : mesh.Triangles[t])
    {
      low = low.cwiseMin(mesh.Points[corner]);
      high = high.cwiseMax(mesh.Points[corner]);
    }
  }
  spacing = std::max(spacing, (high - low).maxCoeff() / mostCells);
  // Room for the drawing at a distance, too: one cell on each side, and one and a half for the distance.
  constexpr double margin = 2.5;
  low -= Eigen::Vector3d::Constant(margin * spacing);
  high += Eigen::Vector3d::Constant(margin * spacing);

  const TriangleTree tree(mesh, triangles);
  const auto distance = [&](const Eigen::Vector3d& point)
  { return std::sqrt(tree.Nearest(point).SquaredDistance); };
  // At the opening of a disc of radius R the winding number passes 1/2 at a rate of about 1 / 2R and
  // the distance is R: the product is like a distance there as well. A point on an inner surface has
  // none, and has to count as inside all the same.
  constexpr double perSpacing = 1.0e-6; // far below what the grid can see
  const double least = perSpacing * spacing;
  const Field windingField = [&](const Eigen::Vector3d& point)
  {
    return -std::max(distance(point), least) *
      std::clamp(2.0 * tree.WindingNumber(point) - 1.0, -1.0, 1.0);
  };
  TriangleMesh wrap = Extract(windingField, low, high, spacing);
  if (CoveredShare(mesh, triangles, wrap, spacing) < 0.5)
  {
    wrap = Extract(
      [&](const Eigen::Vector3d& point) { return distance(point) - spacing; }, low, high, spacing);
  }
  return wrap;
}
}
