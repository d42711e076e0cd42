// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryTransfer.h"

#include "CoveringRegion.h"
#include "CylinderMap.h"
#include "EnclosedBranch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
constexpr int NumberOfRays = 16;

/// The longest geodesic distance, from below: from any vertex to the farthest, and on from there.
double LongestGeodesic(const TriangleMesh& mesh)
{
  int start = 0;
  double longest = 0.0;
  for (int round = 0; round < 2; ++round)
  {
    const PathField field = DistanceField(mesh, { start });
    for (int v = 0; v < mesh.NumberOfVertices(); ++v)
    {
      if (std::isfinite(field.Distance[v]) && field.Distance[v] > longest)
      {
        longest = field.Distance[v];
        start = v;
      }
    }
  }
  return longest;
}

/// Points of a closed polyline at even spacing.
std::vector<Eigen::Vector3d> SampleLoop(
  const TriangleMesh& mesh, const std::vector<int>& vertices, int count)
{
  std::vector<double> arc(1, 0.0);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    arc.push_back(arc.back() +
      (mesh.Points[vertices[(i + 1) % vertices.size()]] - mesh.Points[vertices[i]]).norm());
  }
  std::vector<Eigen::Vector3d> samples;
  std::size_t i = 0;
  for (int k = 0; k < count; ++k)
  {
    const double at = arc.back() * k / count;
    while (i + 1 < vertices.size() && arc[i + 1] <= at)
    {
      ++i;
    }
    const double step = arc[i + 1] - arc[i];
    const double t = step > 0.0 ? (at - arc[i]) / step : 0.0;
    samples.push_back(
      (1.0 - t) * mesh.Points[vertices[i]] + t * mesh.Points[vertices[(i + 1) % vertices.size()]]);
  }
  return samples;
}

/// The mean length of the edges that meet the vertices.
double EdgeLengthAround(const TriangleMesh& mesh, const std::vector<int>& vertices)
{
  double sum = 0.0;
  int count = 0;
  for (int v : vertices)
  {
    mesh.ForEachNeighbor(v,
      [&](int other)
      {
        sum += (mesh.Points[other] - mesh.Points[v]).norm();
        ++count;
      });
  }
  return count > 0 ? sum / count : 0.0;
}
}

std::vector<std::pair<int, char>> SidesOfCurve(
  const CylinderMap& map, const std::vector<Eigen::Vector2d>& curve)
{
  std::vector<std::pair<int, char>> sides;
  const std::vector<int>& triangles = map.GetRegion().Triangles;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto& corners = map.Corners(i);
    const Eigen::Vector2d center = (corners[0] + corners[1] + corners[2]) / 3.0;
    // A line up from v = -infinity crosses the curve an odd number of times before points beyond it.
    int crossings = 0;
    for (std::size_t k = 0; k < curve.size(); ++k)
    {
      const Eigen::Vector2d& a = curve[k];
      const Eigen::Vector2d& b = curve[(k + 1) % curve.size()];
      const double span = b.x() - a.x() - std::round(b.x() - a.x());
      // Half-open, so that a shared end counts once.
      const double low = std::min(a.x(), a.x() + span);
      const double turn = std::ceil(low - center.x());
      const double u = center.x() + turn;
      if (u >= low && u < low + std::abs(span))
      {
        const double v = a.y() + (u - a.x()) / span * (b.y() - a.y());
        crossings += v < center.y() ? 1 : 0;
      }
    }
    sides.emplace_back(triangles[i], static_cast<char>(crossings % 2));
  }
  return sides;
}

BoundaryTransfer::BoundaryTransfer(const AnalyzedMesh& source, const AnalyzedMesh& target,
  const MatchedSkeletons& match, const SkeletonMap& map, const Parameters& parameters)
  : Source(source)
  , Target(target)
  , Match(match)
  , Map(map)
  , Settings(parameters)
  , SourcePaths(source.Mesh)
  , TargetPaths(target.Mesh)
  , SearchRadius(parameters.SearchRegion * LongestGeodesic(target.Mesh))
{
}

std::optional<BoundaryTransfer::Seat> BoundaryTransfer::FindSeat(const SegmentLoop& loop) const
{
  const Enclosure enclosure = FindEnclosure(this->Source, loop.HalfEdges);
  if (enclosure.NumberOfBranches != 1)
  {
    return {};
  }
  // The chain that runs through the branch, and where: by the branch's nodes around the place.
  const Branch& branch = this->Source.Skeleton.Branches[enclosure.Branch];
  const ChainPosition at = LocateOnChain(branch, enclosure.ArcLength / branch.Length());
  const int a = branch.Nodes[at.Index];
  const int b = branch.Nodes[std::min(at.Index + 1, static_cast<int>(branch.Nodes.size()) - 1)];
  for (std::size_t c = 0; c < this->Match.Chains.size(); ++c)
  {
    const Branch& chain = this->Match.Chains[c].Source;
    for (std::size_t i = 1; i < chain.Nodes.size(); ++i)
    {
      const bool along = chain.Nodes[i - 1] == a && chain.Nodes[i] == b;
      const bool against = chain.Nodes[i - 1] == b && chain.Nodes[i] == a;
      if (along || against)
      {
        const double t = along ? at.Fraction : 1.0 - at.Fraction;
        const double arc = (1.0 - t) * chain.ArcLength[i - 1] + t * chain.ArcLength[i];
        return Seat{ static_cast<int>(c), arc / chain.Length() };
      }
    }
  }
  return {};
}

std::optional<BoundaryTransfer::Cut> BoundaryTransfer::Transfer(
  const SegmentLoop& loop, const Seat& seat)
{
  const ChainPair& chain = this->Match.Chains[seat.Chain];
  const std::vector<int> vertices = loop.Vertices(this->Source.Mesh);
  Cut cut;
  cut.SourceRatio = seat.Ratio;
  cut.TargetRatio = this->Map.TargetRatio(seat.Chain, seat.Ratio);

  // The source's plane looks along the chain.
  FittingPlane sourcePlane = FitPlane(this->Source.Mesh, vertices);
  const double reach = std::max(sourcePlane.Radius, 0.05 * chain.Source.Length());
  const Eigen::Vector3d tangent =
    TangentOfChain(this->Source.Skeleton, chain.Source, seat.Ratio, reach);
  if (sourcePlane.Normal.dot(tangent) < 0.0)
  {
    sourcePlane.Normal = -sourcePlane.Normal;
  }
  double leftOffset = 0.0;
  double widest = 0.0;
  for (int h : loop.HalfEdges)
  {
    leftOffset += sourcePlane.Offset(this->Source.Mesh.Centroid(TriangleMesh::TriangleOf(h))) -
      sourcePlane.Offset(
        this->Source.Mesh.Centroid(TriangleMesh::TriangleOf(this->Source.Mesh.Opposite[h])));
    widest = std::max(
      widest, std::abs(sourcePlane.Offset(this->Source.Mesh.Points[this->Source.Mesh.From(h)])));
  }
  cut.LeftIsFront = leftOffset < 0.0;

  // Carried to the target: places by the chains' points, directions by the map, lengths by MSP.
  const Eigen::Vector3d sourcePoint = PointOnChain(this->Source.Skeleton, chain.Source, seat.Ratio);
  const Eigen::Vector3d targetPoint =
    PointOnChain(this->Target.Skeleton, chain.Target, cut.TargetRatio);
  const Eigen::Matrix3d toTarget = this->Map.Rotation(seat.Chain, seat.Ratio).transpose();
  const auto perimeter = [](const AnalyzedMesh& side, const Branch& branch, double ratio)
  {
    return InterpolateOnChain(
      branch, ratio, [&](int node) { return side.Skeleton.Graph[node].MSP; });
  };
  const double sourceMSP = perimeter(this->Source, chain.Source, seat.Ratio);
  const double targetMSP = perimeter(this->Target, chain.Target, cut.TargetRatio);
  const double scale = sourceMSP > 0.0 && targetMSP > 0.0
    ? targetMSP / sourceMSP
    : 1.0 / this->Map.RadialScale(seat.Chain, seat.Ratio);
  FittingPlane targetPlane;
  targetPlane.Center = targetPoint + scale * (toTarget * (sourcePlane.Center - sourcePoint));
  targetPlane.Normal = toTarget * sourcePlane.Normal;
  targetPlane.Radius = scale * sourcePlane.Radius;

  std::vector<Eigen::Vector3d> sourceRays;
  std::vector<Eigen::Vector3d> targetRays;
  for (const Eigen::Vector3d& sample : SampleLoop(this->Source.Mesh, vertices, NumberOfRays))
  {
    const Eigen::Vector3d inPlane = sample - sourcePlane.Offset(sample) * sourcePlane.Normal;
    sourceRays.push_back(inPlane);
    targetRays.push_back(targetPlane.Center + scale * (toTarget * (inPlane - sourcePlane.Center)));
  }

  // One relative height for both annuli, so that equal v means equal places: enough for the loop
  // and for a few rows of triangles on the coarser mesh.
  const double sourceEdge = EdgeLengthAround(this->Source.Mesh, vertices);
  const ChainPosition at = LocateOnChain(chain.Target, cut.TargetRatio);
  const std::vector<int>& ring = this->Target.Skeleton.Graph[chain.Target.Nodes[at.Index]].Vertices;
  const double targetEdge =
    ring.empty() ? scale * sourceEdge : EdgeLengthAround(this->Target.Mesh, ring);
  const double halfHeight =
    std::max({ widest + sourceEdge, 2.5 * sourceEdge, 2.5 * targetEdge / scale });
  auto sourceRegion = BuildCoveringRegion(
    this->Source.Mesh, this->SourcePaths, sourcePlane, sourceRays, halfHeight, vertices);
  auto targetRegion = BuildCoveringRegion(
    this->Target.Mesh, this->TargetPaths, targetPlane, targetRays, scale * halfHeight, {});
  if (!sourceRegion || !targetRegion)
  {
    return {};
  }
  const auto sourceMap = CylinderMap::Build(this->SourcePaths, this->Source.Mesh,
    std::move(*sourceRegion), sourcePlane.Center, sourcePlane.Normal);
  auto targetMap = CylinderMap::Build(this->TargetPaths, this->Target.Mesh,
    std::move(*targetRegion), targetPlane.Center, targetPlane.Normal);
  if (!sourceMap || !targetMap)
  {
    return {};
  }
  Eigen::Matrix<double, 3, 2> sourceAxes;
  sourceAxes.col(0) = sourcePlane.Normal.unitOrthogonal();
  sourceAxes.col(1) = sourcePlane.Normal.cross(sourceAxes.col(0));
  const Eigen::Matrix<double, 3, 2> targetAxes = toTarget * sourceAxes;
  targetMap->Rotate(FindRotation(
    this->Source.Mesh, *sourceMap, sourceAxes, this->Target.Mesh, *targetMap, targetAxes));

  SnakeGoal goal;
  goal.Plane = targetPlane;
  goal.SearchRadius = this->SearchRadius;
  goal.DihedralTolerance = this->Settings.DihedralTolerance;
  for (int v : vertices)
  {
    cut.Curve.Uv.push_back(sourceMap->OfVertex(v));
    cut.Curve.Points.push_back(targetMap->PointAt(cut.Curve.Uv.back()));
    goal.Offsets.push_back(scale * sourcePlane.Offset(this->Source.Mesh.Points[v]));
    goal.DihedralAngles.push_back(this->Source.DihedralAngle[v]);
  }
  RefineCurve(this->Target, *targetMap, goal, cut.Curve);
  cut.Sides = SidesOfCurve(*targetMap, cut.Curve.Uv);
  return cut;
}
}
