// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_Guidance_h
#define marrow_Guidance_h

#include "AnalyzedMesh.h"
#include "Hints.h"

#include <cstddef>
#include <vector>

namespace marrow
{
/// The user's word on two vertices: they are of the same part, or must not be taken for that.
struct SurfaceHint
{
  int SourceVertex = -1;
  int TargetVertex = -1;
  bool IsForbidden = false;
};

/// Of a triangle or cell without a label.
inline constexpr int NoLabel = -1;

/// What the user says about one transfer, because no method is always right.
struct Guidance
{
  std::vector<SurfaceHint> Hints;
  std::size_t AnswerIndex = 0; ///< of the answers in the order of their likelihood
  std::vector<int> KeptLabels; ///< per target triangle a label to be kept, or NoLabel; empty: none
};

/// The same on the skeletons.
std::vector<NodeHint> ToNodeHints(
  const AnalyzedMesh& source, const AnalyzedMesh& target, const std::vector<SurfaceHint>& hints);

/// With the target for the source.
std::vector<SurfaceHint> Turned(const std::vector<SurfaceHint>& hints);

/// How far it is from a vertex to a triangle of the same mesh, of its diagonal.
double DistanceToTriangle(const AnalyzedMesh& mesh, int vertex, int triangle);

/// Whether a vertex and a triangle of the same mesh are of the same part: on one branch of the skeleton, or
/// near each other.
bool AreOfSamePart(const AnalyzedMesh& mesh, int vertex, int triangle);

/// What a map of surfaces costs for not keeping to hints; `foundTriangles` are per target vertex the
/// source's triangle there.
double CostOfHints(const AnalyzedMesh& source, const std::vector<SurfaceHint>& hints,
  const std::vector<int>& foundTriangles);

/// How many hints the map contradicts, by parts.
int NumberOfUnmetHints(const AnalyzedMesh& source, const std::vector<SurfaceHint>& hints,
  const std::vector<int>& foundTriangles);
}

#endif
