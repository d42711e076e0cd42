// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_DenseMap_h
#define marrow_DenseMap_h

#include "AnalyzedMesh.h"
#include "Answer.h"
#include "Guidance.h"
#include "MeshSmoother.h"
#include "Progress.h"
#include "SkeletonMap.h"
#include "SourceSearch.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <vector>

namespace marrow
{
/// Where every vertex of the target lies on the source.
struct DenseMap
{
  /// Per target vertex its place in the source's space, with which the surface there is searched.
  std::vector<SourceSearch::Query> Places;
  std::vector<SourceSearch::Candidates> Candidates; ///< per target vertex, near its place
  std::vector<int> FoundTriangles; ///< per target vertex the source's triangle there
  std::vector<double> Certainty;   ///< per target vertex: 1 on matched branches, else less
  /// How far the target stood off the source's surface before the corrections, on average, of the
  /// source's diagonal: how different the shapes are, and so how far the map may be wrong.
  double Standoff = 0.0;
};

/// Maps one target to one source, for one matching of their skeletons after the other.
///
/// Each target vertex is carried by the transformation of its node (SkeletonMap::Place), smoothed
/// over the surface so that joints blend; there the nearest triangles of the source with a like
/// normal and a near place on the skeleton are looked up. Displacements to what was found, smoothed,
/// then correct the positions and the search is repeated, a few times: this compensates differences
/// of shape that the skeleton does not capture (the depth of a chest).
///
/// If no chain is matched, the target is aligned as a whole (AlignWhole).
class DenseMapper
{
public:
  /// Triangles of the source with `isFindable` false are skipped: their place goes to their
  /// neighbours; empty: none is. The alignment as a whole keeps to the hints.
  DenseMapper(const AnalyzedMesh& source, const AnalyzedMesh& target,
    const std::vector<bool>& isFindable, const std::vector<SurfaceHint>& hints = {});
  /// The same with what is found out about each side alone, for many pairs of the same meshes.
  DenseMapper(const AnalyzedMesh& source, const AnalyzedMesh& target,
    std::shared_ptr<const SourceSearch> search, std::shared_ptr<const MeshSmoother> smoother);

  /// What smoothes the map over a target.
  static std::shared_ptr<const MeshSmoother> SmootherOf(const AnalyzedMesh& target);

  /// By the answer's slices if it has some, else by its skeletons, their chains aligned by their profiles.
  DenseMap Map(const Answer& answer, const Progress& progress);
  /// The same with the places of the target's nodes, however the chains were aligned.
  DenseMap Map(
    const Answer& answer, const std::vector<SkeletonMap::Place>& places, const Progress& progress);

  /// Target vertices x segments: how likely the vertex belongs to each segment of the source, by the
  /// triangles that it finds. Rows sum to 1.
  Eigen::MatrixXd Shares(
    const DenseMap& map, const std::vector<int>& segmentOfTriangle, int numberOfSegments) const;

private:
  const Eigen::Matrix<double, 3, 4>& GetAlignment();

  DenseMap StartBySlices(const SliceAlignment& alignment) const;
  DenseMap StartBySkeletons(const std::vector<SkeletonMap::Place>& places);
  DenseMap StartAsWhole();
  Eigen::MatrixXd SmoothTransforms(const std::vector<SkeletonMap::Place>& places);
  std::vector<SourceSearch::Query> QueriesBySkeleton(
    const std::vector<SkeletonMap::Place>& places, std::vector<double>& certainty);
  std::vector<int> FindAll(const std::vector<SourceSearch::Query>& queries,
    std::vector<SourceSearch::Candidates>& candidates) const;
  double Standoff(const DenseMap& map) const;
  void Correct(DenseMap& map, const Progress& progress) const;

  const AnalyzedMesh& Source;
  const AnalyzedMesh& Target;
  std::shared_ptr<const SourceSearch> Search;
  std::shared_ptr<const MeshSmoother> Smoother;
  std::vector<double> Areas; ///< per target vertex
  std::vector<SurfaceHint> Hints;
  std::optional<Eigen::Matrix<double, 3, 4>> Alignment;
};
}

#endif
