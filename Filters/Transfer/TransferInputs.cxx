// SPDX-License-Identifier: BSD-3-Clause
#include "TransferInputs.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "LabelBridge.h"
#include "MeshBridge.h"
#include "SkeletonBridge.h"
#include "SkeletonMatching.h"

#include <vtkAlgorithm.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkMSPField.h>
#include <vtkMSPSkeleton.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace marrow
{
namespace
{

vtkSmartPointer<vtkPolyData> OutputOf(vtkAlgorithm* filter, int port)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(filter->GetOutputDataObject(port));
  return copy;
}

bool ReadMeasures(vtkPolyData* mesh, AnalyzedMesh& analyzed)
{
  vtkPointData* points = mesh->GetPointData();
  const int size = static_cast<int>(mesh->GetNumberOfPoints());
  std::vector<Eigen::Vector3d> gradient;
  if (!GetArray(points, names::MSP, size, analyzed.MSP) ||
    !GetArray(points, names::MSPGradient, size, gradient) ||
    !GetArray(points, names::DihedralAngle, size, analyzed.DihedralAngle))
  {
    return false;
  }
  analyzed.GradientMagnitude.clear();
  for (const auto& vector : gradient)
  {
    analyzed.GradientMagnitude.push_back(vector.norm());
  }
  return true;
}

std::string FiniteError(const std::vector<double>& values, const char* name)
{
  const auto bad = std::find_if_not(
    values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  return bad == values.end()
    ? std::string()
    : std::string("the mesh's array \"") + name + "\" is not finite at point " +
      std::to_string(bad - values.begin()) + ": remove the array, and it is computed anew.";
}

std::string ReadSkeleton(const TransferSide& side, AnalyzedMesh& analyzed)
{
  std::string error = ToSkeleton(side.Skeleton, analyzed.Skeleton);
  if (!error.empty())
  {
    return error;
  }
  const int numberOfVertices = analyzed.Mesh.NumberOfVertices();
  if (!GetArray(
        side.Mesh->GetPointData(), names::SkeletonNodeId, numberOfVertices, analyzed.NodeOfVertex))
  {
    return std::string("a skeleton is connected, but the mesh has no point array \"") +
      names::SkeletonNodeId +
      "\" that says which vertex belongs to which of its points: connect the second output of "
      "vtkMSPSkeleton as the mesh, or no skeleton, and it is computed.";
  }
  if (!SetNodeOfVertices(analyzed.Skeleton, analyzed.NodeOfVertex))
  {
    const auto [least, most] =
      std::minmax_element(analyzed.NodeOfVertex.begin(), analyzed.NodeOfVertex.end());
    return std::string("the skeleton does not belong to the mesh: \"") + names::SkeletonNodeId +
      "\" runs from " + std::to_string(*least) + " to " + std::to_string(*most) +
      " but the skeleton has " + std::to_string(analyzed.Skeleton.NumberOfNodes()) +
      " points; connect both outputs of one vtkMSPSkeleton.";
  }
  FillNodeOfVertex(analyzed.Mesh, analyzed.NodeOfVertex);
  analyzed.Skeleton.MeshDiagonal = analyzed.Mesh.BoundingBoxDiagonal();
  return {};
}

/// The values of the lines, which are the branches: vertex cells come before them, polygons after.
bool GetBranchArray(vtkPolyData* skeleton, const char* name, std::vector<int>& values)
{
  std::vector<int> cells;
  if (!GetArray(
        skeleton->GetCellData(), name, static_cast<int>(skeleton->GetNumberOfCells()), cells))
  {
    return false;
  }
  const auto first = cells.begin() + skeleton->GetNumberOfVerts();
  values.assign(first, first + skeleton->GetNumberOfLines());
  return true;
}

bool GetIds(vtkPolyData* skeleton, std::vector<int>& nodes, std::vector<int>& branches,
  CorrespondenceIds::ChainOrder& order)
{
  const int numberOfNodes = static_cast<int>(skeleton->GetNumberOfPoints());
  if (!GetBranchArray(skeleton, names::BranchCorrespondenceOrder, order.Order) ||
    !GetBranchArray(skeleton, names::BranchCorrespondenceReversed, order.Reversed))
  {
    order = {};
  }
  return GetArray(skeleton->GetPointData(), names::CorrespondenceId, numberOfNodes, nodes) &&
    GetBranchArray(skeleton, names::BranchCorrespondenceId, branches);
}

CorrespondenceIds::ChainOrder OrderOf(const SkeletonMatch::Side& side)
{
  return { side.BranchOrder, { side.BranchReversed.begin(), side.BranchReversed.end() } };
}
}

std::string CompleteSide(
  vtkAlgorithm* outer, double from, double to, TransferSide& side, AnalyzedMesh& analyzed)
{
  MeshReport report;
  std::string error = ToManifoldMesh(side.Mesh, analyzed.Mesh, report);
  if (!error.empty())
  {
    return side.Role + ": " + error;
  }
  if (!side.Skeleton)
  {
    vtkNew<vtkMSPSkeleton> skeleton;
    WatchInner(outer, skeleton, from, to);
    skeleton->SetInputData(side.Mesh);
    skeleton->Update();
    if (IsAborted(outer))
    {
      // From VTK 9.2 on the executive has emptied the outputs.
      return {};
    }
    side.Skeleton = OutputOf(skeleton, 0);
    side.Mesh = OutputOf(skeleton, 1);
  }
  if (!ReadMeasures(side.Mesh, analyzed))
  {
    vtkNew<vtkMSPField> field;
    WatchInner(outer, field, from, to);
    field->SetInputData(side.Mesh);
    field->Update();
    side.Mesh = OutputOf(field, 0);
  }
  if (IsAborted(outer))
  {
    return {};
  }
  if (!ReadMeasures(side.Mesh, analyzed))
  {
    return side.Role +
      ": the measures of the mesh could not be computed; see the message of "
      "vtkMSPField or vtkMSPSkeleton.";
  }
  for (const auto& [values, name] :
    { std::pair{ &analyzed.MSP, names::MSP }, { &analyzed.GradientMagnitude, names::MSPGradient },
      { &analyzed.DihedralAngle, names::DihedralAngle } })
  {
    error = error.empty() ? FiniteError(*values, name) : error;
  }
  error = error.empty() ? ReadSkeleton(side, analyzed) : error;
  return error.empty() ? error : side.Role + ": " + error;
}

std::vector<Answer> FindAnswers(vtkAlgorithm* outer, double from, double to,
  const TransferSide& source, const AnalyzedMesh& sourceMesh, const TransferSide& target,
  const AnalyzedMesh& targetMesh)
{
  CorrespondenceIds ids;
  if (GetIds(source.Skeleton, ids.SourceNodes, ids.SourceBranches, ids.SourceOrder) &&
    GetIds(target.Skeleton, ids.TargetNodes, ids.TargetBranches, ids.TargetOrder))
  {
    vtkDataArray* array =
      source.Skeleton->GetFieldData()->GetArray(names::CorrespondenceConfidence);
    const double confidence =
      array && array->GetNumberOfTuples() > 0 ? std::clamp(array->GetTuple1(0), 0.0, 1.0) : 1.0;
    return { { JoinChains(sourceMesh.Skeleton, targetMesh.Skeleton, ids), 0.0, confidence } };
  }
  std::vector<Answer> answers;
  SkeletonMatching matching;
  if (MatchSkeletons(
        sourceMesh.Skeleton, targetMesh.Skeleton, {}, matching, ProgressOf(outer, from, to)))
  {
    matching.Leaves.resize(std::min(matching.Leaves.size(), MostAnswers));
    for (const SkeletonMatch& leaf : matching.Leaves)
    {
      const CorrespondenceIds idsOfLeaf{ leaf.Source.NodeId, leaf.Target.NodeId,
        leaf.Source.BranchId, leaf.Target.BranchId, OrderOf(leaf.Source), OrderOf(leaf.Target) };
      answers.push_back({ JoinChains(sourceMesh.Skeleton, targetMesh.Skeleton, idsOfLeaf),
        leaf.GlobalCost, leaf.Confidence });
    }
  }
  return answers;
}

std::string ReadLabels(
  vtkPolyData* mesh, vtkDataArray* array, const std::string& name, std::vector<int>& labels)
{
  if (!array)
  {
    std::string known;
    vtkCellData* cells = mesh->GetCellData();
    for (int i = 0; i < cells->GetNumberOfArrays(); ++i)
    {
      const char* other = cells->GetArrayName(i);
      known += (known.empty() ? "" : ", ") + std::string("\"") + (other ? other : "") + "\"";
    }
    return "Source: the mesh has no cell array \"" + name + "\" of segments; " +
      (known.empty() ? "it has no cell arrays: read a .seg file with vtkMarrowSegmentReader."
                     : "it has " + known + ": choose one with SetInputArrayToProcess.");
  }
  const std::string error = ToLabels(array, mesh->GetNumberOfCells(), "cell", labels);
  return error.empty() ? error : "Source: " + error;
}
}
