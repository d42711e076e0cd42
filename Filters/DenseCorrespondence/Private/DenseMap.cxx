// SPDX-License-Identifier: BSD-3-Clause
#include "DenseMap.h"

#include "NodePlaces.h"
#include "ParallelFor.h"
#include "SlicePlaces.h"
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
/// Of a limb, over the diagonal, where the skeleton says nothing.
constexpr double UsualRadius = 0.02;

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
  return total > 0.0 && sum > 0.0 ? sum / total : UsualRadius * side.Diagonal();
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
  constexpr double ofLeftover = 0.5; // found by where it lies alone
  return place.Matched ? 1.0 : place.IsLeftover ? ofLeftover : LeastCertainty;
}
}

DenseMapper::DenseMapper(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const std::vector<bool>& isFindable, const std::vector<SurfaceHint>& hints)
  : DenseMapper(
      source, target, std::make_shared<SourceSearch>(source, isFindable), SmootherOf(target))
{
  this->Hints = hints;
}

DenseMapper::DenseMapper(const AnalyzedMesh& source, const AnalyzedMesh& target,
  std::shared_ptr<const SourceSearch> search, std::shared_ptr<const MeshSmoother> smoother)
  : Source(source)
  , Target(target)
  , Search(std::move(search))
  , Smoother(std::move(smoother))
  , Areas(target.Mesh.VertexAreas())
{
}

std::shared_ptr<const MeshSmoother> DenseMapper::SmootherOf(const AnalyzedMesh& target)
{
  return std::make_shared<MeshSmoother>(target.Mesh, 0.5 * MeanRadius(target));
}

const Eigen::Matrix<double, 3, 4>& DenseMapper::GetAlignment()
{
  if (!this->Alignment)
  {
    this->Alignment = AlignWhole(this->Source.Mesh, this->Target.Mesh, this->Hints);
  }
  return *this->Alignment;
}

/// Per vertex the 3 x 4 transformation to the source, flattened to a row, smoothed over the surface.
Eigen::MatrixXd DenseMapper::SmoothTransforms(const std::vector<SkeletonMap::Place>& places)
{
  Eigen::MatrixXd rows(this->Target.Mesh.NumberOfVertices(), 12);
  for (int v = 0; v < this->Target.Mesh.NumberOfVertices(); ++v)
  {
    const int node = this->Target.NodeOfVertex[v];
    const auto& transform =
      node >= 0 && places[node].Known ? places[node].Transform : this->GetAlignment();
    rows.row(v) = Eigen::Map<const Eigen::RowVectorXd>(transform.data(), 12);
  }
  return this->Smoother->Smooth(rows);
}

std::vector<SourceSearch::Query> DenseMapper::QueriesBySkeleton(
  const std::vector<SkeletonMap::Place>& places, std::vector<double>& certainty)
{
  const TriangleMesh& mesh = this->Target.Mesh;
  const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
  const Eigen::MatrixXd transforms = this->SmoothTransforms(places);
  std::vector<SourceSearch::Query> queries(mesh.NumberOfVertices());
  certainty.assign(mesh.NumberOfVertices(), 1.0);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    Eigen::Matrix<double, 3, 4> transform;
    for (int k = 0; k < 12; ++k)
    {
      transform.data()[k] = transforms(v, k);
    }
    const int node = this->Target.NodeOfVertex[v];
    const bool known = node >= 0 && places[node].Known;
    SourceSearch::Query& query = queries[v];
    query.Position = transform.leftCols<3>() * mesh.Points[v] + transform.col(3);
    query.Normal = (transform.leftCols<3>() * normals[v]).normalized();
    query.Node = known ? places[node].SourceNode : -1;
    query.Radius = known ? places[node].Radius : WholeSearchRadius * this->Source.Diagonal();
    certainty[v] = node >= 0 ? CertaintyOf(places[node]) : LeastCertainty;
  }
  return queries;
}

std::vector<int> DenseMapper::FindAll(const std::vector<SourceSearch::Query>& queries,
  std::vector<SourceSearch::Candidates>& candidates) const
{
  std::vector<int> found(queries.size());
  candidates.resize(queries.size());
  ParallelFor(0, static_cast<int>(queries.size()),
    [&](int first, int last)
    {
      for (int v = first; v < last; ++v)
      {
        this->Search->UpdateCandidates(queries[v], candidates[v]);
        found[v] = this->Search->Best(queries[v], candidates[v]);
      }
    });
  return found;
}

double DenseMapper::Standoff(const DenseMap& map) const
{
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t v = 0; v < map.Places.size(); ++v)
  {
    const int found = map.FoundTriangles[v];
    const Eigen::Vector3d offset = map.Places[v].Position - this->Search->Centroid(found);
    sum += this->Areas[v] * std::abs(offset.dot(this->Search->Normal(found)));
    total += this->Areas[v];
  }
  return total > 0.0 ? sum / (total * std::max(this->Source.Diagonal(), 1e-300)) : 0.0;
}

DenseMap DenseMapper::StartBySlices(const SliceAlignment& alignment) const
{
  DenseMap map;
  map.Places = PlacesBySlices(this->Source, this->Target.Mesh, alignment, *this->Search);
  map.FoundTriangles = this->FindAll(map.Places, map.Candidates);
  map.Certainty.assign(map.Places.size(), 1.0);
  return map;
}

DenseMap DenseMapper::StartBySkeletons(const std::vector<SkeletonMap::Place>& places)
{
  DenseMap map;
  map.Places = this->QueriesBySkeleton(places, map.Certainty);
  map.FoundTriangles = this->FindAll(map.Places, map.Candidates);
  return map;
}

DenseMap DenseMapper::StartAsWhole()
{
  DenseMap map;
  map.Places = QueriesAsWhole(
    this->Target.Mesh, this->GetAlignment(), WholeSearchRadius * this->Source.Diagonal());
  map.FoundTriangles = this->FindAll(map.Places, map.Candidates);
  map.Certainty.assign(map.Places.size(), 1.0);
  return map;
}

DenseMap DenseMapper::Map(const Answer& answer, const Progress& progress)
{
  // Slices know nothing of nodes.
  if (answer.IsWhole() || answer.Slices)
  {
    return this->Map(answer, {}, progress);
  }
  const SkeletonMap skeletonMap(this->Source, this->Target, answer.Match,
    AlignByProfiles(this->Source, this->Target, answer.Match));
  return this->Map(answer, PlaceNodes(this->Source, this->Target, skeletonMap).OfTarget, progress);
}

DenseMap DenseMapper::Map(
  const Answer& answer, const std::vector<SkeletonMap::Place>& places, const Progress& progress)
{
  DenseMap map = answer.Slices ? this->StartBySlices(*answer.Slices)
    : answer.IsWhole()         ? this->StartAsWhole()
                               : this->StartBySkeletons(places);
  this->Correct(map, progress);
  return map;
}

/// Moves the places towards what is found there, evenly over the surface.
void DenseMapper::Correct(DenseMap& map, const Progress& progress) const
{
  const int numberOfVertices = static_cast<int>(map.Places.size());
  map.Standoff = this->Standoff(map);
  for (int round = 0; round < NumberOfCorrections; ++round)
  {
    if (!Report(progress, (round + 1.0) / (NumberOfCorrections + 1.0)))
    {
      return;
    }
    Eigen::MatrixXd displacements(numberOfVertices, 3);
    for (int v = 0; v < numberOfVertices; ++v)
    {
      const Eigen::Vector3d& found = this->Search->Centroid(map.FoundTriangles[v]);
      displacements.row(v) = map.Certainty[v] * (found - map.Places[v].Position).transpose();
    }
    displacements = this->Smoother->Smooth(displacements);
    for (int v = 0; v < numberOfVertices; ++v)
    {
      map.Places[v].Position += displacements.row(v).transpose();
    }
    map.FoundTriangles = this->FindAll(map.Places, map.Candidates);
  }
}

Eigen::MatrixXd DenseMapper::Shares(
  const DenseMap& map, const std::vector<int>& segmentOfTriangle, int numberOfSegments) const
{
  const int numberOfVertices = static_cast<int>(map.Places.size());
  Eigen::MatrixXd shares = Eigen::MatrixXd::Zero(numberOfVertices, numberOfSegments);
  ParallelFor(0, numberOfVertices,
    [&](int first, int last)
    {
      for (int v = first; v < last; ++v)
      {
        for (const auto& [triangle, weight] : this->Search->Weigh(map.Places[v], map.Candidates[v]))
        {
          shares(v, segmentOfTriangle[triangle]) += weight;
        }
      }
    });
  return shares;
}
}
