// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CanonicalFrame_h
#define marrow_CanonicalFrame_h

#include "TriangleMesh.h"

#include <Eigen/Core>

#include <vector>

namespace marrow
{
/// A frame that a shape brings with it: its centroid, its principal axes, and its root mean square radius
/// as the unit of length. Seen from there a shape looks the same wherever it lies, however it is turned,
/// and whatever its units are.
///
/// Positions and lengths in this frame are rounded to a grid. What a rotation or another order of summation
/// leaves in the last bits is thereby gone, so it cannot decide a tie.
class CanonicalFrame
{
public:
  CanonicalFrame() = default;

  /// The frame of weighted points. An axis points to the side where the shape reaches farther (its third
  /// moment); of the two axes for which that is clearer the directions are kept, and the remaining one
  /// completes a right-handed frame, so that left and right are never exchanged.
  CanonicalFrame(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& weights);

  /// False where the points are all at one place: the frame's unit then says nothing of them.
  bool HasSpread() const { return this->Spreads; }

  Eigen::Vector3d ToFrame(const Eigen::Vector3d& point) const;
  Eigen::Vector3d FromFrame(const Eigen::Vector3d& point) const;
  double LengthToFrame(double length) const;
  double LengthFromFrame(double length) const { return length * this->Unit; }
  Eigen::Vector3d DirectionToFrame(const Eigen::Vector3d& direction) const
  {
    return this->Axes * direction;
  }
  Eigen::Vector3d DirectionFromFrame(const Eigen::Vector3d& direction) const
  {
    return this->Axes.transpose() * direction;
  }

  /// The frame of the same points times 2^exponent.
  void Scale(int exponent);

  static double ToGrid(double value);
  static Eigen::Vector3d ToGrid(const Eigen::Vector3d& value);

private:
  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity(); ///< one axis a row
  Eigen::Vector3d Center = Eigen::Vector3d::Zero();
  double Unit = 1.0;
  bool Spreads = false;
};

/// A mesh in its canonical frame, its vertices and triangles in an order that the geometry alone gives.
struct CanonicalMesh
{
  CanonicalFrame Frame;
  TriangleMesh Mesh;                 ///< with its connectivity
  std::vector<int> OriginalVertex;   ///< per vertex
  std::vector<int> OriginalTriangle; ///< per triangle
};

/// O(n log n). `mesh` needs no connectivity.
CanonicalMesh ToCanonicalMesh(const TriangleMesh& mesh);
}

#endif
