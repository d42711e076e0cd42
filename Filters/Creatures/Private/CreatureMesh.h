// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_CreatureMesh_h
#define marrow_CreatureMesh_h

#include "Creature.h"
#include "Progress.h"
#include "Skeleton.h"
#include "TriangleMesh.h"

#include <string>
#include <vector>

namespace marrow
{
/// See vtkCreatureSource, whose parameters these are.
struct CreatureParameters
{
  CreatureKind Kind = CreatureKind::Quadruped;
  double Pose = 0.0;
  double Proportion = 0.0;
  int Resolution = 10000;
  double Noise = 0.0;
  unsigned int Seed = 1;
};

struct CreatureMesh
{
  TriangleMesh Mesh;
  std::vector<int> SegmentIds; ///< per triangle
  Skeleton KnownSkeleton;      ///< with φ; AGD and MSP are not known
};

/// Makes the creature: draws proportions and a pose in which nothing touches, contours the implicit
/// surface, evens the triangles, labels them and associates the vertices. Returns one sentence that
/// says what is wrong, or an empty one (also on abort).
std::string MakeCreatureMesh(
  const CreatureParameters& parameters, CreatureMesh& result, const Progress& progress);
}

#endif
