// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonTriangulation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <queue>

namespace marrow
{
namespace
{
/// Corners nearer to a straight line than this share of their distances are straight: what the
/// rounding of a few operations can make of three points on a line.
constexpr double Straight = 64.0 * std::numeric_limits<double>::epsilon();

bool IsBefore(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

class EarClipper
{
public:
  explicit EarClipper(const std::vector<Eigen::Vector3d>& corners)
    : Corners(corners)
    , Size(static_cast<int>(corners.size()))
    , Next(corners.size())
    , Previous(corners.size())
    , Version(corners.size(), 0)
    , Clipped(corners.size(), 0)
  {
    for (int i = 0; i < this->Size; ++i)
    {
      this->Next[i] = (i + 1) % this->Size;
      this->Previous[i] = (i + this->Size - 1) % this->Size;
      // Newell's normal, about a corner to keep digits.
      this->Normal += (corners[i] - corners[0]).cross(corners[this->Next[i]] - corners[0]);
    }
    const double length = this->Normal.norm();
    if (length > 0.0)
    {
      this->Normal /= length;
    }
  }

  std::vector<std::array<int, 3>> Clip()
  {
    this->PushAll();
    int left = this->Size;
    bool clippedSincePush = false;
    while (left > 3)
    {
      int ear = -1;
      while (ear < 0 && !this->Candidates.empty())
      {
        const Candidate candidate = this->Candidates.top();
        this->Candidates.pop();
        if (!this->Clipped[candidate.Corner] &&
          candidate.Version == this->Version[candidate.Corner] && this->IsEar(candidate.Corner))
        {
          ear = candidate.Corner;
        }
      }
      if (ear < 0 && clippedSincePush)
      {
        // What stood in an ear may be gone by now.
        this->PushAll();
        clippedSincePush = false;
        continue;
      }
      this->ClipCorner(ear < 0 ? this->ShortestDiagonal() : ear);
      clippedSincePush = true;
      --left;
    }
    const int last = static_cast<int>(
      std::find(this->Clipped.begin(), this->Clipped.end(), 0) - this->Clipped.begin());
    this->Triangles.push_back({ last, this->Next[last], this->Next[this->Next[last]] });
    return this->Triangles;
  }

private:
  struct Candidate
  {
    double Diagonal;
    Eigen::Vector3d Place;
    int Corner;
    int Version;
    bool operator<(const Candidate& other) const
    {
      return Diagonal != other.Diagonal ? Diagonal > other.Diagonal : IsBefore(other.Place, Place);
    }
  };

  double Diagonal(int i) const
  {
    return (this->Corners[this->Next[i]] - this->Corners[this->Previous[i]]).squaredNorm();
  }

  /// Twice the signed area of a triangle as seen along the normal.
  double Area(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) const
  {
    return (b - a).cross(c - a).dot(this->Normal);
  }

  bool IsConvex(int i) const
  {
    const Eigen::Vector3d& a = this->Corners[this->Previous[i]];
    const Eigen::Vector3d& b = this->Corners[i];
    const Eigen::Vector3d& c = this->Corners[this->Next[i]];
    return this->Area(a, b, c) > Straight * (b - a).norm() * (c - b).norm();
  }

  bool IsEar(int i) const
  {
    if (!this->IsConvex(i))
    {
      return false;
    }
    const Eigen::Vector3d& a = this->Corners[this->Previous[i]];
    const Eigen::Vector3d& b = this->Corners[i];
    const Eigen::Vector3d& c = this->Corners[this->Next[i]];
    for (int j = this->Next[this->Next[i]]; j != this->Previous[i]; j = this->Next[j])
    {
      const Eigen::Vector3d& p = this->Corners[j];
      if (p != a && p != b && p != c && this->Area(a, b, p) >= 0.0 && this->Area(b, c, p) >= 0.0 &&
        this->Area(c, a, p) >= 0.0 && !this->IsConvex(j))
      {
        return false;
      }
    }
    return true;
  }

  void Push(int i)
  {
    this->Candidates.push({ this->Diagonal(i), this->Corners[i], i, ++this->Version[i] });
  }

  void PushAll()
  {
    for (int i = 0; i < this->Size; ++i)
    {
      if (!this->Clipped[i])
      {
        this->Push(i);
      }
    }
  }

  int ShortestDiagonal() const
  {
    int best = -1;
    for (int i = 0; i < this->Size; ++i)
    {
      if (!this->Clipped[i] && (best < 0 || this->Diagonal(i) < this->Diagonal(best)))
      {
        best = i;
      }
    }
    return best;
  }

  void ClipCorner(int i)
  {
    const int before = this->Previous[i];
    const int after = this->Next[i];
    this->Triangles.push_back({ before, i, after });
    this->Clipped[i] = 1;
    this->Next[before] = after;
    this->Previous[after] = before;
    this->Push(before);
    this->Push(after);
  }

  const std::vector<Eigen::Vector3d>& Corners;
  int Size;
  Eigen::Vector3d Normal = Eigen::Vector3d::Zero();
  std::vector<int> Next;
  std::vector<int> Previous;
  std::vector<int> Version;
  std::vector<char> Clipped;
  std::priority_queue<Candidate> Candidates;
  std::vector<std::array<int, 3>> Triangles;
};
}

std::vector<std::array<int, 3>> TriangulatePolygon(const std::vector<Eigen::Vector3d>& corners)
{
  return EarClipper(corners).Clip();
}

int TriangulatePolygons(const PolygonMesh& input, MendedMesh& output)
{
  int cut = 0;
  output.Mesh.Points = input.Points;
  output.PointOfVertex.resize(input.Points.size());
  for (int i = 0; i < input.NumberOfPoints(); ++i)
  {
    output.PointOfVertex[i] = i;
  }
  output.Mesh.Triangles.reserve(input.NumberOfPolygons());
  output.CellOfTriangle.reserve(input.NumberOfPolygons());
  std::vector<int> corners;
  std::vector<Eigen::Vector3d> places;
  for (int c = 0; c < input.NumberOfPolygons(); ++c)
  {
    corners.assign(input.CornersOf(c), input.CornersOf(c) + input.SizeOf(c));
    if (corners.size() > 3)
    {
      corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
      while (corners.size() > 1 && corners.front() == corners.back())
      {
        corners.pop_back();
      }
    }
    if (corners.size() < 3)
    {
      continue;
    }
    if (corners.size() == 3)
    {
      output.Mesh.Triangles.push_back({ corners[0], corners[1], corners[2] });
      output.CellOfTriangle.push_back(c);
      continue;
    }
    ++cut;
    places.clear();
    for (int corner : corners)
    {
      places.push_back(input.Points[corner]);
    }
    for (const auto& triangle : TriangulatePolygon(places))
    {
      output.Mesh.Triangles.push_back(
        { corners[triangle[0]], corners[triangle[1]], corners[triangle[2]] });
      output.CellOfTriangle.push_back(c);
    }
  }
  return cut;
}
}
