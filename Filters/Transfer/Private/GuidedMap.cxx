// SPDX-License-Identifier: BSD-3-Clause
#include "GuidedMap.h"

#include "ParallelFor.h"
#include "SourceSearch.h"
#include "WholeAlignment.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
/// How often positions are corrected by what was found there.
constexpr int NumberOfCorrections = 6;

/// The mean over the surface of the radius of the vertices' nodes.
double MeanRadius(const AnalyzedMesh& side)
{
  const std::vector<double> areas = side.Mesh.VertexAreas();
  double sum = 0.0;
  double total = 0.0;
  for (int v = 0; v < side.Mesh.NumberOfVertices(); ++v)
  {
    if (side.NodeOfVertex[v] >= 0)
    {
      sum += areas[v] * side.Skeleton.Graph[side.NodeOfVertex[v]].Radius;
      total += areas[v];
    }
  }
  return total > 0.0 && sum > 0.0 ? sum / total : 0.02 * side.Diagonal();
}

/// Per vertex the 3 x 4 transformation to the source, flattened to a row, smoothed over the surface.
Eigen::MatrixXd SmoothTransforms(const AnalyzedMesh& target,
  const std::vector<SkeletonMap::Place>& places, const Eigen::Matrix<double, 3, 4>& whole,
  const MeshSmoother& smoother)
{
  Eigen::MatrixXd rows(target.Mesh.NumberOfVertices(), 12);
  for (int v = 0; v < target.Mesh.NumberOfVertices(); ++v)
  {
    const int node = target.NodeOfVertex[v];
    const auto& transform = node >= 0 && places[node].Known ? places[node].Transform : whole;
    rows.row(v) = Eigen::Map<const Eigen::RowVectorXd>(transform.data(), 12);
  }
  return smoother.Smooth(rows);
}

std::vector<SourceSearch::Query> QueriesAsWhole(
  const TriangleMesh& mesh, const Eigen::Matrix<double, 3, 4>& whole, double radius)
{
  const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
  std::vector<SourceSearch::Query> queries(mesh.NumberOfVertices());
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    queries[v].Position = whole.leftCols<3>() * mesh.Points[v] + whole.col(3);
    queries[v].Normal = (whole.leftCols<3>() * normals[v]).normalized();
    queries[v].Radius = radius;
  }
  return queries;
}

/// Of a place that hangs on a matched one, or of none at all.
constexpr double LeastCertainty = 0.1;

double CertaintyOf(const SkeletonMap::Place& place)
{
  constexpr double ofLeftover = 0.5;
  return place.Matched ? 1.0 : place.IsLeftover ? ofLeftover : LeastCertainty;
}

std::vector<SourceSearch::Query> QueriesBySkeleton(const AnalyzedMesh& source,
  const AnalyzedMesh& target, const std::vector<SkeletonMap::Place>& places,
  const Eigen::Matrix<double, 3, 4>& whole, const MeshSmoother& smoother,
  std::vector<double>& certainty)
{
  const TriangleMesh& mesh = target.Mesh;
  const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
  const Eigen::MatrixXd transforms = SmoothTransforms(target, places, whole, smoother);
  std::vector<SourceSearch::Query> queries(mesh.NumberOfVertices());
  certainty.assign(mesh.NumberOfVertices(), 1.0);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    Eigen::Matrix<double, 3, 4> transform;
    for (int k = 0; k < 12; ++k)
    {
      transform.data()[k] = transforms(v, k);
    }
    const int node = target.NodeOfVertex[v];
    const bool known = node >= 0 && places[node].Known;
    SourceSearch::Query& query = queries[v];
    query.Position = transform.leftCols<3>() * mesh.Points[v] + transform.col(3);
    query.Normal = (transform.leftCols<3>() * normals[v]).normalized();
    query.Node = known ? places[node].SourceNode : -1;
    query.Radius = known ? places[node].Radius : 0.05 * source.Diagonal();
    certainty[v] = node >= 0 ? CertaintyOf(places[node]) : LeastCertainty;
  }
  return queries;
}

void FindAll(const SourceSearch& search, const std::vector<SourceSearch::Query>& queries,
  std::vector<SourceSearch::Answer>& answers)
{
  answers.resize(queries.size());
  ParallelFor(0, static_cast<int>(queries.size()),
    [&](int first, int last)
    {
      for (int v = first; v < last; ++v)
      {
        answers[v] = search.Find(queries[v]);
      }
    });
}

/// How badly a map brings the surfaces together: the mean over the target of the squared distance, in
/// twentieths of the source's diagonal, and of the deviation of normals, [0,1].
double Misfit(const AnalyzedMesh& source, const std::vector<double>& areas,
  const std::vector<SourceSearch::Query>& queries, const std::vector<SourceSearch::Answer>& answers)
{
  const double scale = std::max(0.05 * source.Diagonal(), 1e-300);
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t v = 0; v < queries.size(); ++v)
  {
    const double squared = (answers[v].Position - queries[v].Position).squaredNorm();
    sum += areas[v] *
      std::min(
        1.0, squared / (scale * scale) + 0.5 * (1.0 - answers[v].Normal.dot(queries[v].Normal)));
    total += areas[v];
  }
  return total > 0.0 ? sum / total : 1.0;
}
}

GuidedMap BuildGuidedMap(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const std::vector<SkeletonMap::Place>& places, bool anyMatched, const SegmentPieces& pieces,
  const std::vector<bool>& isTransferred, const MeshSmoother& blend, const Progress& progress)
{
  const TriangleMesh& mesh = target.Mesh;
  const int numberOfVertices = mesh.NumberOfVertices();
  GuidedMap result;
  result.Positions.resize(numberOfVertices);
  result.FoundPoints.resize(numberOfVertices);
  result.Certainty.assign(numberOfVertices, 1.0);

  const MeshSmoother smoother(mesh, 0.5 * MeanRadius(target));
  const SourceSearch search(source, pieces, isTransferred);
  const std::vector<double> areas = mesh.VertexAreas();
  std::vector<SourceSearch::Answer> answers;
  const Eigen::Matrix<double, 3, 4> whole = AlignWhole(source.Mesh, target.Mesh);
  std::vector<SourceSearch::Query> queries = QueriesAsWhole(mesh, whole, 0.05 * source.Diagonal());
  FindAll(search, queries, answers);
  const double wholeMisfit = Misfit(source, areas, queries, answers);
  if (!Report(progress, 0.2))
  {
    return result;
  }
  if (anyMatched)
  {
    std::vector<double> certainty;
    const std::vector<SourceSearch::Query> guided =
      QueriesBySkeleton(source, target, places, whole, smoother, certainty);
    std::vector<SourceSearch::Answer> found;
    FindAll(search, guided, found);
    // A correspondence that is wrong brings the surfaces together no better than none.
    constexpr double goodEnough = 0.2;
    constexpr double clearlyBetter = 0.85;
    if (Misfit(source, areas, guided, found) < std::max(goodEnough, clearlyBetter * wholeMisfit))
    {
      queries = guided;
      answers = std::move(found);
      result.Certainty = std::move(certainty);
      result.IsWholeAlignment = false;
    }
  }
  if (!Report(progress, 0.5))
  {
    return result;
  }
  for (int round = 0; round < NumberOfCorrections; ++round)
  {
    Eigen::MatrixXd displacements(numberOfVertices, 3);
    for (int v = 0; v < numberOfVertices; ++v)
    {
      displacements.row(v) =
        result.Certainty[v] * (answers[v].Position - queries[v].Position).transpose();
    }
    displacements = smoother.Smooth(displacements);
    for (int v = 0; v < numberOfVertices; ++v)
    {
      queries[v].Position += displacements.row(v).transpose();
    }
    FindAll(search, queries, answers);
  }
  if (!Report(progress, 0.8))
  {
    return result;
  }

  result.Shares = Eigen::MatrixXd::Zero(numberOfVertices, pieces.NumberOfPieces());
  for (int v = 0; v < numberOfVertices; ++v)
  {
    result.Positions[v] = queries[v].Position;
    result.FoundPoints[v] = answers[v].Position;
    for (const auto& [piece, share] : answers[v].Shares)
    {
      result.Shares(v, piece) += share;
    }
  }
  result.Shares = blend.Smooth(result.Shares);
  return result;
}
}
