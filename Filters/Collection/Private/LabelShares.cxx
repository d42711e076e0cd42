// SPDX-License-Identifier: BSD-3-Clause
#include "LabelShares.h"

#include "ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace marrow
{
std::vector<int> DifferentLabels(const std::vector<std::vector<int>>& labelsOfShapes)
{
  std::set<int> labels;
  for (const std::vector<int>& ofShape : labelsOfShapes)
  {
    labels.insert(ofShape.begin(), ofShape.end());
  }
  return { labels.begin(), labels.end() };
}

LabelShares SharesOfLabels(
  const std::vector<int>& labelOfTriangle, const std::vector<int>& differentLabels)
{
  LabelShares shares =
    LabelShares::Zero(static_cast<Eigen::Index>(labelOfTriangle.size()), differentLabels.size());
  for (std::size_t t = 0; t < labelOfTriangle.size(); ++t)
  {
    const auto place =
      std::lower_bound(differentLabels.begin(), differentLabels.end(), labelOfTriangle[t]);
    shares(static_cast<Eigen::Index>(t), place - differentLabels.begin()) = 1.0f;
  }
  return shares;
}

LabelShares SharesOfTriangles(const TriangleMesh& mesh, const LabelShares& ofVertices)
{
  LabelShares shares(mesh.NumberOfTriangles(), ofVertices.cols());
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const auto& [a, b, c] = mesh.Triangles[t];
    shares.row(t) = (ofVertices.row(a) + ofVertices.row(b) + ofVertices.row(c)) / 3.0f;
  }
  return shares;
}

LabelShares SharesOfCells(
  const TriangleMesh& fine, const CoarseMesh& coarse, const LabelShares& ofFineTriangles)
{
  LabelShares shares =
    LabelShares::Zero(coarse.Side.Mesh.NumberOfVertices(), ofFineTriangles.cols());
  for (int t = 0; t < fine.NumberOfTriangles(); ++t)
  {
    for (const int corner : fine.Triangles[t])
    {
      const int cell = coarse.CellOfVertex[corner];
      if (cell >= 0)
      {
        shares.row(cell) += static_cast<float>(fine.Area(t)) * ofFineTriangles.row(t);
      }
    }
  }
  SharpenShares(shares, 1.0);
  return shares;
}

LabelShares GatherShares(
  const std::vector<ShareLink>& links, int numberOfVertices, int numberOfLabels)
{
  LabelShares shares = LabelShares::Zero(numberOfVertices, numberOfLabels);
  ParallelFor(0, numberOfVertices,
    [&](int first, int last)
    {
      for (const ShareLink& link : links)
      {
        if (!link.OfTriangles || link.OfTriangles->size() == 0)
        {
          continue;
        }
        for (int v = first; v < last; ++v)
        {
          const float weight = static_cast<float>(link.Weight) *
            (link.Certainty ? 0.5f + 0.5f * (*link.Certainty)[v] : 1.0f);
          shares.row(v) += weight * link.OfTriangles->row((*link.FoundTriangles)[v]);
        }
      }
    });
  return shares;
}

void SharpenShares(LabelShares& shares, double power)
{
  for (Eigen::Index row = 0; row < shares.rows(); ++row)
  {
    auto values = shares.row(row);
    const float most = values.maxCoeff();
    if (!(most > 0.0f))
    {
      continue;
    }
    values /= most;
    if (power != 1.0)
    {
      values = values.array().pow(static_cast<float>(power));
    }
    values /= values.sum();
  }
}
}
