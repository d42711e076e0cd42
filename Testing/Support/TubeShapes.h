// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TubeShapes_h
#define marrow_TubeShapes_h

#include "AnalyzedMesh.h"
#include "MatchedSkeletons.h"
#include "TestShapes.h"

#include <functional>

/// Tubes about the z axis with a skeleton of one branch, for which every boundary is known.
namespace marrow::test
{
struct TubeOptions
{
  double Radius = 0.5;
  double Length = 4.0;
  int Around = 32;
  int Along = 60;
  /// Moves points of the straight tube, and its skeleton; the identity if empty.
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> Bend;
  /// |∇MSP| by the fraction of the length; 0 if empty.
  std::function<double(double)> Gradient;
};

struct Tube
{
  AnalyzedMesh Analyzed;
  std::vector<double> Fraction; ///< per triangle, of the length, before bending
  std::vector<double> Angle;    ///< per triangle, about the axis, before bending
};

inline Tube MakeTube(const TubeOptions& options)
{
  Tube tube;
  AnalyzedMesh& side = tube.Analyzed;
  side.Mesh = MakeCylinder(options.Radius, options.Length, options.Around, options.Along);
  const auto fraction = [&](const Eigen::Vector3d& p)
  { return std::clamp(p.z() / options.Length + 0.5, 0.0, 1.0); };
  for (int t = 0; t < side.Mesh.NumberOfTriangles(); ++t)
  {
    const Eigen::Vector3d center = side.Mesh.Centroid(t);
    tube.Fraction.push_back(fraction(center));
    tube.Angle.push_back(std::atan2(center.y(), center.x()));
  }
  constexpr int numberOfNodes = 41;
  side.Skeleton.Graph = SkeletonGraph(numberOfNodes);
  for (int n = 0; n < numberOfNodes; ++n)
  {
    SkeletonNode& node = side.Skeleton.Graph[n];
    node.Position = { 0.0, 0.0, options.Length * (n / (numberOfNodes - 1.0) - 0.5) };
    node.Radius = options.Radius;
    node.MSP = 2.0 * Pi * options.Radius;
    // One end is farther from the middle than the other, so that the direction is known.
    node.AGD = n < numberOfNodes / 2 ? 1.0 : 0.9;
    if (n > 0)
    {
      boost::add_edge(n - 1, n, side.Skeleton.Graph);
    }
  }
  for (int v = 0; v < side.Mesh.NumberOfVertices(); ++v)
  {
    const double f = fraction(side.Mesh.Points[v]);
    const int node = static_cast<int>(std::lround(f * (numberOfNodes - 1)));
    side.NodeOfVertex.push_back(node);
    side.Skeleton.Graph[node].Vertices.push_back(v);
    side.MSP.push_back(2.0 * Pi * options.Radius);
    side.GradientMagnitude.push_back(options.Gradient ? options.Gradient(f) : 0.0);
    side.DihedralAngle.push_back(0.0);
  }
  if (options.Bend)
  {
    for (auto& point : side.Mesh.Points)
    {
      point = options.Bend(point);
    }
    for (int n = 0; n < numberOfNodes; ++n)
    {
      side.Skeleton.Graph[n].Position = options.Bend(side.Skeleton.Graph[n].Position);
    }
  }
  side.Skeleton.ExtractBranches();
  side.Skeleton.MeshDiagonal = side.Mesh.BoundingBoxDiagonal();
  side.Skeleton.MeshMaximumMSP = 2.0 * Pi * options.Radius;
  return tube;
}

/// The only branch of each, matched.
inline MatchedSkeletons MatchTubes(const Tube& source, const Tube& target)
{
  CorrespondenceIds ids;
  ids.SourceNodes.assign(source.Analyzed.Skeleton.NumberOfNodes(), -1);
  ids.TargetNodes.assign(target.Analyzed.Skeleton.NumberOfNodes(), -1);
  ids.SourceNodes.front() = ids.TargetNodes.front() = 0;
  ids.SourceNodes.back() = ids.TargetNodes.back() = 1;
  ids.SourceBranches = ids.TargetBranches = { 0 };
  return JoinChains(source.Analyzed.Skeleton, target.Analyzed.Skeleton, ids);
}
}

#endif
