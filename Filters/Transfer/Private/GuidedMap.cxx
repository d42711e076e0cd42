// SPDX-License-Identifier: BSD-3-Clause
#include "GuidedMap.h"

#include "MeshSmoother.h"
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
  double width)
{
  Eigen::MatrixXd rows(target.Mesh.NumberOfVertices(), 12);
  for (int v = 0; v < target.Mesh.NumberOfVertices(); ++v)
  {
    const int node = target.NodeOfVertex[v];
    const auto& transform = node >= 0 && places[node].Known ? places[node].Transform : whole;
    rows.row(v) = Eigen::Map<const Eigen::RowVectorXd>(transform.data(), 12);
  }
  return MeshSmoother(target.Mesh, width).Smooth(rows);
}
}

GuidedMap BuildGuidedMap(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const SkeletonMap& map, bool anyMatched, const SegmentPieces& pieces,
  const std::vector<bool>& isTransferred, const Progress& progress)
{
  const TriangleMesh& mesh = target.Mesh;
  const int numberOfVertices = mesh.NumberOfVertices();
  GuidedMap result;
  result.Positions.resize(numberOfVertices);
  result.FoundPoints.resize(numberOfVertices);
  result.Certainty.assign(numberOfVertices, 1.0);

  const double meanRadius = MeanRadius(target);
  const std::vector<SkeletonMap::Place> places = map.PlacesOfTargetNodes();
  const Eigen::Matrix<double, 3, 4> whole =
    anyMatched ? Eigen::Matrix<double, 3, 4>::Zero() : AlignWhole(source.Mesh, target.Mesh);
  const Eigen::MatrixXd transforms =
    SmoothTransforms(target, places, whole, anyMatched ? 0.5 * meanRadius : 0.0);
  const SourceSearch search(source, pieces, isTransferred);
  if (!Report(progress, 0.2))
  {
    return result;
  }

  const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
  std::vector<SourceSearch::Query> queries(numberOfVertices);
  for (int v = 0; v < numberOfVertices; ++v)
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
    const Eigen::Vector3d normal = transform.leftCols<3>() * normals[v];
    query.Normal = normal.norm() > 0.0 ? Eigen::Vector3d(normal.normalized()) : normal;
    query.Node = known ? places[node].SourceNode : -1;
    query.Radius = known ? places[node].Radius : 0.05 * source.Diagonal();
    result.Certainty[v] = known && places[node].Matched ? 1.0 : 0.1;
  }

  std::vector<SourceSearch::Answer> answers(numberOfVertices);
  const auto searchAll = [&]()
  {
    ParallelFor(0, numberOfVertices,
      [&](int first, int last)
      {
        for (int v = first; v < last; ++v)
        {
          answers[v] = search.Find(queries[v]);
        }
      });
  };
  searchAll();
  if (!Report(progress, 0.5))
  {
    return result;
  }
  Eigen::MatrixXd displacements(numberOfVertices, 3);
  for (int v = 0; v < numberOfVertices; ++v)
  {
    displacements.row(v) =
      result.Certainty[v] * (answers[v].Position - queries[v].Position).transpose();
  }
  displacements = MeshSmoother(mesh, meanRadius).Smooth(displacements);
  for (int v = 0; v < numberOfVertices; ++v)
  {
    queries[v].Position += displacements.row(v).transpose();
  }
  searchAll();
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
  result.Width = 0.15 * meanRadius;
  result.Shares = MeshSmoother(mesh, result.Width).Smooth(result.Shares);
  return result;
}
}
