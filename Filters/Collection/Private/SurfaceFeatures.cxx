// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFeatures.h"

#include "MeshSmoother.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace marrow
{
namespace
{
/// The widths over which the surroundings are seen, of the diagonal: from a crease to a limb.
constexpr std::array<double, 4> Scales{ 0.01, 0.05, 0.1, 0.2 };
/// What is smaller, of the size, is nothing, and has no logarithm.
constexpr double LeastLength = 1e-9;

/// Columns that are added one after the other.
class FeatureColumns
{
public:
  explicit FeatureColumns(int numberOfRows)
    : NumberOfRows(numberOfRows)
  {
  }
  template <typename ValueOf>
  void Add(ValueOf&& valueOf)
  {
    Eigen::VectorXf column(this->NumberOfRows);
    for (int row = 0; row < this->NumberOfRows; ++row)
    {
      column[row] = static_cast<float>(valueOf(row));
    }
    this->Columns.push_back(std::move(column));
  }
  Eigen::MatrixXf Matrix() const
  {
    Eigen::MatrixXf matrix(this->NumberOfRows, static_cast<Eigen::Index>(this->Columns.size()));
    for (std::size_t c = 0; c < this->Columns.size(); ++c)
    {
      matrix.col(static_cast<Eigen::Index>(c)) = this->Columns[c];
    }
    return matrix;
  }

private:
  int NumberOfRows;
  std::vector<Eigen::VectorXf> Columns;
};

/// Where a node is on its branch; at a junction on the longest one.
struct PlaceOnBranch
{
  double Length = 0.0;
  double Place = 0.5; ///< from the end of less AGD, [0,1]
  double Inner = 0.0; ///< AGD of that end
  double Outer = 0.0; ///< and of the other one
  bool IsLimb = false;

  double ToOuterEnd() const { return (1.0 - this->Place) * this->Length; }
};

std::vector<PlaceOnBranch> PlacesOfNodes(const Skeleton& skeleton)
{
  std::vector<PlaceOnBranch> places(skeleton.NumberOfNodes());
  for (const Branch& branch : skeleton.Branches)
  {
    const double front = skeleton.Graph[branch.Front()].AGD;
    const double back = skeleton.Graph[branch.Back()].AGD;
    const bool isLimb = skeleton.TypeOf(branch.Front()) == NodeType::Terminal ||
      skeleton.TypeOf(branch.Back()) == NodeType::Terminal;
    for (std::size_t i = 0; i < branch.Nodes.size(); ++i)
    {
      PlaceOnBranch& place = places[branch.Nodes[i]];
      if (branch.Length() > place.Length)
      {
        const double along = branch.ArcLength[i] / branch.Length();
        place = { branch.Length(), front > back ? 1.0 - along : along, std::min(front, back),
          std::max(front, back), isLimb };
      }
    }
  }
  return places;
}

/// Mean place, moments, measures and normals around each vertex.
class Surroundings
{
public:
  Surroundings(const AnalyzedMesh& shape, const std::vector<Eigen::Vector3d>& normals,
    const std::vector<double>& sizes)
    : Values(shape.Mesh.NumberOfVertices(), NumberOfValues)
  {
    for (int v = 0; v < shape.Mesh.NumberOfVertices(); ++v)
    {
      const Eigen::Vector3d& point = shape.Mesh.Points[v];
      this->Values.row(v) << point.transpose(), point.x() * point.transpose(),
        point.y() * point.y(), point.y() * point.z(), point.z() * point.z(), normals[v].transpose(),
        shape.AGD[v], sizes[v];
    }
  }

  void AddTo(FeatureColumns& columns, const AnalyzedMesh& shape,
    const std::vector<Eigen::Vector3d>& normals, double scale) const
  {
    const double width = scale * shape.Diagonal();
    const Eigen::MatrixXd mean = MeshSmoother(shape.Mesh, width).Smooth(this->Values);
    const auto placeOf = [&](int v) -> Eigen::Vector3d
    { return mean.block<1, 3>(v, 0).transpose(); };
    columns.Add([&](int v) { return (placeOf(v) - shape.Mesh.Points[v]).dot(normals[v]) / width; });
    std::vector<Eigen::Vector3d> extents;
    for (int v = 0; v < shape.Mesh.NumberOfVertices(); ++v)
    {
      const auto moment = mean.row(v).segment<6>(3);
      Eigen::Matrix3d spread;
      spread << moment[0], moment[1], moment[2], moment[1], moment[3], moment[4], moment[2],
        moment[4], moment[5];
      spread -= placeOf(v) * placeOf(v).transpose();
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread, Eigen::EigenvaluesOnly);
      extents.emplace_back(solver.eigenvalues().cwiseMax(0.0).cwiseSqrt() / width);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      columns.Add([&](int v) { return extents[v][axis]; });
    }
    columns.Add([&](int v) { return mean.row(v).segment<3>(9).norm(); });
    columns.Add([&](int v) { return mean(v, 12) - shape.AGD[v]; });
    columns.Add([&](int v) { return mean(v, 13); });
  }

private:
  static constexpr int NumberOfValues = 14; ///< as filled in the constructor
  Eigen::MatrixXd Values;
};

void AddSkeleton(FeatureColumns& columns, const AnalyzedMesh& shape,
  const std::vector<Eigen::Vector3d>& normals, double size)
{
  const std::vector<PlaceOnBranch> places = PlacesOfNodes(shape.Skeleton);
  static const SkeletonNode none;
  static const PlaceOnBranch nowhere;
  const auto nodeOf = [&](int v) -> const SkeletonNode&
  { return shape.NodeOfVertex[v] < 0 ? none : shape.Skeleton.Graph[shape.NodeOfVertex[v]]; };
  const auto placeOf = [&](int v) -> const PlaceOnBranch&
  { return shape.NodeOfVertex[v] < 0 ? nowhere : places[shape.NodeOfVertex[v]]; };
  const auto offset = [&](int v) -> Eigen::Vector3d
  { return shape.Mesh.Points[v] - nodeOf(v).Position; };
  columns.Add([&](int v) { return offset(v).norm() / size; });
  columns.Add([&](int v) { return offset(v).stableNormalized().dot(normals[v]); });
  columns.Add([&](int v) { return nodeOf(v).AGD; });
  columns.Add([&](int v) { return std::log(nodeOf(v).MSP / size + LeastLength); });
  columns.Add([&](int v) { return nodeOf(v).Radius / size; });
  columns.Add([&](int v) { return placeOf(v).Length / size; });
  columns.Add([&](int v) { return placeOf(v).Place; });
  columns.Add([&](int v) { return placeOf(v).ToOuterEnd() / size; });
  columns.Add([&](int v) { return placeOf(v).Inner; });
  columns.Add([&](int v) { return placeOf(v).Outer; });
  columns.Add([&](int v) { return placeOf(v).IsLimb ? 1.0 : 0.0; });
}
}

Eigen::MatrixXf SurfaceFeatures(const AnalyzedMesh& shape)
{
  const TriangleMesh& mesh = shape.Mesh;
  const std::vector<double> areas = mesh.TriangleAreas();
  const double size = std::sqrt(std::accumulate(areas.begin(), areas.end(), 0.0));
  const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
  std::vector<double> sizes;
  for (const double perimeter : shape.MSP)
  {
    sizes.push_back(std::log(perimeter / size + LeastLength));
  }
  FeatureColumns columns(mesh.NumberOfVertices());
  columns.Add([&](int v) { return shape.AGD[v]; });
  columns.Add([&](int v) { return sizes[v]; });
  columns.Add([&](int v) { return shape.GradientMagnitude[v]; });
  columns.Add([&](int v) { return shape.DihedralAngle[v]; });
  AddSkeleton(columns, shape, normals, size);
  columns.Add([&](int v) { return mesh.Points[v].norm() / size; });
  for (int axis = 0; axis < 3; ++axis)
  {
    columns.Add([&](int v) { return std::abs(mesh.Points[v][axis]) / size; });
    columns.Add([&](int v) { return std::abs(normals[v][axis]); });
  }
  const Surroundings surroundings(shape, normals, sizes);
  for (const double scale : Scales)
  {
    surroundings.AddTo(columns, shape, normals, scale);
  }
  return columns.Matrix();
}
}
