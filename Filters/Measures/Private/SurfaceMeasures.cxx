// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceMeasures.h"

#include <Eigen/Geometry>

#include <cmath>

namespace marrow
{
namespace
{
// Against the curvature term, which is an angle of some hundredths in the roundest of flat places.
constexpr double CentroidWeight = 1e-6;

/// Calls visit(half-edge) once for every edge of the triangles around a vertex.
template <typename Visit>
void ForEachEdgeOfStar(const TriangleMesh& mesh, int vertex, Visit&& visit)
{
  int last = -1;
  mesh.ForEachOutgoing(vertex,
    [&](int h)
    {
      visit(h);
      visit(TriangleMesh::Next(h));
      last = h;
    });
  if (last >= 0 && mesh.Opposite[TriangleMesh::Previous(last)] < 0)
  {
    visit(TriangleMesh::Previous(last));
  }
}

Eigen::Vector3d SurfaceCentroid(const TriangleMesh& mesh)
{
  double area = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const double own = mesh.Area(t);
    area += own;
    moment += own * mesh.Centroid(t);
  }
  return area > 0.0 ? Eigen::Vector3d(moment / area) : mesh.Points.front();
}
}

std::vector<double> EdgeDihedralAngles(const TriangleMesh& mesh)
{
  std::vector<Eigen::Vector3d> normals(mesh.Triangles.size());
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    normals[t] = mesh.AreaVector(t);
    const double length = normals[t].norm();
    if (length > 0.0)
    {
      normals[t] /= length;
    }
  }
  std::vector<double> angles(3 * mesh.Triangles.size(), 0.0);
  for (int h = 0; h < static_cast<int>(angles.size()); ++h)
  {
    const int opposite = mesh.Opposite[h];
    if (opposite < h)
    {
      continue; // a border, or done from the other side
    }
    const Eigen::Vector3d& a = normals[TriangleMesh::TriangleOf(h)];
    const Eigen::Vector3d& b = normals[TriangleMesh::TriangleOf(opposite)];
    const Eigen::Vector3d edge = mesh.Points[mesh.To(h)] - mesh.Points[mesh.From(h)];
    const Eigen::Vector3d turn = a.cross(b);
    const double sine = turn.norm();
    const double angle = std::atan2(turn.dot(edge) < 0.0 ? -sine : sine, a.dot(b));
    const bool defined = a.squaredNorm() > 0.0 && b.squaredNorm() > 0.0;
    angles[h] = angles[opposite] = defined ? angle : 0.0;
  }
  return angles;
}

std::vector<double> VertexDihedralAngles(const TriangleMesh& mesh)
{
  const std::vector<double> edgeAngles = EdgeDihedralAngles(mesh);
  std::vector<double> angles(mesh.Points.size(), 0.0);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    double sum = 0.0;
    double weight = 0.0;
    mesh.ForEachOutgoing(v,
      [&](int h)
      {
        if (mesh.Opposite[h] >= 0)
        {
          const double length = (mesh.Points[mesh.To(h)] - mesh.Points[v]).norm();
          sum += length * edgeAngles[h];
          weight += length;
        }
      });
    angles[v] = weight > 0.0 ? sum / weight : 0.0;
  }
  return angles;
}

std::vector<Eigen::Vector3d> LeastBendingDirections(
  const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& normals)
{
  const std::vector<double> angles = EdgeDihedralAngles(mesh);
  const Eigen::Vector3d centroid = SurfaceCentroid(mesh);
  const double diagonal = mesh.BoundingBoxDiagonal();
  std::vector<Eigen::Vector3d> directions(mesh.Points.size(), Eigen::Vector3d::Zero());
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (normals[v].squaredNorm() == 0.0)
    {
      continue;
    }
    // A basis of the tangent plane; what is found in it does not depend on its choice.
    const Eigen::Vector3d x = normals[v].unitOrthogonal();
    const Eigen::Vector3d y = normals[v].cross(x);
    Eigen::Matrix2d tensor = Eigen::Matrix2d::Zero();
    double total = 0.0;
    ForEachEdgeOfStar(mesh, v,
      [&](int h)
      {
        const Eigen::Vector3d edge = mesh.Points[mesh.To(h)] - mesh.Points[mesh.From(h)];
        const double length = edge.norm();
        if (length > 0.0)
        {
          const Eigen::Vector2d tangent(x.dot(edge), y.dot(edge));
          tensor += std::abs(angles[h]) / length * tangent * tangent.transpose();
          total += length;
        }
      });
    if (total > 0.0)
    {
      tensor /= total;
    }
    const Eigen::Vector3d fromCentroid = (mesh.Points[v] - centroid) / diagonal;
    const Eigen::Vector2d radial(x.dot(fromCentroid), y.dot(fromCentroid));
    tensor += CentroidWeight * radial * radial.transpose();

    // Main direction of a symmetric 2 × 2 matrix in closed form.
    const double angle = 0.5 * std::atan2(2.0 * tensor(0, 1), tensor(0, 0) - tensor(1, 1));
    directions[v] = std::cos(angle) * x + std::sin(angle) * y;
  }
  return directions;
}

std::vector<Eigen::Vector3d> VertexGradient(
  const TriangleMesh& mesh, const std::vector<double>& function)
{
  std::vector<Eigen::Vector3d> gradient(mesh.Points.size(), Eigen::Vector3d::Zero());
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    double area = 0.0;
    mesh.ForEachOutgoing(v, [&](int h) { area += mesh.Area(TriangleMesh::TriangleOf(h)); });
    if (!(area > 0.0))
    {
      continue;
    }
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    ForEachEdgeOfStar(mesh, v,
      [&](int h)
      {
        const int i = mesh.From(h);
        const int j = mesh.To(h);
        sum += (function[i] - function[j]) * (mesh.Points[i] - mesh.Points[j]);
      });
    gradient[v] = sum / area;
  }
  return gradient;
}
}
