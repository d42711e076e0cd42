// SPDX-License-Identifier: BSD-3-Clause
#include "AnalyzedSide.h"

#include "ArrayNames.h"
#include "MSPSkeleton.h"
#include "MeshBridge.h"
#include "SkeletonBridge.h"
#include "SkeletonFrame.h"
#include "SurfaceMeasures.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkMSPSkeleton.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <map>
#include <utility>

namespace marrow
{
namespace
{
/// Reads a connected skeleton and φ, which the mesh holds.
std::string ReadSkeleton(vtkPolyData* mesh, vtkPolyData* skeleton, const PreparedSurface& surface,
  const Body& body, AnalyzedMesh& analyzed)
{
  std::string error = ToSkeleton(skeleton, analyzed.Skeleton);
  if (!error.empty())
  {
    return error;
  }
  analyzed.Skeleton = ToFrame(std::move(analyzed.Skeleton), body.Frame);
  std::vector<int> nodeOfPoint;
  if (!GetArray(mesh->GetPointData(), names::SkeletonNodeId,
        static_cast<int>(mesh->GetNumberOfPoints()), nodeOfPoint))
  {
    return std::string("a skeleton is connected, but the mesh has no point array \"") +
      names::SkeletonNodeId +
      "\" that says which vertex belongs to which of its points: connect the second output of "
      "vtkMSPSkeleton as the mesh, or no skeleton, and it is computed.";
  }
  const auto [least, most] = std::minmax_element(nodeOfPoint.begin(), nodeOfPoint.end());
  if (*least < -1 || *most >= analyzed.Skeleton.NumberOfNodes())
  {
    return std::string("the skeleton does not belong to the mesh: \"") + names::SkeletonNodeId +
      "\" runs from " + std::to_string(*least) + " to " + std::to_string(*most) +
      " but the skeleton has " + std::to_string(analyzed.Skeleton.NumberOfNodes()) +
      " points; connect both outputs of one vtkMSPSkeleton.";
  }
  analyzed.NodeOfVertex.clear();
  for (int v = 0; v < body.Mesh.NumberOfVertices(); ++v)
  {
    analyzed.NodeOfVertex.push_back(nodeOfPoint[surface.PointOf(body, v)]);
  }
  SetNodeOfVertices(analyzed.Skeleton, analyzed.NodeOfVertex);
  return {};
}

Skeleton MakeSkeleton(
  const TriangleMesh& mesh, const VertexMeasures& measures, const Progress& progress)
{
  // The defaults stand in the header of the filter alone.
  vtkNew<vtkMSPSkeleton> defaults;
  const double spacing = defaults->GetNodeSpacing() * mesh.BoundingBoxDiagonal();
  return ToFrame(ComputeMSPSkeleton(mesh, measures, defaults->GetFinestArea(), spacing, progress),
    CanonicalFrame());
}

/// What the transfer reads of the measures; what follows from MSP and the mesh is derived where the mesh
/// does not bring it.
void SetMeasures(const VertexMeasures& measures, AnalyzedMesh& analyzed)
{
  analyzed.AGD = measures.AGD;
  analyzed.MSP = measures.MSP;
  const std::vector<Eigen::Vector3d> gradient = measures.MSPGradient.empty()
    ? VertexGradient(analyzed.Mesh, measures.MSP)
    : measures.MSPGradient;
  analyzed.GradientMagnitude.clear();
  for (const Eigen::Vector3d& vector : gradient)
  {
    analyzed.GradientMagnitude.push_back(CanonicalFrame::ToGrid(vector.norm()));
  }
  analyzed.DihedralAngle =
    measures.DihedralAngle.empty() ? VertexDihedralAngles(analyzed.Mesh) : measures.DihedralAngle;
}

std::string AnalyzeBody(vtkPolyData* mesh, vtkPolyData* skeleton, const PreparedSurface& surface,
  const Body& body, AnalyzedMesh& analyzed, const Progress& progress)
{
  constexpr double afterMeasures = 0.6; // of the time for both
  VertexMeasures measures;
  std::string error = ReadMeasures(mesh, surface, body, measures);
  if (!error.empty())
  {
    return error;
  }
  const bool isComplete = !measures.MSP.empty() &&
    (skeleton ||
      !(measures.AGD.empty() || measures.MSPCenter.empty() || measures.MSPValid.empty()));
  if (!isComplete &&
    !MeasureBody(
      body, DefaultMeasureParameters(), measures, SubProgress(progress, 0.0, afterMeasures)))
  {
    return {};
  }
  analyzed.Mesh = body.Mesh;
  SetMeasures(measures, analyzed);
  if (skeleton)
  {
    error = ReadSkeleton(mesh, skeleton, surface, body, analyzed);
  }
  else
  {
    analyzed.Skeleton =
      MakeSkeleton(body.Mesh, measures, SubProgress(progress, afterMeasures, 1.0));
    analyzed.NodeOfVertex = NodeOfVertices(analyzed.Skeleton, body.Mesh.NumberOfVertices());
  }
  if (error.empty())
  {
    FillNodeOfVertex(analyzed.Mesh, analyzed.NodeOfVertex);
    analyzed.Skeleton.MeshDiagonal = analyzed.Mesh.BoundingBoxDiagonal();
    analyzed.Slices = FindSlices(analyzed.Mesh);
  }
  return error;
}
}

std::string AnalyzeSide(
  vtkPolyData* mesh, vtkPolyData* skeleton, AnalyzedSide& side, const Progress& progress)
{
  constexpr double afterSurface = 0.1;
  vtkNew<vtkMSPSkeleton> defaults;
  std::string error = PrepareSurface(mesh, defaults->GetMaximumFaces(),
    skeleton ? BodyMode::Together : BodyMode::Apart, side.Surface,
    SubProgress(progress, 0.0, afterSurface));
  if (!error.empty())
  {
    return error;
  }
  const std::size_t size = side.Surface.Bodies.size();
  side.Bodies.resize(size);
  for (std::size_t b = 0; b < size && error.empty(); ++b)
  {
    const double span = (1.0 - afterSurface) / static_cast<double>(size);
    const double begin = afterSurface + span * static_cast<double>(b);
    error = AnalyzeBody(mesh, skeleton, side.Surface, side.Surface.Bodies[b], side.Bodies[b],
      SubProgress(progress, begin, begin + span));
  }
  return error;
}

GivenCorrespondence ReadCorrespondence(vtkPolyData* skeleton)
{
  GivenCorrespondence given;
  if (!skeleton)
  {
    return given;
  }
  // The lines of a vtkPolyData come after its vertices among its cells, and the branches are the lines.
  const int numberOfCells = static_cast<int>(skeleton->GetNumberOfCells());
  const auto readBranches = [&](const char* name, std::vector<int>& ofBranches)
  {
    const bool read = GetArray(skeleton->GetCellData(), name, numberOfCells, ofBranches);
    if (read)
    {
      ofBranches.erase(ofBranches.begin(), ofBranches.begin() + skeleton->GetNumberOfVerts());
      ofBranches.resize(skeleton->GetNumberOfLines());
    }
    return read;
  };
  if (!GetArray(skeleton->GetPointData(), names::CorrespondenceId,
        static_cast<int>(skeleton->GetNumberOfPoints()), given.Nodes) ||
    !readBranches(names::BranchCorrespondenceId, given.Branches))
  {
    return {};
  }
  if (!readBranches(names::BranchCorrespondenceOrder, given.Order.Order) ||
    !readBranches(names::BranchCorrespondenceReversed, given.Order.Reversed))
  {
    given.Order = {};
  }
  vtkDataArray* confidence = skeleton->GetFieldData()->GetArray(names::CorrespondenceConfidence);
  if (confidence && confidence->GetNumberOfTuples() > 0)
  {
    given.Confidence = std::clamp(confidence->GetTuple1(0), 0.0, 1.0);
  }
  return given;
}

std::vector<int> LabelsOfBody(
  const PreparedSurface& surface, const Body& body, const std::vector<int>& labelOfCell)
{
  const WorkingSurface& working = surface.Working;
  std::vector<int> indexInBody(working.Mesh.Triangles.size(), -1);
  for (int t = 0; t < body.Mesh.NumberOfTriangles(); ++t)
  {
    indexInBody[body.OriginalTriangle[t]] = t;
  }
  std::vector<std::map<int, double>> areas(body.Mesh.Triangles.size());
  for (int t = 0; t < working.Full.NumberOfTriangles(); ++t)
  {
    const int own = indexInBody[working.TriangleOfFullTriangle[t]];
    const int polygon = working.CellOfFullTriangle[t];
    if (own >= 0 && polygon >= 0)
    {
      areas[own][labelOfCell[surface.CellOfPolygon[polygon]]] += working.Full.Area(t);
    }
  }
  std::vector<int> labels(body.Mesh.Triangles.size(), 0);
  std::vector<int> front;
  std::vector<char> isKnown(labels.size(), 0);
  for (std::size_t t = 0; t < labels.size(); ++t)
  {
    if (!areas[t].empty())
    {
      labels[t] = std::max_element(areas[t].begin(), areas[t].end(),
        [](const auto& a, const auto& b) {
          return a.second < b.second;
        })->first;
      isKnown[t] = 1;
      front.push_back(static_cast<int>(t));
    }
  }
  // Where a hole was filled or the surface wrapped, no cell may lie nearest: from the neighbours inwards.
  for (std::size_t i = 0; i < front.size(); ++i)
  {
    for (int h = 3 * front[i]; h < 3 * front[i] + 3; ++h)
    {
      const int opposite = body.Mesh.Opposite[h];
      const int neighbor = opposite < 0 ? -1 : TriangleMesh::TriangleOf(opposite);
      if (neighbor >= 0 && !isKnown[neighbor])
      {
        isKnown[neighbor] = 1;
        labels[neighbor] = labels[front[i]];
        front.push_back(neighbor);
      }
    }
  }
  return labels;
}
}
