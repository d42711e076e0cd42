// SPDX-License-Identifier: BSD-3-Clause
#include "CoveringRegion.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace marrow
{
namespace
{
/// How far along `direction` (in multiples of it) a ray meets the triangle; infinite if not.
double MeetTriangle(const TriangleMesh& mesh, int triangle, const Eigen::Vector3d& origin,
  const Eigen::Vector3d& direction)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  const auto& corners = mesh.Triangles[triangle];
  const Eigen::Vector3d& a = mesh.Points[corners[0]];
  const Eigen::Vector3d e1 = mesh.Points[corners[1]] - a;
  const Eigen::Vector3d e2 = mesh.Points[corners[2]] - a;
  const Eigen::Vector3d p = direction.cross(e2);
  const double determinant = e1.dot(p);
  if (determinant == 0.0)
  {
    return none;
  }
  const Eigen::Vector3d s = origin - a;
  const double u = s.dot(p) / determinant;
  const Eigen::Vector3d q = s.cross(e1);
  const double v = direction.dot(q) / determinant;
  const double t = e2.dot(q) / determinant;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 ? t : none;
}

/// Joins the seeds to a closed chain of vertices.
std::vector<int> ConnectSeeds(const TriangleMesh& mesh, PathFinder& paths,
  const FittingPlane& plane, const std::vector<int>& seeds)
{
  const auto cost = [&](int from, int to)
  {
    return (mesh.Points[to] - mesh.Points[from]).norm() + std::abs(plane.Offset(mesh.Points[to])) +
      std::abs(plane.Offset(mesh.Points[from]));
  };
  std::vector<int> ring;
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    const int goal = seeds[(i + 1) % seeds.size()];
    const std::vector<int> path = paths.Find(
      { seeds[i] }, [goal](int v) { return v == goal; }, cost);
    if (path.empty())
    {
      return {};
    }
    ring.insert(ring.end(), path.begin(), path.end() - 1);
  }
  return ring;
}

class Band
{
public:
  Band(const TriangleMesh& mesh, std::vector<bool> isIn)
    : Mesh(mesh)
    , IsIn(std::move(isIn))
  {
  }

  /// Adds every part of the rest of the surface but the two largest: two ends are what an annulus
  /// leaves over, or one if the surface goes on round a handle.
  void FillHoles()
  {
    std::vector<int> component(this->Mesh.NumberOfTriangles(), -1);
    std::vector<double> areas;
    std::vector<int> stack;
    for (int first = 0; first < this->Mesh.NumberOfTriangles(); ++first)
    {
      if (this->IsIn[first] || component[first] >= 0)
      {
        continue;
      }
      const int id = static_cast<int>(areas.size());
      areas.push_back(0.0);
      component[first] = id;
      stack.assign(1, first);
      while (!stack.empty())
      {
        const int triangle = stack.back();
        stack.pop_back();
        areas[id] += this->Mesh.Area(triangle);
        for (int h = 3 * triangle; h < 3 * triangle + 3; ++h)
        {
          const int opposite = this->Mesh.Opposite[h];
          const int next = opposite < 0 ? -1 : TriangleMesh::TriangleOf(opposite);
          if (next >= 0 && !this->IsIn[next] && component[next] < 0)
          {
            component[next] = id;
            stack.push_back(next);
          }
        }
      }
    }
    if (areas.size() <= 2)
    {
      return;
    }
    std::vector<double> sorted = areas;
    std::nth_element(sorted.begin(), sorted.begin() + 1, sorted.end(), std::greater<>());
    for (int t = 0; t < this->Mesh.NumberOfTriangles(); ++t)
    {
      this->IsIn[t] = this->IsIn[t] || areas[component[t]] < sorted[1];
    }
  }

  /// Adds the 1-rings of vertices where the border touches itself; true if there were any.
  bool GrowPinches()
  {
    std::vector<int> pinched;
    for (int v = 0; v < this->Mesh.NumberOfVertices(); ++v)
    {
      int starts = 0;
      this->Mesh.ForEachOutgoing(v, [&](int h) { starts += this->IsBorder(h) ? 1 : 0; });
      if (starts > 1)
      {
        pinched.push_back(v);
      }
    }
    for (int v : pinched)
    {
      this->Mesh.ForEachOutgoing(v, [&](int h) { this->IsIn[TriangleMesh::TriangleOf(h)] = true; });
    }
    return !pinched.empty();
  }

  /// The region if it is an annulus.
  std::optional<CoveringRegion> Annulus(const FittingPlane& plane) const
  {
    CoveringRegion region;
    std::unordered_map<int, int> nextOnBorder;
    std::vector<bool> isVertex(this->Mesh.NumberOfVertices(), false);
    int vertices = 0;
    int halfEdges = 0;
    int borders = 0;
    for (int t = 0; t < this->Mesh.NumberOfTriangles(); ++t)
    {
      if (!this->IsIn[t])
      {
        continue;
      }
      region.Triangles.push_back(t);
      for (int h = 3 * t; h < 3 * t + 3; ++h)
      {
        vertices += isVertex[this->Mesh.From(h)] ? 0 : 1;
        isVertex[this->Mesh.From(h)] = true;
        ++halfEdges;
        if (this->IsBorder(h))
        {
          ++borders;
          if (!nextOnBorder.insert({ this->Mesh.From(h), this->Mesh.To(h) }).second)
          {
            return {};
          }
        }
      }
    }
    const int edges = (halfEdges + borders) / 2;
    if (vertices - edges + static_cast<int>(region.Triangles.size()) != 0)
    {
      return {};
    }
    std::vector<std::vector<int>> rims;
    for (int t : region.Triangles)
    {
      for (int h = 3 * t; h < 3 * t + 3; ++h)
      {
        if (!this->IsBorder(h) || nextOnBorder.count(this->Mesh.From(h)) == 0)
        {
          continue;
        }
        rims.emplace_back();
        auto at = nextOnBorder.find(this->Mesh.From(h));
        while (at != nextOnBorder.end())
        {
          const int next = at->second;
          rims.back().push_back(at->first);
          nextOnBorder.erase(at);
          at = nextOnBorder.find(next);
        }
      }
    }
    if (rims.size() != 2)
    {
      return {};
    }
    const auto meanOffset = [&](const std::vector<int>& rim)
    {
      double sum = 0.0;
      for (int v : rim)
      {
        sum += plane.Offset(this->Mesh.Points[v]);
      }
      return sum / rim.size();
    };
    const bool swapped = meanOffset(rims[0]) > meanOffset(rims[1]);
    region.Rims[0] = std::move(rims[swapped ? 1 : 0]);
    region.Rims[1] = std::move(rims[swapped ? 0 : 1]);
    return region;
  }

private:
  bool IsBorder(int h) const
  {
    const int opposite = this->Mesh.Opposite[h];
    return this->IsIn[TriangleMesh::TriangleOf(h)] &&
      (opposite < 0 || !this->IsIn[TriangleMesh::TriangleOf(opposite)]);
  }

  const TriangleMesh& Mesh;
  std::vector<bool> IsIn;
};

/// The triangles round `ring`, `mustCover` and all vertices connected with them for which
/// `isInside` holds.
std::vector<bool> GrowBand(const TriangleMesh& mesh, const std::vector<int>& ring,
  const std::vector<int>& mustCover, const std::function<bool(int)>& isInside)
{
  std::vector<bool> reached(mesh.NumberOfVertices(), false);
  std::vector<int> stack;
  for (const std::vector<int>* seeds : { &ring, &mustCover })
  {
    for (int v : *seeds)
    {
      if (!reached[v])
      {
        reached[v] = true;
        stack.push_back(v);
      }
    }
  }
  while (!stack.empty())
  {
    const int vertex = stack.back();
    stack.pop_back();
    mesh.ForEachNeighbor(vertex,
      [&](int next)
      {
        if (!reached[next] && isInside(next))
        {
          reached[next] = true;
          stack.push_back(next);
        }
      });
  }
  std::vector<bool> isIn(mesh.NumberOfTriangles());
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const auto& corners = mesh.Triangles[t];
    isIn[t] = reached[corners[0]] || reached[corners[1]] || reached[corners[2]];
  }
  return isIn;
}
}

std::vector<int> SeedsOfRays(const TriangleMesh& mesh, const Eigen::Vector3d& center,
  const std::vector<Eigen::Vector3d>& rayEnds)
{
  double longest = 0.0;
  for (const Eigen::Vector3d& end : rayEnds)
  {
    longest = std::max(longest, (end - center).norm());
  }
  std::vector<int> near;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const double reach = 2.0 * longest +
      (mesh.Points[mesh.Triangles[t][0]] - mesh.Points[mesh.Triangles[t][1]]).norm() +
      (mesh.Points[mesh.Triangles[t][0]] - mesh.Points[mesh.Triangles[t][2]]).norm();
    if ((mesh.Points[mesh.Triangles[t][0]] - center).squaredNorm() <= reach * reach)
    {
      near.push_back(t);
    }
  }
  std::vector<int> seeds;
  for (const Eigen::Vector3d& end : rayEnds)
  {
    const Eigen::Vector3d direction = end - center;
    double first = 2.0;
    int hit = -1;
    for (int t : near)
    {
      const double at = MeetTriangle(mesh, t, center, direction);
      if (at < first)
      {
        first = at;
        hit = t;
      }
    }
    const Eigen::Vector3d place = hit >= 0 ? Eigen::Vector3d(center + first * direction) : end;
    double least = std::numeric_limits<double>::infinity();
    int seed = -1;
    const auto consider = [&](int triangle)
    {
      for (int corner : mesh.Triangles[triangle])
      {
        const double distance = (mesh.Points[corner] - place).squaredNorm();
        if (distance < least)
        {
          least = distance;
          seed = corner;
        }
      }
    };
    if (hit >= 0)
    {
      consider(hit);
    }
    else
    {
      std::for_each(near.begin(), near.end(), consider);
    }
    if (seed >= 0 && (seeds.empty() || seeds.back() != seed))
    {
      seeds.push_back(seed);
    }
  }
  return seeds;
}

std::optional<CoveringRegion> BuildCoveringRegion(const TriangleMesh& mesh, PathFinder& paths,
  const FittingPlane& plane, const std::vector<int>& seeds, double halfWidth,
  const std::vector<int>& mustCover)
{
  const std::vector<int> ring = ConnectSeeds(mesh, paths, plane, seeds);
  if (ring.size() < 3)
  {
    return {};
  }
  const PathField field = DistanceField(mesh, ring, 3.0 * halfWidth);
  /// The whole width first; narrower ones where that is no ring.
  constexpr double narrower[] = { 1.0, 0.6, 0.3, 0.0 };
  for (const double share : narrower)
  {
    const double width = share * halfWidth;
    Band band(mesh,
      GrowBand(mesh, ring, mustCover,
        [&](int v) {
          return std::abs(plane.Offset(mesh.Points[v])) <= width &&
            field.Distance[v] <= 3.0 * width;
        }));
    bool grown = true;
    for (int round = 0; grown && round < 6; ++round)
    {
      band.FillHoles();
      grown = band.GrowPinches();
    }
    if (auto region = band.Annulus(plane))
    {
      return region;
    }
  }
  return {};
}
}
