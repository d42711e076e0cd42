// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_FeaturePoints_h
#define marrow_FeaturePoints_h

#include "PreparedMesh.h"

#include <vector>

namespace marrow::bench
{
/// The feature points that lie at the terminals of one mesh's skeleton.
struct TerminalFeatures
{
  /// Per node of the skeleton: the numbers of the features to which it is the nearest terminal.
  std::vector<std::vector<int>> OfNode;
  /// Distance along edges between features, over the largest; size × size.
  std::vector<double> Distances;
};

/// A feature belongs to the nearest terminal along the surface if that is closer than a tenth of the
/// largest distance between features. Empty if the mesh has no features.
TerminalFeatures FindTerminalFeatures(const PreparedMesh& mesh);

/// Per feature its mirror image, or -1: left and right features are at the same distances from the
/// rest, on the mean of the meshes, and front and back ones are not. Empty if the meshes have no
/// features or differ in their number.
std::vector<int> FindMirrorFeatures(const std::vector<TerminalFeatures>& meshes);
}

#endif
