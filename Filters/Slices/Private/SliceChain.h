// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SliceChain_h
#define marrow_SliceChain_h

#include "RevolutionAxis.h"
#include "TriangleMesh.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace marrow
{
/// A surface of revolution, as of a vase or a shaft, as a chain of slices across its axis: its wall
/// from one end to the other. What is not of the wall, as handles and spouts, is told apart.
class SliceChain
{
public:
  SliceChain(const TriangleMesh& mesh, const RevolutionAxis& axis);

  /// Whether the mesh is a surface of revolution at all, by how much of it goes round.
  bool IsOfRevolution() const;
  /// The share of the directions from the axis, over the whole height, in which the outer wall is as
  /// far as in the others.
  double GetRoundness() const { return this->Roundness; }

  struct Slice
  {
    /// Of the outer wall: the median over the directions from the axis, so that a handle, which takes
    /// up few of them, and the inner wall of a hollow shape do not count.
    double Radius = 0.0;
    /// The mean component along the axis of the outer wall's normals: 0 on a cylinder, towards −1 or 1
    /// where the shape narrows to its start or end.
    double Slope = 0.0;
    /// As GetRoundness, of this slice.
    double Roundness = 0.0;
  };
  /// Of even thickness.
  const std::vector<Slice>& GetSlices() const { return this->Slices; }

  /// The radius that one slice in seven exceeds, which tells the size of a shape: a thin flange does
  /// not make a shaft larger.
  double TypicalRadius() const;

  /// Along the axis: 0 at the start of the wall, the number of slices at its end.
  double PlaceOf(const Eigen::Vector3d& point) const;
  /// From the axis.
  Eigen::Vector3d OffsetOf(const Eigen::Vector3d& point) const;
  Eigen::Vector3d PointAt(double place, const Eigen::Vector3d& offset) const;
  double RadiusAt(double place) const;
  /// Whether it stands off the wall, as a handle does.
  bool IsAppended(const Eigen::Vector3d& point) const;

  /// Two directions across the axis and its own, a right-handed frame, as columns.
  const Eigen::Matrix3d& GetFrame() const { return this->Frame; }

private:
  Eigen::Vector3d Start;  ///< of the wall, on the axis
  double Thickness = 1.0; ///< of a slice
  Eigen::Matrix3d Frame;
  std::vector<Slice> Slices;
  double Roundness = 0.0;
};

/// Null if the mesh is no surface of revolution.
std::shared_ptr<const SliceChain> FindSlices(const TriangleMesh& mesh);
}

#endif
