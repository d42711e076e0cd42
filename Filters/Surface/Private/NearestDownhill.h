// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_NearestDownhill_h
#define marrow_NearestDownhill_h

#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// Searches for the triangle nearest to a point along a surface, from one that is not far. Refers to the mesh,
/// which has to stay.
class NearestDownhill
{
public:
  explicit NearestDownhill(const TriangleMesh& mesh);

  /// From triangle to triangle over those that share a corner, as long as one is nearer.
  int Find(const Eigen::Vector3d& point, int start) const;

private:
  /// All of a triangle lies within.
  struct Ball
  {
    Eigen::Vector3d Center;
    double Radius;
  };

  /// Certainly no nearer than `distance`, as most are not.
  bool IsBeyond(const Eigen::Vector3d& point, int triangle, double distance) const;
  double SquaredDistance(const Eigen::Vector3d& point, int triangle) const;

  const TriangleMesh& Mesh;
  std::vector<Ball> Balls; ///< per triangle
};
}

#endif
