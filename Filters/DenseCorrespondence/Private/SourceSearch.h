// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SourceSearch_h
#define marrow_SourceSearch_h

#include "AnalyzedMesh.h"
#include "PointTree.h"

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace marrow
{
/// The scale of a search, over the diagonal, where no branch gives one: about a limb's width.
inline constexpr double WholeSearchRadius = 0.05;

/// Finds the triangles of the source that are nearest to a place in space, have a like normal and
/// belong to a near part of the skeleton: a hand on a hip does not find the hip.
class SourceSearch
{
public:
  /// Triangles with `isFindable` false are not there to be found; empty: all are.
  SourceSearch(const AnalyzedMesh& source, const std::vector<bool>& isFindable);

  struct Query
  {
    Eigen::Vector3d Position = Eigen::Vector3d::Zero();
    Eigen::Vector3d Normal = Eigen::Vector3d::Zero();
    int Node = -1;       ///< of the source's skeleton; -1 does not care
    double Radius = 0.0; ///< the scale by which normals and nodes are weighed against distance
    /// Per triangle, whether it may be found; null: as far as the rest allows, all.
    std::shared_ptr<const std::vector<bool>> Among;
  };
  /// The nearest triangles near along the skeleton, or of all if there are none, in no order. Some beyond
  /// them are known too: a query that has moved less than these are farther off finds the nearest among them.
  struct Candidates
  {
    static constexpr int Most = 16;       ///< that are weighed: a patch of some four faces across
    static constexpr int MostKnown = 32;  ///< so that small moves need no new search; time alone
    std::array<int, MostKnown> Triangles; ///< the nearest are the first
    int Count = 0;
    int CountKnown = 0;
    Eigen::Vector3d Center = Eigen::Vector3d::Zero(); ///< where they were searched
    double Radius = 0.0;                              ///< no other is nearer to the centre
  };
  /// `candidates` are none, or those of a query with the same node, radius and Among: one that moved a little takes
  /// little. The result is the same.
  void UpdateCandidates(const Query& query, Candidates& candidates) const;
  /// The best of a query's candidates; -1 if there is none.
  int Best(const Query& query, const Candidates& candidates) const;
  /// All of them, the best first, with weights that sum to 1 and fall with what they are worse.
  std::vector<std::pair<int, double>> Weigh(const Query& query, const Candidates& candidates) const;

  /// How far a query is from a triangle: the squared distance over that of `scale`, and how far the
  /// normal deviates, [0,1].
  double Misfit(const Query& query, int triangle, double scale) const;

  const Eigen::Vector3d& Centroid(int triangle) const { return this->Centroids[triangle]; }
  const Eigen::Vector3d& Normal(int triangle) const { return this->Normals[triangle]; }

private:
  /// Distances along the skeleton between all nodes.
  void ComputeNodeDistances(const Skeleton& skeleton);
  double NodeDistance(int a, int b) const
  {
    return this->NodeDistances[a * this->NumberOfNodes + b];
  }
  bool IsNear(const Query& query, int triangle) const
  {
    if (query.Among && !(*query.Among)[triangle])
    {
      return false;
    }
    const int node = this->NodeOfTriangle[triangle];
    return query.Node < 0 || node < 0 || this->NodeDistance(query.Node, node) <= Reach(query);
  }
  /// Within a few radii along the skeleton: parts beyond are near in space only by the pose.
  static double Reach(const Query& query) { return 3.0 * query.Radius; }
  double CostOf(const Query& query, int triangle) const;
  void FindCandidates(
    const Query& query, double squaredReach, bool isAny, Candidates& candidates) const;

  int NumberOfNodes = 0;
  std::vector<double> NodeDistances;
  std::vector<Eigen::Vector3d> Centroids;
  std::vector<Eigen::Vector3d> Normals;
  std::vector<int> NodeOfTriangle;
  PointTree Index;
};
}

#endif
