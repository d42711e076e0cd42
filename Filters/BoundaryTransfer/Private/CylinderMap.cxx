// SPDX-License-Identifier: BSD-3-Clause
#include "CylinderMap.h"

#include "MeshSmoother.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

namespace marrow
{
namespace
{
double Wrap(double u)
{
  return u - std::floor(u);
}
}

CylinderMap::CylinderMap(const TriangleMesh& mesh, CoveringRegion region)
  : Mesh(&mesh)
  , Region(std::move(region))
{
  for (int t : this->Region.Triangles)
  {
    for (int corner : mesh.Triangles[t])
    {
      if (this->LocalOfVertex.insert({ corner, static_cast<int>(this->Vertices.size()) }).second)
      {
        this->Vertices.push_back(corner);
      }
    }
  }
}

void CylinderMap::MarkJumps(
  const std::vector<int>& cut, std::vector<std::array<char, 3>>& jumps) const
{
  // Round every vertex of the cut, the triangles to its right jump; they are found by going round
  // from the cut's own edges without crossing it.
  std::unordered_map<int, std::size_t> indexOfTriangle;
  for (std::size_t i = 0; i < this->Region.Triangles.size(); ++i)
  {
    indexOfTriangle[this->Region.Triangles[i]] = i;
  }
  jumps.assign(this->Region.Triangles.size(), { 0, 0, 0 });
  for (std::size_t i = 0; i < cut.size(); ++i)
  {
    const int vertex = cut[i];
    const int before = i > 0 ? cut[i - 1] : -1;
    const int after = i + 1 < cut.size() ? cut[i + 1] : -1;
    const auto isCut = [&](int other) { return other == before || other == after; };
    std::vector<int> outgoing;
    this->Mesh->ForEachOutgoing(vertex, [&](int h) { outgoing.push_back(h); });
    const std::size_t n = outgoing.size();
    // Triangle k lies between edge k and, counter-clockwise, edge k + 1: right of the cut are those
    // from the edge to `before` on up to the edge to `after`.
    const auto mark = [&](std::size_t k)
    {
      const auto found = indexOfTriangle.find(TriangleMesh::TriangleOf(outgoing[k]));
      if (found != indexOfTriangle.end())
      {
        jumps[found->second][outgoing[k] % 3] = 1;
      }
      return found != indexOfTriangle.end();
    };
    for (std::size_t k = 0; k < n; ++k)
    {
      const int neighbour = this->Mesh->To(outgoing[k]);
      if (neighbour == before)
      {
        for (std::size_t j = k; mark(j); j = (j + 1) % n)
        {
          const int last = TriangleMesh::Previous(outgoing[j]);
          if (isCut(this->Mesh->From(last)) || this->Mesh->Opposite[last] < 0)
          {
            break;
          }
        }
      }
      else if (neighbour == after && this->Mesh->Opposite[outgoing[k]] >= 0)
      {
        for (std::size_t j = (k + n - 1) % n; mark(j); j = (j + n - 1) % n)
        {
          if (isCut(this->Mesh->To(outgoing[j])) || this->Mesh->Opposite[outgoing[j]] < 0)
          {
            break;
          }
        }
      }
    }
  }
}

bool CylinderMap::Solve(PathFinder& paths)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::unordered_set<int> first(this->Region.Rims[0].begin(), this->Region.Rims[0].end());
  const std::unordered_set<int> second(this->Region.Rims[1].begin(), this->Region.Rims[1].end());
  // The cut touches each rim once, so that it separates nothing but the annulus.
  const std::vector<int> cut = paths.Find(
    this->Region.Rims[0], [&](int v) { return second.count(v) > 0; },
    [&](int from, int to)
    {
      return this->Contains(to) && first.count(to) == 0 &&
          (first.count(from) == 0 || second.count(to) == 0)
        ? (this->Mesh->Points[to] - this->Mesh->Points[from]).norm()
        : infinity;
    });
  if (cut.size() < 3)
  {
    return false;
  }
  std::vector<std::array<char, 3>> jumps;
  this->MarkJumps(cut, jumps);

  const int n = static_cast<int>(this->Vertices.size());
  const int pinned = this->LocalOfVertex.at(cut.front());
  std::vector<Eigen::Triplet<double>> uEntries;
  std::vector<Eigen::Triplet<double>> vEntries;
  Eigen::VectorXd uRight = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd vRight = Eigen::VectorXd::Zero(n);
  const auto isFixed = [&](int vertex)
  { return first.count(vertex) > 0 || second.count(vertex) > 0; };
  for (std::size_t i = 0; i < this->Region.Triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int h = 3 * this->Region.Triangles[i] + k;
      constexpr double leastWeight = 0.01; // above 0, so that no triangle is turned over
      const double weight = CotangentWeight(*this->Mesh, h, leastWeight);
      const int from = this->Mesh->From(h);
      const int to = this->Mesh->To(h);
      const int a = this->LocalOfVertex.at(from);
      const int b = this->LocalOfVertex.at(to);
      const double jump = jumps[i][(k + 1) % 3] - jumps[i][k];
      uEntries.emplace_back(a, a, weight);
      uEntries.emplace_back(b, b, weight);
      uEntries.emplace_back(a, b, -weight);
      uEntries.emplace_back(b, a, -weight);
      uRight[a] += weight * jump;
      uRight[b] -= weight * jump;
      const auto addV = [&](int row, int rowVertex, int column, int columnVertex)
      {
        if (isFixed(rowVertex))
        {
          return;
        }
        vEntries.emplace_back(row, row, weight);
        if (isFixed(columnVertex))
        {
          vRight[row] += weight * (second.count(columnVertex) > 0 ? 1.0 : 0.0);
        }
        else
        {
          vEntries.emplace_back(row, column, -weight);
        }
      };
      addV(a, from, b, to);
      addV(b, to, a, from);
    }
  }
  uEntries.emplace_back(pinned, pinned, 1.0);
  for (int i = 0; i < n; ++i)
  {
    if (isFixed(this->Vertices[i]))
    {
      vEntries.emplace_back(i, i, 1.0);
      vRight[i] = second.count(this->Vertices[i]) > 0 ? 1.0 : 0.0;
    }
  }
  const auto solve = [n](const std::vector<Eigen::Triplet<double>>& entries,
                       const Eigen::VectorXd& right, Eigen::VectorXd& values)
  {
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success)
    {
      return false;
    }
    values = solver.solve(right);
    return values.allFinite();
  };
  Eigen::VectorXd u;
  Eigen::VectorXd v;
  if (!solve(uEntries, uRight, u) || !solve(vEntries, vRight, v))
  {
    return false;
  }
  this->VertexUv.resize(n);
  for (int i = 0; i < n; ++i)
  {
    this->VertexUv[i] = { u[i], v[i] };
  }
  this->Uv.resize(this->Region.Triangles.size());
  for (std::size_t i = 0; i < this->Region.Triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int local = this->LocalOfVertex.at(this->Mesh->Triangles[this->Region.Triangles[i]][k]);
      this->Uv[i][k] = { u[local] + jumps[i][k], v[local] };
    }
  }
  return true;
}

std::optional<CylinderMap> CylinderMap::Build(PathFinder& paths, const TriangleMesh& mesh,
  CoveringRegion region, const Eigen::Vector3d& center, const Eigen::Vector3d& axis)
{
  CylinderMap map(mesh, std::move(region));
  if (!map.Solve(paths))
  {
    return {};
  }
  // The sum over the triangles of du ∧ (axis × position): positive if u runs right-handed.
  double turn = 0.0;
  for (std::size_t i = 0; i < map.Uv.size(); ++i)
  {
    const auto& corners = mesh.Triangles[map.Region.Triangles[i]];
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      const Eigen::Vector3d step = mesh.Points[corners[next]] - mesh.Points[corners[k]];
      const Eigen::Vector3d middle =
        0.5 * (mesh.Points[corners[next]] + mesh.Points[corners[k]]) - center;
      turn += (map.Uv[i][next].x() - map.Uv[i][k].x()) * axis.cross(middle).dot(step);
    }
  }
  if (turn < 0.0)
  {
    for (auto& corners : map.Uv)
    {
      for (auto& uv : corners)
      {
        uv.x() = -uv.x();
      }
    }
    for (auto& uv : map.VertexUv)
    {
      uv.x() = -uv.x();
    }
  }
  return map;
}

Eigen::Vector2d CylinderMap::OfVertex(int vertex) const
{
  const Eigen::Vector2d& uv = this->VertexUv[this->LocalOfVertex.at(vertex)];
  return { Wrap(uv.x()), uv.y() };
}

void CylinderMap::Rotate(double offset)
{
  for (auto& corners : this->Uv)
  {
    for (auto& uv : corners)
    {
      uv.x() += offset;
    }
  }
  for (auto& uv : this->VertexUv)
  {
    uv.x() += offset;
  }
}

Eigen::Vector3d CylinderMap::PointAt(const Eigen::Vector2d& uv) const
{
  double bestOutside = std::numeric_limits<double>::infinity();
  Eigen::Vector3d best = this->Mesh->Points[this->Vertices.front()];
  for (std::size_t i = 0; i < this->Uv.size(); ++i)
  {
    const Eigen::Vector2d& a = this->Uv[i][0];
    const Eigen::Vector2d e1 = this->Uv[i][1] - a;
    const Eigen::Vector2d e2 = this->Uv[i][2] - a;
    const double determinant = e1.x() * e2.y() - e1.y() * e2.x();
    if (determinant == 0.0)
    {
      continue;
    }
    // The turn of u that is nearest to the triangle.
    const double middle = a.x() + (e1.x() + e2.x()) / 3.0;
    const double u = uv.x() + std::round(middle - uv.x());
    const Eigen::Vector2d d(u - a.x(), uv.y() - a.y());
    double s = (d.x() * e2.y() - d.y() * e2.x()) / determinant;
    double t = (e1.x() * d.y() - e1.y() * d.x()) / determinant;
    const double outside = std::max({ -s, -t, s + t - 1.0, 0.0 });
    if (outside < bestOutside)
    {
      bestOutside = outside;
      s = std::clamp(s, 0.0, 1.0);
      t = std::clamp(t, 0.0, 1.0 - s);
      const auto& corners = this->Mesh->Triangles[this->Region.Triangles[i]];
      best = (1.0 - s - t) * this->Mesh->Points[corners[0]] + s * this->Mesh->Points[corners[1]] +
        t * this->Mesh->Points[corners[2]];
      if (outside <= 0.0)
      {
        break;
      }
    }
  }
  return best;
}

namespace
{
/// 5 degrees apart.
constexpr int NumberOfRimSamples = 72;

/// Both rims' places in the plane of `axes` at evenly spaced u, centred and scaled to unit size.
std::vector<Eigen::Vector2d> SampleRims(
  const TriangleMesh& mesh, const CylinderMap& map, const Eigen::Matrix<double, 3, 2>& axes)
{
  std::vector<Eigen::Vector2d> samples;
  for (const std::vector<int>& rim : map.GetRegion().Rims)
  {
    std::vector<std::pair<double, Eigen::Vector2d>> places;
    for (int vertex : rim)
    {
      places.emplace_back(map.OfVertex(vertex).x(), axes.transpose() * mesh.Points[vertex]);
    }
    std::sort(
      places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    const std::size_t begin = samples.size();
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (int k = 0; k < NumberOfRimSamples; ++k)
    {
      const double u = static_cast<double>(k) / NumberOfRimSamples;
      const auto above = std::upper_bound(places.begin(), places.end(), u,
        [](double value, const auto& place) { return value < place.first; });
      const auto& next = above == places.end() ? places.front() : *above;
      const auto& previous = above == places.begin() ? places.back() : *(above - 1);
      const double span = Wrap(next.first - previous.first);
      const double t = span > 0.0 ? Wrap(u - previous.first) / span : 0.0;
      samples.push_back((1.0 - t) * previous.second + t * next.second);
      mean += samples.back() / NumberOfRimSamples;
    }
    double size = 0.0;
    for (std::size_t i = begin; i < samples.size(); ++i)
    {
      samples[i] -= mean;
      size += samples[i].squaredNorm() / NumberOfRimSamples;
    }
    for (std::size_t i = begin; i < samples.size(); ++i)
    {
      samples[i] /= std::sqrt(std::max(size, 1e-300));
    }
  }
  return samples;
}
}

double FindRotation(const TriangleMesh& sourceMesh, const CylinderMap& source,
  const Eigen::Matrix<double, 3, 2>& sourceAxes, const TriangleMesh& targetMesh,
  const CylinderMap& target, const Eigen::Matrix<double, 3, 2>& targetAxes)
{
  const auto sources = SampleRims(sourceMesh, source, sourceAxes);
  const auto targets = SampleRims(targetMesh, target, targetAxes);
  std::vector<double> sums(NumberOfRimSamples, 0.0);
  for (int shift = 0; shift < NumberOfRimSamples; ++shift)
  {
    for (int rim = 0; rim < 2; ++rim)
    {
      for (int k = 0; k < NumberOfRimSamples; ++k)
      {
        const int at = rim * NumberOfRimSamples;
        sums[shift] +=
          (sources[at + k] - targets[at + (k + NumberOfRimSamples - shift) % NumberOfRimSamples])
            .squaredNorm();
      }
    }
  }
  const int best = static_cast<int>(std::min_element(sums.begin(), sums.end()) - sums.begin());
  // The parabola through the least value and its neighbours places it between samples.
  const double before = sums[(best + NumberOfRimSamples - 1) % NumberOfRimSamples];
  const double after = sums[(best + 1) % NumberOfRimSamples];
  const double bend = before - 2.0 * sums[best] + after;
  const double shift = bend > 0.0 ? 0.5 * (before - after) / bend : 0.0;
  return Wrap((best + shift) / NumberOfRimSamples);
}
}
