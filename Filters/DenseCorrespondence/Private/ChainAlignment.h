// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_ChainAlignment_h
#define marrow_ChainAlignment_h

#include "AnalyzedMesh.h"

#include <optional>
#include <utility>
#include <vector>

namespace marrow
{
/// A pair of ratios, one on each of two matched chains, that are taken for the same place.
struct Landmark
{
  double Source = 0.0;
  double Target = 0.0;
};

/// Which places of two matched chains correspond: monotone, piecewise linear, ends on ends.
class ChainAlignment
{
public:
  /// Equal ratios.
  ChainAlignment() = default;
  /// `knots` are pairs of source and target ratio, both strictly increasing, from (0,0) to (1,1).
  explicit ChainAlignment(std::vector<std::pair<double, double>> knots)
    : Knots(std::move(knots))
  {
  }

  double TargetRatio(double sourceRatio) const;
  double SourceRatio(double targetRatio) const;

private:
  std::vector<std::pair<double, double>> Knots = { { 0.0, 0.0 }, { 1.0, 1.0 } };
};

/// Aligns two chains by what the surface is like along them (ours: the transfer paper uses the best
/// pair of ghost boundaries alone, which leaves all of the chain beside it to proportion; a limb that
/// begins deeper inside its body is then cut too low).
///
/// Two profiles tell the places apart: the logarithm of MSP, up to a constant, since a limb may be
/// thicker as a whole; and the share of the tube round the chain that belongs to it, which is small
/// where the chain runs inside the body. Of all monotone alignments the one is taken, by dynamic
/// programming, that makes the profiles most alike and stretches least.
/// A landmark pulls the alignment towards it.
ChainAlignment AlignChains(const AnalyzedMesh& source, const Branch& sourceChain,
  const AnalyzedMesh& target, const Branch& targetChain, const std::optional<Landmark>& landmark);
}

#endif
