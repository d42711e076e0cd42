// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SourceSearch_h
#define marrow_SourceSearch_h

#include "AnalyzedMesh.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace marrow
{
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
  /// The best triangle; -1 if there is none.
  int Find(const Query& query) const;
  /// The best triangles, the first first, with weights that sum to 1 and fall with what they are
  /// worse.
  std::vector<std::pair<int, double>> FindSeveral(const Query& query) const;

  /// How far a query is from a triangle: the squared distance over that of `scale`, and how far the
  /// normal deviates, [0,1].
  double Misfit(const Query& query, int triangle, double scale) const;

  const Eigen::Vector3d& Centroid(int triangle) const { return this->Centroids[triangle]; }
  const Eigen::Vector3d& Normal(int triangle) const { return this->Normals[triangle]; }

private:
  using Point = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Value = std::pair<Point, int>;
  using Tree = boost::geometry::index::rtree<Value, boost::geometry::index::rstar<16>>;

  /// Distances along the skeleton between all nodes.
  void ComputeNodeDistances(const Skeleton& skeleton);
  double NodeDistance(int a, int b) const
  {
    return this->NodeDistances[a * this->NumberOfNodes + b];
  }
  /// Candidates near the query with their costs, cheapest first.
  std::vector<std::pair<double, int>> Rank(const Query& query) const;

  int NumberOfNodes = 0;
  std::vector<double> NodeDistances;
  std::vector<Eigen::Vector3d> Centroids;
  std::vector<Eigen::Vector3d> Normals;
  std::vector<int> NodeOfTriangle;
  Tree Index;
};
}

#endif
