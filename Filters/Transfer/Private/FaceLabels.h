// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FaceLabels_h
#define marrow_FaceLabels_h

#include "Progress.h"
#include "TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// Labels all faces by one energy, the sum of
///   - over the faces, area over the whole area × −log of the share of the face's segment, and
///   - over the edges between segments, a weight × the price per half-edge (EdgePrices),
/// by alpha expansion. `shares` says per vertex (row) how likely each segment (column) is there;
/// rows sum to 1. So boundaries are short, run in concavities and keep to where the segments meet,
/// as far as the shares leave that open. Faces where a segment is as sure as anywhere keep it, so that
/// a small segment is not swallowed by its neighbours.
///
/// `excluded` lists per triangle segments that it may not take, unless it were left with none; empty
/// for no triangle at all.
std::vector<int> LabelFaces(const TriangleMesh& mesh, const Eigen::MatrixXd& shares,
  const std::vector<double>& prices, const std::vector<std::vector<int>>& excluded,
  const Progress& progress);

/// The mean share of a segment over the corners of a triangle.
double ShareOfTriangle(
  const TriangleMesh& mesh, const Eigen::MatrixXd& shares, int triangle, int segment);
}

#endif
