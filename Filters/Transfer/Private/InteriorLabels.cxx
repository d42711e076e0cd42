// SPDX-License-Identifier: BSD-3-Clause
#include "InteriorLabels.h"

#include "LabelCut.h"
#include "MeshSmoother.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{
/// Per half-edge (of the pair the smaller) how dear it is to cut there: 1 on flat and convex
/// surface, less where it is concave. The curvature is that of normals smoothed over `width`, so
/// that it does not depend on the resolution.
class CutPrices
{
public:
  CutPrices(const TriangleMesh& mesh, double width)
    : Mesh(mesh)
    , Width(width)
    , VertexNormals(mesh.NumberOfVertices(), 3)
  {
    const std::vector<Eigen::Vector3d> normals = mesh.VertexNormals();
    for (int v = 0; v < mesh.NumberOfVertices(); ++v)
    {
      this->VertexNormals.row(v) = normals[v].transpose();
    }
    this->VertexNormals = MeshSmoother(mesh, width).Smooth(this->VertexNormals);
  }

  double operator()(int halfEdge) const
  {
    const int a = TriangleMesh::TriangleOf(halfEdge);
    const int b = TriangleMesh::TriangleOf(this->Mesh.Opposite[halfEdge]);
    const Eigen::Vector3d step = this->Mesh.Centroid(b) - this->Mesh.Centroid(a);
    const double squared = step.squaredNorm();
    const double curvature =
      squared > 0.0 ? (this->NormalOf(b) - this->NormalOf(a)).dot(step) / squared : 0.0;
    const double concavity = std::max(0.0, -curvature * 4.0 * this->Width);
    return std::max(1.0 / (1.0 + concavity * concavity), 0.05);
  }

private:
  Eigen::Vector3d NormalOf(int triangle) const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int corner : this->Mesh.Triangles[triangle])
    {
      sum += this->VertexNormals.row(corner).transpose();
    }
    const double length = sum.norm();
    return length > 0.0 ? Eigen::Vector3d(sum / length) : sum;
  }

  const TriangleMesh& Mesh;
  double Width;
  Eigen::MatrixXd VertexNormals;
};
}

std::vector<int> LabelInterior(const AnalyzedMesh& target, const GuidedMap& map,
  const std::vector<int>& regionOfTriangle, const AllowedPieces& allowed, const Progress& progress)
{
  constexpr double leastShare = 1e-4;
  const TriangleMesh& mesh = target.Mesh;
  const int numberOfPieces = static_cast<int>(map.Shares.cols());
  const double width = std::max(map.Width, 1e-300);
  LabelProblem problem;
  problem.NumberOfLabels = numberOfPieces;
  problem.Costs.resize(mesh.NumberOfTriangles());
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const std::vector<int>& choice = allowed[regionOfTriangle[t]];
    auto& costs = problem.Costs[t];
    if (choice.size() == 1)
    {
      costs.emplace_back(choice.front(), 0.0);
      continue;
    }
    const auto& corners = mesh.Triangles[t];
    double certainty = 0.0;
    for (int corner : corners)
    {
      certainty += map.Certainty[corner] / 3.0;
    }
    const double scale = certainty * mesh.Area(t) / width;
    double largest = 0.0;
    const auto share = [&](int piece)
    {
      return (map.Shares(corners[0], piece) + map.Shares(corners[1], piece) +
               map.Shares(corners[2], piece)) /
        3.0;
    };
    const auto consider = [&](int piece)
    {
      const double value = share(piece);
      largest = std::max(largest, value);
      if (value > leastShare)
      {
        costs.emplace_back(piece, -scale * std::log(value));
      }
    };
    if (choice.empty())
    {
      for (int piece = 0; piece < numberOfPieces; ++piece)
      {
        consider(piece);
      }
    }
    else
    {
      std::for_each(choice.begin(), choice.end(), consider);
    }
    if (costs.empty())
    {
      // The map puts this triangle into another region: here only the neighbours can tell.
      for (int piece : choice)
      {
        costs.emplace_back(piece, 0.0);
      }
    }
    if (largest > 1.0 - leastShare)
    {
      costs.assign(1,
        *std::min_element(costs.begin(), costs.end(),
          [](const auto& a, const auto& b) { return a.second < b.second; }));
    }
  }

  const CutPrices price(mesh, width);
  for (int h = 0; h < 3 * mesh.NumberOfTriangles(); ++h)
  {
    const int opposite = mesh.Opposite[h];
    if (opposite <= h)
    {
      continue;
    }
    const int a = TriangleMesh::TriangleOf(h);
    const int b = TriangleMesh::TriangleOf(opposite);
    if (problem.Costs[a].size() == 1 && problem.Costs[b].size() == 1)
    {
      continue;
    }
    const double length = (mesh.Points[mesh.From(h)] - mesh.Points[mesh.To(h)]).norm();
    problem.Edges.push_back({ a, b, length * price(h) });
  }
  return SolveLabels(problem, progress);
}
}
