// SPDX-License-Identifier: BSD-3-Clause
#include "SharesCut.h"

#include "EdgePrices.h"
#include "FaceLabels.h"
#include "LabelCleanUp.h"
#include "SegmentLoops.h"

#include <algorithm>
#include <numeric>

namespace marrow
{
namespace
{
/// Pieces vary in size from mesh to mesh, but hardly ever by more than this.
constexpr double LeastOfSmallest = 0.25;

/// The columns of the triangles without islands.
std::vector<int> WithoutIslands(const TriangleMesh& mesh, const std::vector<int>& columns,
  const std::vector<int>& labels, const LabelHabits& habits)
{
  const SegmentPieces pieces = FindPieces(mesh, columns);
  const double area = std::accumulate(pieces.AreaOfPiece.begin(), pieces.AreaOfPiece.end(), 0.0);
  std::map<int, int> largest;
  for (int p = 0; p < pieces.NumberOfPieces(); ++p)
  {
    const auto [entry, isNew] = largest.insert({ pieces.LabelOfPiece[p], p });
    if (!isNew && pieces.AreaOfPiece[p] > pieces.AreaOfPiece[entry->second])
    {
      entry->second = p;
    }
  }
  // An island goes by the number of its label's largest piece, of which only that is kept.
  std::vector<int> group(pieces.NumberOfPieces());
  for (int p = 0; p < pieces.NumberOfPieces(); ++p)
  {
    const int column = pieces.LabelOfPiece[p];
    const double least = LeastOfSmallest * habits.SmallestPiece(labels[column]) * area;
    group[p] = pieces.AreaOfPiece[p] < least ? largest[column] : p;
  }
  std::vector<int> pieceOfTriangle;
  pieceOfTriangle.reserve(columns.size());
  for (const int piece : pieces.PieceOfTriangle)
  {
    pieceOfTriangle.push_back(group[piece]);
  }
  KeepLargestComponents(mesh, pieceOfTriangle);
  for (int& piece : pieceOfTriangle)
  {
    piece = pieces.LabelOfPiece[piece];
  }
  return pieceOfTriangle;
}
}

void LabelHabits::Add(const TriangleMesh& mesh, const std::vector<int>& labels, double weight)
{
  this->Sum += weight * PreferenceOf(mesh, labels, BlendWidth);
  this->Weight += weight;
  const SegmentPieces pieces = FindPieces(mesh, labels);
  const double area = std::accumulate(pieces.AreaOfPiece.begin(), pieces.AreaOfPiece.end(), 0.0);
  for (int p = 0; p < pieces.NumberOfPieces() && area > 0.0; ++p)
  {
    const double share = pieces.AreaOfPiece[p] / area;
    const auto [entry, isNew] = this->Smallest.insert({ pieces.LabelOfPiece[p], share });
    entry->second = std::min(entry->second, share);
  }
}

double LabelHabits::SmallestPiece(int label) const
{
  const auto found = this->Smallest.find(label);
  return found == this->Smallest.end() ? 0.0 : found->second;
}

void LabelHabits::AddAll(const LabelHabits& other, double weight)
{
  this->Sum += weight * other.Sum;
  this->Weight += weight * other.Weight;
  for (const auto& [label, share] : other.Smallest)
  {
    const auto [entry, isNew] = this->Smallest.insert({ label, share });
    entry->second = std::min(entry->second, share);
  }
}

CutLabels CutShares(const TriangleMesh& mesh, const LabelShares& shares,
  const std::vector<int>& labels, const LabelHabits& habits, const Progress& progress)
{
  const MeshSmoother blend(mesh, BlendWidth * mesh.BoundingBoxDiagonal());
  const Eigen::MatrixXd blended = blend.Smooth(shares.cast<double>());
  const std::vector<double> prices =
    EdgePrices(mesh, EdgeConcavity(mesh, blend), habits.Preference());
  const std::vector<int> columns =
    WithoutIslands(mesh, LabelFaces(mesh, blended, prices, {}, progress), labels, habits);
  CutLabels result;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    result.Labels.push_back(labels[columns[t]]);
    result.Shares.push_back(std::clamp(ShareOfTriangle(mesh, blended, t, columns[t]), 0.0, 1.0));
  }
  return result;
}
}
