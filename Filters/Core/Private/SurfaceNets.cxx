// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceNets.h"

#include "ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <unordered_map>

namespace marrow
{
namespace
{
/// Cells a side of a block that is looked at only if the surface may pass it; time alone.
constexpr int BlockSize = 8;
constexpr int BlockPoints = BlockSize + 1;
/// What rounding may take from a distance.
constexpr double WithRounding = 1.0001;

using Index = Eigen::Vector3i;

std::int64_t Key(const Index& cell)
{
  // 21 bits an axis; cells may lie one before the first.
  return ((static_cast<std::int64_t>(cell[2]) + 1) << 42) |
    ((static_cast<std::int64_t>(cell[1]) + 1) << 21) | (static_cast<std::int64_t>(cell[0]) + 1);
}

/// The values at the grid points of one block.
class Block
{
public:
  explicit Block(const Index& first)
    : First(first)
    , Values(BlockPoints * BlockPoints * BlockPoints)
  {
  }

  void Evaluate(const std::function<double(const Eigen::Vector3d&)>& function,
    const Eigen::Vector3d& low, double spacing)
  {
    this->Evaluate(function, low, spacing, Index::Zero(), Index::Constant(BlockPoints));
  }

  double At(const Index& point) const
  {
    return this->Values[(point[2] * BlockPoints + point[1]) * BlockPoints + point[0]];
  }

  Index First; ///< of its cells
private:
  /// The points from `begin` up to `end`. Where the middle tells that the surface is further away
  /// than a grid edge is long, its value stands for all: only the sign will be asked for.
  void Evaluate(const std::function<double(const Eigen::Vector3d&)>& function,
    const Eigen::Vector3d& low, double spacing, const Index& begin, const Index& end)
  {
    const Index size = end - begin;
    // From the grid's origin, not the block's: blocks must agree on their common points.
    const Eigen::Vector3d middle =
      (this->First + begin).cast<double>() + 0.5 * (size - Index::Ones()).cast<double>();
    const double value = function(low + spacing * middle);
    const double reach = 0.5 * (size - Index::Ones()).cast<double>().norm() + 1.0;
    if (size.maxCoeff() == 1 || std::abs(value) > WithRounding * spacing * reach)
    {
      for (int z = begin[2]; z < end[2]; ++z)
      {
        for (int y = begin[1]; y < end[1]; ++y)
        {
          for (int x = begin[0]; x < end[0]; ++x)
          {
            this->Values[(z * BlockPoints + y) * BlockPoints + x] = value;
          }
        }
      }
      return;
    }
    // Eight parts; a part may be empty where an axis has one point left.
    for (int part = 0; part < 8; ++part)
    {
      Index first = begin;
      Index last = end;
      for (int k = 0; k < 3; ++k)
      {
        const int half = begin[k] + (size[k] + 1) / 2;
        ((part >> k & 1) ? first : last)[k] = half;
      }
      if ((last - first).minCoeff() > 0)
      {
        this->Evaluate(function, low, spacing, first, last);
      }
    }
  }

  std::vector<double> Values;
};

/// The blocks near the surface among those from `begin` up to `end`, by halves, so that the room away
/// from the surface costs next to nothing.
void FindBlocks(const std::function<double(const Eigen::Vector3d&)>& function,
  const Eigen::Vector3d& low, double spacing, const Index& begin, const Index& end,
  std::vector<Block>& active)
{
  const Index size = end - begin;
  const Eigen::Vector3d middle = begin.cast<double>() + 0.5 * size.cast<double>();
  const double reach = 0.5 * BlockSize * spacing * size.cast<double>().norm() * WithRounding;
  if (std::abs(function(low + BlockSize * spacing * middle)) > reach)
  {
    return;
  }
  int axis = 0;
  if (size.maxCoeff(&axis) == 1)
  {
    active.emplace_back(BlockSize * begin);
    return;
  }
  Index half = end;
  half[axis] = begin[axis] + size[axis] / 2;
  FindBlocks(function, low, spacing, begin, half, active);
  half = begin;
  half[axis] = begin[axis] + size[axis] / 2;
  FindBlocks(function, low, spacing, half, end, active);
}

template <typename Visit>
void ForEachCell(Visit&& visit)
{
  for (int z = 0; z < BlockSize; ++z)
  {
    for (int y = 0; y < BlockSize; ++y)
    {
      for (int x = 0; x < BlockSize; ++x)
      {
        visit(Index(x, y, z));
      }
    }
  }
}

/// The surface inside one cell: which of its 12 edges it crosses, and which of these belong to the
/// same sheet. Edge 4 * axis + side runs along the axis; bit 0 of side is the coordinate of its
/// ends on the next axis, bit 1 that on the one after.
class CellSurface
{
public:
  CellSurface(const Block& block, const Index& cell)
  {
    for (int edge = 0; edge < 12; ++edge)
    {
      const double a = block.At(cell + CornerOf(edge));
      const double b = block.At(cell + CornerOf(edge) + Index::Unit(edge / 4));
      this->Crossed[edge] = (a < 0.0) != (b < 0.0);
      this->Sheet[edge] = edge;
      if (this->Crossed[edge])
      {
        this->Place[edge] =
          CornerOf(edge).cast<double>() + a / (a - b) * Eigen::Vector3d::Unit(edge / 4);
      }
    }
    for (int face = 0; face < 6; ++face)
    {
      this->JoinAcross(block, cell, face / 2, face % 2);
    }
  }

  /// Appends a vertex per sheet, the mean of its crossings, and tells which edge got which.
  std::array<int, 12> AddVertices(
    const Eigen::Vector3d& corner, double spacing, std::vector<Eigen::Vector3d>& points) const
  {
    std::array<int, 12> vertexOfEdge;
    vertexOfEdge.fill(-1);
    for (int sheet = 0; sheet < 12; ++sheet)
    {
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      int count = 0;
      for (int edge = 0; edge < 12; ++edge)
      {
        if (this->Crossed[edge] && this->Sheet[edge] == sheet)
        {
          mean += this->Place[edge];
          ++count;
          vertexOfEdge[edge] = static_cast<int>(points.size());
        }
      }
      if (count > 0)
      {
        points.push_back(corner + spacing / count * mean);
      }
    }
    return vertexOfEdge;
  }

private:
  static Index CornerOf(int edge)
  {
    Index corner = Index::Zero();
    corner[(edge / 4 + 1) % 3] = edge & 1;
    corner[(edge / 4 + 2) % 3] = (edge >> 1) & 1;
    return corner;
  }

  void Join(int edge, int other)
  {
    const int from = this->Sheet[edge];
    const int to = this->Sheet[other];
    std::replace(this->Sheet.begin(), this->Sheet.end(), from, to);
  }

  /// Joins the edges that the surface connects across the face at `side` of the axis. Where it
  /// crosses all four, the two corners inside are taken as parted, so both cells agree.
  void JoinAcross(const Block& block, const Index& cell, int axis, int side)
  {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    // Edges along a, which is followed by b and the axis; edges along b, by the axis and a.
    const int alongA[2] = { 4 * a + 2 * side, 4 * a + 1 + 2 * side };
    const int alongB[2] = { 4 * b + side, 4 * b + side + 2 };
    std::array<int, 4> crossed{};
    int count = 0;
    for (int edge : { alongA[0], alongA[1], alongB[0], alongB[1] })
    {
      if (this->Crossed[edge])
      {
        crossed[count++] = edge;
      }
    }
    if (count == 2)
    {
      this->Join(crossed[0], crossed[1]);
    }
    for (int corner = 0; count == 4 && corner < 4; ++corner)
    {
      const int atA = corner & 1;
      const int atB = corner >> 1;
      if (block.At(cell + side * Index::Unit(axis) + atA * Index::Unit(a) + atB * Index::Unit(b)) <
        0.0)
      {
        this->Join(alongA[atB], alongB[atA]);
      }
    }
  }

  std::array<bool, 12> Crossed{};
  std::array<int, 12> Sheet{};
  std::array<Eigen::Vector3d, 12> Place;
};
}

TriangleMesh SurfaceNets(const std::function<double(const Eigen::Vector3d&)>& function,
  const Eigen::Vector3d& low, const Eigen::Vector3d& high, double spacing)
{
  const Index blocks = ((high - low) / (spacing * BlockSize)).array().floor().cast<int>() + 1;
  std::vector<Block> active;
  FindBlocks(function, low, spacing, Index::Zero(), blocks, active);
  std::sort(active.begin(), active.end(),
    [](const Block& a, const Block& b)
    {
      return std::lexicographical_compare(std::make_reverse_iterator(a.First.data() + 3),
        std::make_reverse_iterator(a.First.data()), std::make_reverse_iterator(b.First.data() + 3),
        std::make_reverse_iterator(b.First.data()));
    });
  ParallelFor(0, static_cast<int>(active.size()),
    [&](int begin, int end)
    {
      for (int b = begin; b < end; ++b)
      {
        active[b].Evaluate(function, low, spacing);
      }
    });

  TriangleMesh mesh;
  std::unordered_map<std::int64_t, std::array<int, 12>> verticesOfCell;
  for (const Block& block : active)
  {
    ForEachCell(
      [&](const Index& cell)
      {
        const Eigen::Vector3d corner = low + spacing * (block.First + cell).cast<double>();
        const int before = mesh.NumberOfVertices();
        const std::array<int, 12> vertices =
          CellSurface(block, cell).AddVertices(corner, spacing, mesh.Points);
        if (mesh.NumberOfVertices() > before)
        {
          verticesOfCell[Key(block.First + cell)] = vertices;
        }
      });
  }

  for (const Block& block : active)
  {
    ForEachCell(
      [&](const Index& cell)
      {
        const bool inside = block.At(cell) < 0.0;
        for (int axis = 0; axis < 3; ++axis)
        {
          if (inside == (block.At(cell + Index::Unit(axis)) < 0.0))
          {
            continue;
          }
          // The four cells around the edge, counter-clockwise as seen from its far end.
          const Index u = Index::Unit((axis + 1) % 3);
          const Index v = Index::Unit((axis + 2) % 3);
          const Index here = block.First + cell;
          auto vertex = [&](const Index& at, int side)
          {
            const auto found = verticesOfCell.find(Key(at));
            return found != verticesOfCell.end() ? found->second[4 * axis + side] : -1;
          };
          std::array<int, 4> quad{ vertex(here, 0), vertex(here - u, 1), vertex(here - u - v, 3),
            vertex(here - v, 2) };
          if (*std::min_element(quad.begin(), quad.end()) < 0)
          {
            continue; // left out on the strength of a function that changes too fast
          }
          if (!inside)
          {
            std::swap(quad[1], quad[3]);
          }
          const auto& points = mesh.Points;
          const int k = (points[quad[0]] - points[quad[2]]).squaredNorm() <=
              (points[quad[1]] - points[quad[3]]).squaredNorm()
            ? 0
            : 1;
          mesh.Triangles.push_back({ quad[k], quad[k + 1], quad[k + 2] });
          mesh.Triangles.push_back({ quad[k], quad[k + 2], quad[(k + 3) % 4] });
        }
      });
  }
  mesh.BuildConnectivity();
  return mesh;
}
}
