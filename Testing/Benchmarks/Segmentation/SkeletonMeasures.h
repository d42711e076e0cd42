// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SkeletonMeasures_h
#define marrow_SkeletonMeasures_h

#include "PreparedMesh.h"
#include "ResultTable.h"

#include <set>
#include <string>
#include <vector>

namespace marrow::bench
{
/// Which pieces of a category end in a terminal.
struct Extremities
{
  std::set<std::string> Labels;  ///< each piece has exactly one
  std::set<std::string> Natural; ///< a terminal there is neither asked for nor wrong
};

/// The columns of a mesh.
const std::vector<std::string>& MeshColumns();

/// Measures one mesh's skeleton:
/// - faces, genus, loops, nodes, nodes_inside (counts), seconds_field, seconds_skeleton;
/// - terminals; spurs: branches to a terminal that end inside the ball of their junction;
/// - where the category has extremities: extremities (pieces with such a label), found_extremities
///   (those with at least one terminal), judged_terminals (all but those in natural places) and
///   right_terminals (one for each piece found). A terminal is in the piece of most faces at its φ.
Result MeasureSkeleton(const PreparedMesh& mesh, const std::vector<std::string>& labelNames,
  const Extremities& extremities);
}

#endif
