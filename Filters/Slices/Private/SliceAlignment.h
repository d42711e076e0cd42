// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SliceAlignment_h
#define marrow_SliceAlignment_h

#include "SliceChain.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// Lays a target on a source, both surfaces of revolution, slice on slice.
///
/// The chains of slices are aligned by dynamic time warping, from end to end: a foot stays below a
/// belly, whatever the lengths. What a slice costs on another is how their radii, each over the
/// TypicalRadius of its shape, and the slopes of their walls differ. A part that the other shape has not
/// got is passed over at the cost of its slices.
class SliceAlignment
{
public:
  /// `isTurned`: with the start of one on the end of the other.
  SliceAlignment(const SliceChain& source, const SliceChain& target, bool isTurned);

  /// The mean over the slices of both, [0,1].
  double GetCost() const { return this->Cost; }

  /// The angle about the source's axis by which the target is turned; 0 at first.
  void SetAngle(double angle) { this->Angle = angle; }
  /// Of directions, from target to source.
  Eigen::Matrix3d GetRotation() const;
  /// Where a point of the target lies in the source's space: in the slice that corresponds, as far out
  /// in proportion to the radius there.
  Eigen::Vector3d ToSource(const Eigen::Vector3d& point) const;

  /// From source to target. The angle is 0 again.
  SliceAlignment Inverse() const { return { this->Target, this->Source, this->IsTurned }; }

  const SliceChain& GetSource() const { return this->Source; }
  const SliceChain& GetTarget() const { return this->Target; }

private:
  void Align();

  SliceChain Source;
  SliceChain Target;
  bool IsTurned;
  double Angle = 0.0;
  double Cost = 1.0;
  std::vector<int> SourceSlices; ///< per slice of the target
};
}

#endif
