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
/// Around the branch, that find the surface where a boundary is to go: 22.5 degrees apart.
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

std::optional<Seat> FindSeat(
  const AnalyzedMesh& source, const MatchedSkeletons& match, const SegmentLoop& loop)
{
  const Enclosure enclosure = FindEnclosure(source, loop.HalfEdges);
  if (enclosure.NumberOfBranches != 1)
  {
    return {};
  }
  // The chain that runs through the branch, and where: by the branch's nodes around the place.
  const Branch& branch = source.Skeleton.Branches[enclosure.Branch];
  const ChainPosition at = LocateOnChain(branch, enclosure.ArcLength / branch.Length());
  const int a = branch.Nodes[at.Index];
  const int b = branch.Nodes[std::min(at.Index + 1, static_cast<int>(branch.Nodes.size()) - 1)];
  for (std::size_t c = 0; c < match.Chains.size(); ++c)
  {
    const Branch& chain = match.Chains[c].Source;
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

BoundaryTransfer::SourceLoop BoundaryTransfer::Describe(
  const SegmentLoop& loop, const Seat& seat) const
{
  const TriangleMesh& mesh = this->Source.Mesh;
  const Branch& chain = this->Match.Chains[seat.Chain].Source;
  SourceLoop result;
  result.Vertices = loop.Vertices(mesh);
  result.EdgeLength = EdgeLengthAround(mesh, result.Vertices);
  result.Plane = FitPlane(mesh, result.Vertices);
  constexpr double leastReach = 0.05; // of the chain: the tangent of a shorter piece is noise
  const double reach = std::max(result.Plane.Radius, leastReach * chain.Length());
  if (result.Plane.Normal.dot(TangentOfChain(this->Source.Skeleton, chain, seat.Ratio, reach)) <
    0.0)
  {
    result.Plane.Normal = -result.Plane.Normal;
  }
  double leftOffset = 0.0;
  for (int h : loop.HalfEdges)
  {
    leftOffset += result.Plane.Offset(mesh.Centroid(TriangleMesh::TriangleOf(h))) -
      result.Plane.Offset(mesh.Centroid(TriangleMesh::TriangleOf(mesh.Opposite[h])));
    result.WidestOffset =
      std::max(result.WidestOffset, std::abs(result.Plane.Offset(mesh.Points[mesh.From(h)])));
  }
  result.LeftIsFront = leftOffset < 0.0;
  return result;
}

std::optional<BoundaryTransfer::Cut> BoundaryTransfer::Transfer(
  const SegmentLoop& loop, const Seat& seat, double targetRatio)
{
  const ChainPair& chain = this->Match.Chains[seat.Chain];
  const SourceLoop source = this->Describe(loop, seat);
  // Places are carried by the chains' points, directions by the map, lengths by MSP.
  const Eigen::Vector3d sourcePoint = PointOnChain(this->Source.Skeleton, chain.Source, seat.Ratio);
  const Eigen::Vector3d targetPoint =
    PointOnChain(this->Target.Skeleton, chain.Target, targetRatio);
  const auto perimeter = [](const AnalyzedMesh& side, const Branch& branch, double ratio)
  {
    return InterpolateOnChain(
      branch, ratio, [&](int node) { return side.Skeleton.Graph[node].MSP; });
  };
  const double sourceMSP = perimeter(this->Source, chain.Source, seat.Ratio);
  const double targetMSP = perimeter(this->Target, chain.Target, targetRatio);
  TargetRing ring;
  ring.ToTarget = this->Map.Rotation(seat.Chain, seat.Ratio).transpose();
  ring.Scale = sourceMSP > 0.0 && targetMSP > 0.0
    ? targetMSP / sourceMSP
    : 1.0 / this->Map.RadialScale(seat.Chain, seat.Ratio);
  ring.Plane.Center =
    targetPoint + ring.Scale * (ring.ToTarget * (source.Plane.Center - sourcePoint));
  ring.Plane.Normal = ring.ToTarget * source.Plane.Normal;
  ring.Plane.Radius = ring.Scale * source.Plane.Radius;
  std::vector<Eigen::Vector3d> rayEnds;
  for (const Eigen::Vector3d& sample : SampleLoop(this->Source.Mesh, source.Vertices, NumberOfRays))
  {
    const Eigen::Vector3d ray =
      sample - source.Plane.Offset(sample) * source.Plane.Normal - source.Plane.Center;
    rayEnds.push_back(ring.Plane.Center + ring.Scale * (ring.ToTarget * ray));
  }
  ring.Seeds = SeedsOfRays(this->Target.Mesh, ring.Plane.Center, rayEnds);
  return this->TransferToRing(source, ring);
}

std::optional<BoundaryTransfer::Cut> BoundaryTransfer::TransferToRing(
  const SourceLoop& source, const TargetRing& ring)
{
  if (ring.Scale <= 0.0 || ring.Seeds.size() < 3)
  {
    return {};
  }
  // One relative height for both annuli, so that equal v means equal places: enough for the loop
  // and for a few rows of triangles on the coarser mesh.
  const double targetEdge = EdgeLengthAround(this->Target.Mesh, ring.Seeds);
  constexpr double rows = 2.5; // of faces at least: a map needs some inside
  const double halfHeight = std::max({ source.WidestOffset + source.EdgeLength,
    rows * source.EdgeLength, rows * targetEdge / ring.Scale });
  std::vector<Eigen::Vector3d> rayEnds;
  for (const Eigen::Vector3d& sample : SampleLoop(this->Source.Mesh, source.Vertices, NumberOfRays))
  {
    rayEnds.push_back(sample - source.Plane.Offset(sample) * source.Plane.Normal);
  }
  auto sourceRegion = BuildCoveringRegion(this->Source.Mesh, this->SourcePaths, source.Plane,
    SeedsOfRays(this->Source.Mesh, source.Plane.Center, rayEnds), halfHeight, source.Vertices);
  auto targetRegion = BuildCoveringRegion(
    this->Target.Mesh, this->TargetPaths, ring.Plane, ring.Seeds, ring.Scale * halfHeight, {});
  if (!sourceRegion || !targetRegion)
  {
    return {};
  }
  const auto sourceMap = CylinderMap::Build(this->SourcePaths, this->Source.Mesh,
    std::move(*sourceRegion), source.Plane.Center, source.Plane.Normal);
  auto targetMap = CylinderMap::Build(this->TargetPaths, this->Target.Mesh,
    std::move(*targetRegion), ring.Plane.Center, ring.Plane.Normal);
  if (!sourceMap || !targetMap)
  {
    return {};
  }
  Eigen::Matrix<double, 3, 2> sourceAxes;
  sourceAxes.col(0) = source.Plane.Normal.unitOrthogonal();
  sourceAxes.col(1) = source.Plane.Normal.cross(sourceAxes.col(0));
  const Eigen::Matrix<double, 3, 2> targetAxes = ring.ToTarget * sourceAxes;
  targetMap->Rotate(FindRotation(
    this->Source.Mesh, *sourceMap, sourceAxes, this->Target.Mesh, *targetMap, targetAxes));

  Cut cut;
  cut.LeftIsFront = source.LeftIsFront;
  SnakeGoal goal;
  goal.Plane = ring.Plane;
  goal.SearchRadius = this->SearchRadius;
  goal.DihedralTolerance = this->Settings.DihedralTolerance;
  for (int v : source.Vertices)
  {
    cut.Curve.Uv.push_back(sourceMap->OfVertex(v));
    cut.Curve.Points.push_back(targetMap->PointAt(cut.Curve.Uv.back()));
    goal.Offsets.push_back(ring.Scale * source.Plane.Offset(this->Source.Mesh.Points[v]));
    goal.DihedralAngles.push_back(this->Source.DihedralAngle[v]);
  }
  RefineCurve(this->Target, *targetMap, goal, cut.Curve);
  cut.Sides = SidesOfCurve(*targetMap, cut.Curve.Uv);
  return cut;
}
}
