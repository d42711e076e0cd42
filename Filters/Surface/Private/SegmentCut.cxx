// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentCut.h"

#include "Cotangent.h"
#include "PointWelding.h"
#include "PolygonTriangulation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace marrow
{
namespace
{
/// Steps of a boundary along edges are one or two faces long: smoothing over some three makes it a line
/// and leaves bends that are longer.
constexpr int NumberOfSmoothings = 8;
/// A cut nearer to the end of an edge, as a share of its length, would leave a sliver.
constexpr double LeastShareOfEdge = 0.05;

/// What share of a vertex's surroundings each segment has, by ascending label.
using Shares = std::map<int, double>;

double ShareOf(const Shares& shares, int label)
{
  const auto found = shares.find(label);
  return found != shares.end() ? found->second : 0.0;
}

/// Of equal ones the lowest label.
int LargestOf(const Shares& shares)
{
  return std::max_element(
    shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
    ->first;
}

double AreaOf(const PolygonMesh& mesh, int polygon)
{
  const int* corners = mesh.CornersOf(polygon);
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (int k = 1; k + 1 < mesh.SizeOf(polygon); ++k)
  {
    const Eigen::Vector3d& origin = mesh.Points[corners[0]];
    area += (mesh.Points[corners[k]] - origin).cross(mesh.Points[corners[k + 1]] - origin);
  }
  return 0.5 * area.norm();
}

/// The vertices, one for all points at a place, with what the segments have of them.
class VertexShares
{
public:
  VertexShares(const PolygonMesh& mesh, const std::vector<int>& labels)
    : Vertex(FirstEqualPoint(mesh.Points))
    , Neighbors(mesh.Points.size())
    , OfVertex(mesh.Points.size())
  {
    for (int p = 0; p < mesh.NumberOfPolygons(); ++p)
    {
      const double area = AreaOf(mesh, p);
      const int* corners = mesh.CornersOf(p);
      for (int k = 0; k < mesh.SizeOf(p); ++k)
      {
        this->OfVertex[this->Vertex[corners[k]]][labels[p]] += area;
      }
      // A polygon is a fan of triangles here.
      for (int k = 1; k + 1 < mesh.SizeOf(p); ++k)
      {
        this->AddTriangle(mesh, { corners[0], corners[k], corners[k + 1] });
      }
    }
    for (Shares& shares : this->OfVertex)
    {
      Normalize(shares);
    }
  }

  bool Smooth(const Progress& progress)
  {
    const std::vector<int> band = this->VerticesNearBoundaries();
    for (int round = 0; round < NumberOfSmoothings; ++round)
    {
      if (!Report(progress, static_cast<double>(round) / NumberOfSmoothings))
      {
        return false;
      }
      std::vector<Shares> smoothed;
      smoothed.reserve(band.size());
      for (const int v : band)
      {
        smoothed.push_back(this->MeanAround(v));
      }
      for (std::size_t i = 0; i < band.size(); ++i)
      {
        this->OfVertex[band[i]] = std::move(smoothed[i]);
      }
    }
    return true;
  }

  int VertexOf(int point) const { return this->Vertex[point]; }
  int LabelOf(int vertex) const { return LargestOf(this->OfVertex[vertex]); }
  double ShareAt(int vertex, int label) const { return ShareOf(this->OfVertex[vertex], label); }

private:
  /// Cotangent weights, so that on triangles of uneven size and form a straight boundary stays straight.
  void AddTriangle(const PolygonMesh& mesh, const std::array<int, 3>& corners)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = corners[k];
      const int b = corners[(k + 1) % 3];
      const int from = this->Vertex[a];
      const int to = this->Vertex[b];
      constexpr double least = 0.01; // a negative one would push shares away
      const double weight = std::max(
        BoundedCotangent(mesh.Points[corners[(k + 2) % 3]], mesh.Points[a], mesh.Points[b]), least);
      if (from != to)
      {
        this->Neighbors[from].emplace_back(to, weight);
        this->Neighbors[to].emplace_back(from, weight);
      }
    }
  }

  static void Normalize(Shares& shares)
  {
    double total = 0.0;
    for (const auto& [label, area] : shares)
    {
      total += area;
    }
    for (auto& [label, area] : shares)
    {
      area = total > 0.0 ? area / total : 1.0 / static_cast<double>(shares.size());
    }
  }

  /// As far as smoothing carries.
  std::vector<int> VerticesNearBoundaries() const
  {
    std::vector<int> band;
    std::vector<char> isInBand(this->OfVertex.size(), 0);
    for (std::size_t v = 0; v < this->OfVertex.size(); ++v)
    {
      if (this->OfVertex[v].size() > 1)
      {
        band.push_back(static_cast<int>(v));
        isInBand[v] = 1;
      }
    }
    std::size_t first = 0;
    for (int ring = 0; ring < NumberOfSmoothings; ++ring)
    {
      const std::size_t last = band.size();
      for (; first < last; ++first)
      {
        for (const auto& [neighbor, weight] : this->Neighbors[band[first]])
        {
          if (!isInBand[neighbor])
          {
            isInBand[neighbor] = 1;
            band.push_back(neighbor);
          }
        }
      }
    }
    return band;
  }

  Shares MeanAround(int vertex) const
  {
    Shares mean;
    const auto add = [&](const Shares& shares, double weight)
    {
      for (const auto& [label, share] : shares)
      {
        mean[label] += weight * share;
      }
    };
    double weights = 0.0;
    for (const auto& [neighbor, weight] : this->Neighbors[vertex])
    {
      weights += weight;
    }
    add(this->OfVertex[vertex], weights > 0.0 ? 0.5 : 1.0);
    for (const auto& [neighbor, weight] : this->Neighbors[vertex])
    {
      add(this->OfVertex[neighbor], 0.5 * weight / weights);
    }
    return mean;
  }

  std::vector<int> Vertex;                                    ///< per point
  std::vector<std::vector<std::pair<int, double>>> Neighbors; ///< with weights; one may come twice
  std::vector<Shares> OfVertex;
};

class Cutter
{
public:
  Cutter(const PolygonMesh& mesh, const std::vector<int>& labels, const VertexShares& shares)
    : Mesh(mesh)
    , Labels(labels)
    , Vertices(shares)
    , LabelOfPoint(mesh.Points.size())
  {
    for (const int corner : mesh.Corners)
    {
      this->LabelOfPoint[corner] = shares.LabelOf(shares.VertexOf(corner));
      this->Present.insert(this->LabelOfPoint[corner]);
    }
  }

  void Cut(int polygon)
  {
    const int* corners = this->Mesh.CornersOf(polygon);
    const int size = this->Mesh.SizeOf(polygon);
    const bool isWhole = size < 3 ||
      std::all_of(corners, corners + size,
        [&](int corner) { return this->LabelOfPoint[corner] == this->LabelOfPoint[corners[0]]; });
    if (isWhole)
    {
      this->AddPiece(polygon, std::vector<int>(corners, corners + size),
        size < 3 ? this->Labels[polygon] : this->LabelOfPoint[corners[0]]);
      return;
    }
    std::vector<Eigen::Vector3d> positions;
    for (int k = 0; k < size; ++k)
    {
      positions.push_back(this->Mesh.Points[corners[k]]);
    }
    for (const auto& [a, b, c] : TriangulatePolygon(positions))
    {
      this->CutTriangle(polygon, { corners[a], corners[b], corners[c] });
    }
  }

  SegmentCut Result;

private:
  void CutTriangle(int polygon, std::array<int, 3> corners)
  {
    const auto label = [&](int k) { return this->LabelOfPoint[corners[k]]; };
    if (label(0) == label(1) && label(1) == label(2))
    {
      this->AddPiece(polygon, { corners[0], corners[1], corners[2] }, label(0));
    }
    else if (label(0) != label(1) && label(1) != label(2) && label(2) != label(0))
    {
      this->CutInThree(polygon, corners);
    }
    else
    {
      // The corner that stands alone comes first.
      const int alone = label(0) == label(1) ? 2 : label(0) == label(2) ? 1 : 0;
      std::rotate(corners.begin(), corners.begin() + alone, corners.end());
      const int first = this->CutOfEdge(corners[0], corners[1]);
      const int second = this->CutOfEdge(corners[0], corners[2]);
      this->AddPiece(polygon, { corners[0], first, second }, label(0));
      if ((this->Position(first) - this->Position(corners[2])).squaredNorm() <
        (this->Position(second) - this->Position(corners[1])).squaredNorm())
      {
        this->AddPiece(polygon, { first, corners[1], corners[2] }, label(1));
        this->AddPiece(polygon, { first, corners[2], second }, label(1));
      }
      else
      {
        this->AddPiece(polygon, { first, corners[1], second }, label(1));
        this->AddPiece(polygon, { second, corners[1], corners[2] }, label(1));
      }
    }
  }

  void CutInThree(int polygon, const std::array<int, 3>& corners)
  {
    SegmentCut::NewPoint middle;
    std::array<int, 3> cuts = {};
    for (int k = 0; k < 3; ++k)
    {
      cuts[k] = this->CutOfEdge(corners[k], corners[(k + 1) % 3]);
      middle.Points[k] = corners[k];
    }
    // The mean of the three cuts, in terms of the corners.
    for (int k = 0; k < 3; ++k)
    {
      const SegmentCut::NewPoint& cut =
        this->Result.NewPoints[cuts[k] - this->Mesh.NumberOfPoints()];
      for (int end = 0; end < 2; ++end)
      {
        const bool isFrom =
          this->Vertices.VertexOf(cut.Points[end]) == this->Vertices.VertexOf(corners[k]);
        middle.Weights[isFrom ? k : (k + 1) % 3] += cut.Weights[end] / 3.0;
      }
    }
    middle.Size = 3;
    const int center = this->AddPoint(middle);
    for (int k = 0; k < 3; ++k)
    {
      const int label = this->LabelOfPoint[corners[k]];
      this->AddPiece(polygon, { corners[k], cuts[k], center }, label);
      this->AddPiece(polygon, { corners[k], center, cuts[(k + 2) % 3] }, label);
    }
  }

  /// Where the boundary crosses an edge whose ends have different labels; the same for all faces there.
  int CutOfEdge(int a, int b)
  {
    if (this->Vertices.VertexOf(a) > this->Vertices.VertexOf(b))
    {
      std::swap(a, b);
    }
    const int from = this->Vertices.VertexOf(a);
    const int to = this->Vertices.VertexOf(b);
    const auto [entry, isNew] = this->CutOfVertices.emplace(std::pair{ from, to }, -1);
    if (isNew)
    {
      const int near = this->LabelOfPoint[a];
      const int far = this->LabelOfPoint[b];
      const double atFrom = this->Vertices.ShareAt(from, near) - this->Vertices.ShareAt(from, far);
      const double atTo = this->Vertices.ShareAt(to, far) - this->Vertices.ShareAt(to, near);
      const double sum = atFrom + atTo;
      const double t =
        std::clamp(sum > 0.0 ? atFrom / sum : 0.5, LeastShareOfEdge, 1.0 - LeastShareOfEdge);
      entry->second = this->AddPoint({ { from, to, -1 }, { 1.0 - t, t, 0.0 }, 2 });
    }
    return entry->second;
  }

  int AddPoint(const SegmentCut::NewPoint& point)
  {
    this->Result.NewPoints.push_back(point);
    return this->Mesh.NumberOfPoints() + static_cast<int>(this->Result.NewPoints.size()) - 1;
  }

  Eigen::Vector3d Position(int point) const
  {
    const int index = point - this->Mesh.NumberOfPoints();
    if (index < 0)
    {
      return this->Mesh.Points[point];
    }
    const SegmentCut::NewPoint& made = this->Result.NewPoints[index];
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    for (int k = 0; k < made.Size; ++k)
    {
      position += made.Weights[k] * this->Mesh.Points[made.Points[k]];
    }
    return position;
  }

  void AddPiece(int polygon, const std::vector<int>& corners, int label)
  {
    const int own = this->Labels[polygon];
    this->Result.Corners.insert(this->Result.Corners.end(), corners.begin(), corners.end());
    this->Result.Offsets.push_back(static_cast<int>(this->Result.Corners.size()));
    this->Result.PolygonOfPiece.push_back(polygon);
    this->Result.LabelOfPiece.push_back(this->Present.count(own) > 0 ? label : own);
  }

  const PolygonMesh& Mesh;
  const std::vector<int>& Labels;
  const VertexShares& Vertices;
  std::vector<int> LabelOfPoint;
  std::set<int> Present; ///< labels that some vertex has
  std::map<std::pair<int, int>, int> CutOfVertices;
};
}

SegmentCut CutAlongSegments(
  const PolygonMesh& mesh, const std::vector<int>& labelOfPolygon, const Progress& progress)
{
  VertexShares shares(mesh, labelOfPolygon);
  if (!shares.Smooth(SubProgress(progress, 0.2, 0.8)))
  {
    return {};
  }
  Cutter cutter(mesh, labelOfPolygon, shares);
  for (int p = 0; p < mesh.NumberOfPolygons(); ++p)
  {
    cutter.Cut(p);
  }
  Report(progress, 1.0);
  return std::move(cutter.Result);
}
}
