// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleTree.h"

#include "Constants.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace marrow
{
namespace
{
/// Fewer make the tree deep, more are searched one by one; time alone.
constexpr int LeafSize = 4;
/// Triangles in a ball count together from twice its radius on, as the paper of the fast winding
/// number advises.
constexpr double FarRadii = 2.0;

double SquaredDistanceToBox(
  const Eigen::Vector3d& point, const Eigen::Vector3d& low, const Eigen::Vector3d& high)
{
  return (point - point.cwiseMax(low).cwiseMin(high)).squaredNorm();
}

double SolidAngle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  return 2.0 *
    std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

double SixVolumes(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
  const Eigen::Vector3d& d)
{
  return (b - a).dot((c - a).cross(d - a));
}

/// Whether a segment passes through the inside of a triangle.
bool Crosses(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& a,
  const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  if ((SixVolumes(p, a, b, c) > 0.0) == (SixVolumes(q, a, b, c) > 0.0))
  {
    return false;
  }
  const double ab = SixVolumes(p, q, a, b);
  const double bc = SixVolumes(p, q, b, c);
  const double ca = SixVolumes(p, q, c, a);
  return (ab > 0.0 && bc > 0.0 && ca > 0.0) || (ab < 0.0 && bc < 0.0 && ca < 0.0);
}

std::vector<int> AllTriangles(const TriangleMesh& mesh)
{
  std::vector<int> all(mesh.Triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}
}

Eigen::Vector3d NearestOnTriangle(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
  const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  // Ericson, Real-Time Collision Detection, 5.1.5: by the region of the triangle's plane.
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const double d1 = ab.dot(point - a);
  const double d2 = ac.dot(point - a);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return a;
  }
  const double d3 = ab.dot(point - b);
  const double d4 = ac.dot(point - b);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return b;
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3)
  {
    return a + d1 / (d1 - d3) * ab;
  }
  const double d5 = ab.dot(point - c);
  const double d6 = ac.dot(point - c);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return c;
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6)
  {
    return a + d2 / (d2 - d6) * ac;
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6 && d4 - d3 + d5 - d6 > 0.0)
  {
    return b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b);
  }
  const double sum = va + vb + vc;
  return sum > 0.0 ? Eigen::Vector3d(a + vb / sum * ab + vc / sum * ac) : a;
}

TriangleTree::TriangleTree(const TriangleMesh& mesh)
  : TriangleTree(mesh, AllTriangles(mesh))
{
}

TriangleTree::TriangleTree(const TriangleMesh& mesh, std::vector<int> triangles)
  : Mesh(mesh)
  , Triangles(std::move(triangles))
{
  if (this->Triangles.empty())
  {
    return;
  }
  std::vector<Eigen::Vector3d> centroids(mesh.Triangles.size());
  for (int t : this->Triangles)
  {
    centroids[t] = mesh.Centroid(t);
  }
  this->Nodes.reserve(this->Triangles.size());
  this->Build(0, static_cast<int>(this->Triangles.size()), centroids);
}

int TriangleTree::Build(int first, int count, const std::vector<Eigen::Vector3d>& centroids)
{
  const int index = static_cast<int>(this->Nodes.size());
  Node node;
  node.First = first;
  node.Count = count;
  node.Second = -1;
  node.Low.setConstant(std::numeric_limits<double>::infinity());
  node.High = -node.Low;
  Eigen::Vector3d lowCentroid = node.Low;
  Eigen::Vector3d highCentroid = node.High;
  node.Middle.setZero();
  node.AreaVector.setZero();
  double area = 0.0;
  for (int i = first; i < first + count; ++i)
  {
    const int t = this->Triangles[i];
    for (int corner : this->Mesh.Triangles[t])
    {
      node.Low = node.Low.cwiseMin(this->Mesh.Points[corner]);
      node.High = node.High.cwiseMax(this->Mesh.Points[corner]);
    }
    lowCentroid = lowCentroid.cwiseMin(centroids[t]);
    highCentroid = highCentroid.cwiseMax(centroids[t]);
    const Eigen::Vector3d areaVector = 0.5 * this->Mesh.AreaVector(t);
    node.AreaVector += areaVector;
    node.Middle += areaVector.norm() * centroids[t];
    area += areaVector.norm();
  }
  node.Middle = area > 0.0 ? Eigen::Vector3d(node.Middle / area)
                           : Eigen::Vector3d(0.5 * (node.Low + node.High));
  node.Radius = (node.Middle - node.Low).cwiseMax(node.High - node.Middle).norm();
  this->Nodes.push_back(node);
  if (count > LeafSize)
  {
    int axis = 0;
    (highCentroid - lowCentroid).maxCoeff(&axis);
    const auto begin = this->Triangles.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count,
      [&](int s, int t)
      {
        return centroids[s][axis] != centroids[t][axis] ? centroids[s][axis] < centroids[t][axis]
                                                        : s < t;
      });
    this->Nodes[index].Count = 0;
    this->Build(first, count / 2, centroids);
    const int second = this->Build(first + count / 2, count - count / 2, centroids);
    this->Nodes[index].Second = second;
  }
  return index;
}

TriangleTree::Hit TriangleTree::Nearest(const Eigen::Vector3d& point, double limit) const
{
  Hit best;
  best.SquaredDistance = limit * limit;
  if (!this->Nodes.empty())
  {
    this->Search(0, point, best);
  }
  return best;
}

void TriangleTree::Search(int index, const Eigen::Vector3d& point, Hit& best) const
{
  const Node& node = this->Nodes[index];
  if (node.Count > 0)
  {
    for (int i = node.First; i < node.First + node.Count; ++i)
    {
      const auto& c = this->Mesh.Triangles[this->Triangles[i]];
      const double squared = (point -
        NearestOnTriangle(
          point, this->Mesh.Points[c[0]], this->Mesh.Points[c[1]], this->Mesh.Points[c[2]]))
                               .squaredNorm();
      if (squared < best.SquaredDistance)
      {
        best = { this->Triangles[i], squared };
      }
    }
    return;
  }
  const Node& first = this->Nodes[index + 1];
  const Node& second = this->Nodes[node.Second];
  const double toFirst = SquaredDistanceToBox(point, first.Low, first.High);
  const double toSecond = SquaredDistanceToBox(point, second.Low, second.High);
  const bool firstIsNearer = toFirst <= toSecond;
  for (const bool nearer : { true, false })
  {
    const bool isFirst = nearer == firstIsNearer;
    if ((isFirst ? toFirst : toSecond) < best.SquaredDistance)
    {
      this->Search(isFirst ? index + 1 : node.Second, point, best);
    }
  }
}

double TriangleTree::WindingNumber(const Eigen::Vector3d& point) const
{
  return this->Nodes.empty() ? 0.0 : this->Wind(0, point) / (4.0 * Pi);
}

double TriangleTree::Wind(int index, const Eigen::Vector3d& point) const
{
  const Node& node = this->Nodes[index];
  const Eigen::Vector3d toMiddle = node.Middle - point;
  const double distance = toMiddle.norm();
  if (distance > FarRadii * node.Radius)
  {
    return node.AreaVector.dot(toMiddle) / (distance * distance * distance);
  }
  if (node.Count == 0)
  {
    return this->Wind(index + 1, point) + this->Wind(node.Second, point);
  }
  double sum = 0.0;
  for (int i = node.First; i < node.First + node.Count; ++i)
  {
    const auto& c = this->Mesh.Triangles[this->Triangles[i]];
    sum += SolidAngle(this->Mesh.Points[c[0]] - point, this->Mesh.Points[c[1]] - point,
      this->Mesh.Points[c[2]] - point);
  }
  return sum;
}

bool TriangleTree::IsCrossedBy(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const
{
  return !this->Nodes.empty() && this->IsCrossed(0, a, b);
}

bool TriangleTree::IsCrossed(int index, const Eigen::Vector3d& a, const Eigen::Vector3d& b) const
{
  const Node& node = this->Nodes[index];
  if ((a.cwiseMin(b).array() > node.High.array()).any() ||
    (a.cwiseMax(b).array() < node.Low.array()).any())
  {
    return false;
  }
  if (node.Count == 0)
  {
    return this->IsCrossed(index + 1, a, b) || this->IsCrossed(node.Second, a, b);
  }
  for (int i = node.First; i < node.First + node.Count; ++i)
  {
    const auto& c = this->Mesh.Triangles[this->Triangles[i]];
    if (Crosses(a, b, this->Mesh.Points[c[0]], this->Mesh.Points[c[1]], this->Mesh.Points[c[2]]))
    {
      return true;
    }
  }
  return false;
}
}
