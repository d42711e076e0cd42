// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_GhostBoundary_h
#define marrow_GhostBoundary_h

#include "AnalyzedMesh.h"
#include "ChainAlignment.h"
#include "MatchedSkeletons.h"

#include <optional>
#include <vector>

namespace marrow
{
/// A place on a chain where the thickness changes: a boundary that a segmentation would be likely to
/// have, used as a landmark (T:4.1).
struct GhostBoundary
{
  double Ratio = 0.0;    ///< where along the chain
  double Strength = 0.0; ///< mean |∇MSP| along the cut over the largest |∇MSP| of the mesh
  double Peak = 0.0;     ///< where the profile has the maximum that it comes from
  std::vector<int> HalfEdges{}; ///< the cut: its half-edges on the chain's front side, unordered
};

/// The mean |∇MSP| over φ of the nodes along the chain at evenly spaced ratios from 0 to 1, smoothed by
/// a Gaussian of standard deviation `kernel` (of the chain's length); empty if no node has vertices.
std::vector<double> GradientProfile(const AnalyzedMesh& side, const Branch& chain, double kernel);

/// A local maximum of the GradientProfile counts if it is at least `theta` times the lowest values on
/// both its sides (up to where the profile rises above it). The triangles within 1.5 kernels to both sides are its fuzzy region; the minimum cut through it, with
/// capacity length / (|∇MSP| + 0.001), is the ghost boundary.
std::vector<GhostBoundary> FindGhostBoundaries(
  const AnalyzedMesh& side, const Branch& chain, double theta, double kernel);

/// The pair of least cost C_b; nothing if there is none of cost below 0.01 whose ratios are inside
/// (0.01, 0.99).
std::optional<Landmark> MatchGhostBoundaries(
  const std::vector<GhostBoundary>& source, const std::vector<GhostBoundary>& target);

/// Aligns all matched chains by what the surface is like along them, with the best pair of ghost boundaries
/// as a landmark.
std::vector<ChainAlignment> AlignWithLandmarks(const AnalyzedMesh& source,
  const AnalyzedMesh& target, const MatchedSkeletons& match, double theta, double kernel);
}

#endif
