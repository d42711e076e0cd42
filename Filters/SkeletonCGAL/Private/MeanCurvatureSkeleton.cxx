// SPDX-License-Identifier: BSD-3-Clause
// This file includes parts of CGAL that are under the GPL; so the library it goes into is, too.
#include "MeanCurvatureSkeleton.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mean_curvature_flow_skeletonization.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <utility>
#include <vector>

namespace marrow
{
namespace
{
// With inexact predicates its test for inside may walk for ever on what has contracted to nothing.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Skeletonization = CGAL::Mean_curvature_flow_skeletonization<SurfaceMesh>;
using ContractedEdge = Skeletonization::edge_descriptor;
}
}

#if CGAL_VERSION_NR < 1060000000
/// CGAL keeps the edges to collapse in a std::set. Before version 6.0 it orders them by the address
/// of whichever half-edge a descriptor holds, which is no consistent order and differs from run to
/// run (CGAL's issue 7511); by the numbers of the half-edges it is one, and the same in every run.
template <>
struct std::less<marrow::ContractedEdge>
{
  bool operator()(const marrow::ContractedEdge& a, const marrow::ContractedEdge& b) const
  {
    const auto number = [](const marrow::ContractedEdge& edge)
    { return std::min(edge.halfedge()->id(), edge.halfedge()->opposite()->id()); };
    return number(a) < number(b);
  }
};
#endif

namespace marrow
{
namespace
{
/// CGAL's mesh, without the points that no triangle uses, and of about unit size.
struct PeerMesh
{
  SurfaceMesh Surface;
  std::vector<int> Vertices; ///< ours, per vertex of CGAL's
  double Scale = 1.0;        ///< from our length to CGAL's
};

/// CGAL compares lengths with fixed numbers, so that the result would depend on the unit. A power of
/// two scales without rounding: what is of unit size already is left as it is.
double PowerOfTwoToUnitSize(double diagonal)
{
  int exponent = 0;
  std::frexp(diagonal, &exponent);
  return std::ldexp(1.0, -exponent);
}

PeerMesh ToPeerMesh(const TriangleMesh& mesh)
{
  PeerMesh peer;
  peer.Scale = PowerOfTwoToUnitSize(mesh.BoundingBoxDiagonal());
  std::vector<SurfaceMesh::Vertex_index> vertex(mesh.Points.size());
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    if (mesh.Outgoing[v] >= 0)
    {
      const Eigen::Vector3d p = peer.Scale * mesh.Points[v];
      vertex[v] = peer.Surface.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
      peer.Vertices.push_back(v);
    }
  }
  for (const auto& t : mesh.Triangles)
  {
    peer.Surface.add_face(vertex[t[0]], vertex[t[1]], vertex[t[2]]);
  }
  return peer;
}

/// What CGAL's contract_until_convergence does, with progress. False if nothing comes of it, or if
/// the user asked to stop.
bool ContractUntilConvergence(
  Skeletonization& flow, const SurfaceMesh& surface, const Progress& progress)
{
  const double originalArea = CGAL::Polygon_mesh_processing::area(surface);
  double lastArea = 0.0;
  double done = 0.0;
  for (std::size_t i = 0; i < flow.max_iterations(); ++i)
  {
    flow.contract();
    const double area = CGAL::Polygon_mesh_processing::area(flow.meso_skeleton());
    const double change = std::abs(lastArea - area) / originalArea;
    lastArea = area;
    if (!std::isfinite(change))
    {
      return false;
    }
    if (change < flow.area_variation_factor())
    {
      return true;
    }
    // The change falls about geometrically.
    constexpr double atTheMost =
      0.95; // of the progress; how many rounds there will be is not known
    done = std::clamp(std::log(change) / std::log(flow.area_variation_factor()), done, atTheMost);
    if (!Report(progress, done))
    {
      return false;
    }
  }
  return true;
}

Skeleton FromPeerSkeleton(const Skeletonization::Skeleton& found, const PeerMesh& peer)
{
  const std::size_t numberOfNodes = boost::num_vertices(found);
  Skeleton skeleton;
  skeleton.Graph = SkeletonGraph(numberOfNodes);
  for (std::size_t n = 0; n < numberOfNodes; ++n)
  {
    SkeletonNode& node = skeleton.Graph[n];
    const Kernel::Point_3& p = found[n].point;
    node.Position = Eigen::Vector3d(p.x(), p.y(), p.z()) / peer.Scale;
    for (const auto vertex : found[n].vertices)
    {
      node.Vertices.push_back(peer.Vertices[vertex]);
    }
    std::sort(node.Vertices.begin(), node.Vertices.end());
  }
  for (auto [e, end] = boost::edges(found); e != end; ++e)
  {
    boost::add_edge(boost::source(*e, found), boost::target(*e, found), skeleton.Graph);
  }
  skeleton.ExtractBranches();
  return skeleton;
}

bool IsUsable(const Skeleton& skeleton)
{
  for (int n = 0; n < skeleton.NumberOfNodes(); ++n)
  {
    if (!skeleton.Graph[n].Position.allFinite())
    {
      return false;
    }
  }
  return skeleton.NumberOfBranches() > 0;
}
}

std::string ComputeMeanCurvatureSkeleton(const TriangleMesh& mesh,
  const MeanCurvatureWeights& weights, Skeleton& skeleton, const Progress& progress)
{
  skeleton = {};
  const PeerMesh peer = ToPeerMesh(mesh);
  std::string reason = "the contraction did not end in a curve";
  bool stopped = false;
  const auto watched = [&](double fraction)
  {
    stopped = stopped || !Report(progress, fraction);
    return !stopped;
  };
  try
  {
    Skeletonization flow(peer.Surface);
    flow.set_quality_speed_tradeoff(weights.QualitySpeedTradeoff);
    flow.set_is_medially_centered(weights.MediallyCenteredSpeedTradeoff > 0.0);
    flow.set_medially_centered_speed_tradeoff(weights.MediallyCenteredSpeedTradeoff);
    if (ContractUntilConvergence(flow, peer.Surface, watched))
    {
      Skeletonization::Skeleton found;
      flow.convert_to_skeleton(found);
      skeleton = FromPeerSkeleton(found, peer);
      if (IsUsable(skeleton))
      {
        Report(progress, 1.0);
        return {};
      }
    }
  }
  catch (const std::exception& exception)
  {
    reason = exception.what();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
  }
  skeleton = {};
  return stopped ? std::string()
                 : "CGAL's mean curvature flow gives no skeleton of this mesh (" + reason +
      "): remesh it with more uniform triangles, or use vtkMSPSkeleton.";
}
}
