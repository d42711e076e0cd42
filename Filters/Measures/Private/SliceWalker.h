// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SliceWalker_h
#define marrow_SliceWalker_h

#include "SliceMesh.h"
#include "SliceTracer.h"

#include <Eigen/Core>

namespace marrow
{
/// Walks one slice at a time: what SliceLanes does for many slices at once, and the reference for it.
class SliceWalker
{
public:
  explicit SliceWalker(const TriangleMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// The slice of the plane through `vertex` with unit normal `planeNormal`.
  Slice Walk(int vertex, const Eigen::Vector3d& planeNormal,
    const SliceBounds& bounds = SliceBounds()) const;

private:
  void Follow(SliceCurve& curve) const;

  SliceMesh Mesh;
};
}

#endif
