// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_LabelShares_h
#define marrow_LabelShares_h

#include "CoarseMesh.h"
#include "TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// How likely each label (column) is at each vertex or triangle (row). Rows sum to 1, or to 0 where
/// nothing is known yet.
using LabelShares = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// All different labels, ascending: the columns of the shares.
std::vector<int> DifferentLabels(const std::vector<std::vector<int>>& labelsOfShapes);

/// 1 for the label of each triangle.
LabelShares SharesOfLabels(
  const std::vector<int>& labelOfTriangle, const std::vector<int>& differentLabels);

/// The mean over the corners of each triangle.
LabelShares SharesOfTriangles(const TriangleMesh& mesh, const LabelShares& ofVertices);

/// By the area that each label has in the cell of each coarse vertex.
LabelShares SharesOfCells(
  const TriangleMesh& fine, const CoarseMesh& coarse, const LabelShares& ofFineTriangles);

/// What one shape tells another: the shares of the triangles on which the other's vertices lie.
struct ShareLink
{
  const LabelShares* OfTriangles = nullptr;
  const std::vector<int>* FoundTriangles = nullptr; ///< per vertex of the one that is told
  const std::vector<float>* Certainty = nullptr;    ///< per vertex, [0,1]; null: 1
  double Weight = 1.0;
};

/// The weighted sum of what the links tell, per vertex. Links without shares, and rows of which nothing is
/// known, tell nothing.
LabelShares GatherShares(
  const std::vector<ShareLink>& links, int numberOfVertices, int numberOfLabels);

/// Makes the rows sum to 1 (those of zeros stay) after raising them to a power: above 1, what is
/// likelier becomes likelier still, and what a few wrong maps brought fades.
void SharpenShares(LabelShares& shares, double power);
}

#endif
