// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkeletonCorrespondence.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "HintBridge.h"
#include "MeshBridge.h"
#include "SkeletonBridge.h"
#include "SkeletonMatching.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>

namespace
{
template <typename Array, typename Value>
void AddFieldValue(vtkPolyData* data, const char* name, Value value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->InsertNextValue(value);
  data->GetFieldData()->AddArray(array);
}

/// The lines of a vtkPolyData come after its vertices among its cells, and the branches are the
/// lines.
template <typename Value>
std::vector<Value> OverCells(vtkPolyData* data, const std::vector<Value>& branches, Value otherwise)
{
  std::vector<Value> cells(data->GetNumberOfCells(), otherwise);
  std::copy(branches.begin(), branches.end(), cells.begin() + data->GetNumberOfVerts());
  return cells;
}

void Write(vtkPolyData* output, const marrow::SkeletonMatch::Side& side, double confidence,
  const marrow::TreeStatistics& tree)
{
  using namespace marrow;
  SetIdArray(output->GetPointData(), names::CorrespondenceId, side.NodeId);
  vtkCellData* cells = output->GetCellData();
  SetIdArray(cells, names::BranchCorrespondenceId, OverCells(output, side.BranchId, -1));
  cells->SetActiveScalars(names::BranchCorrespondenceId);
  SetIdArray(cells, names::BranchCorrespondenceOrder, OverCells(output, side.BranchOrder, -1));
  const unsigned char along = 0;
  SetArray(
    cells, names::BranchCorrespondenceReversed, OverCells(output, side.BranchReversed, along));

  AddFieldValue<vtkIdTypeArray>(output, "CorrespondenceTreeNodes", tree.TreeNodes);
  AddFieldValue<vtkIdTypeArray>(output, "CorrespondenceTreeHeight", tree.Height);
  AddFieldValue<vtkIdTypeArray>(output, "CorrespondenceCorePairs", tree.CorePairs);
  AddFieldValue<vtkIdTypeArray>(output, "CorrespondenceMerges", tree.Merges);
  AddFieldValue<vtkIdTypeArray>(output, "CorrespondenceClusters", tree.Clusters);
  AddFieldValue<vtkIdTypeArray>(output, "CorrespondenceLeaves", tree.Leaves);
  AddFieldValue<vtkDoubleArray>(output, names::CorrespondenceConfidence, confidence);
}

/// The node whose part of the mesh is nearest to a point on the surface, or near the skeleton.
int NearestNode(const marrow::Skeleton& skeleton, const Eigen::Vector3d& point)
{
  int nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int n = 0; n < skeleton.NumberOfNodes(); ++n)
  {
    const marrow::SkeletonNode& node = skeleton.Graph[n];
    const double distance = (node.Position - point).norm() - node.Radius;
    if (distance < least)
    {
      least = distance;
      nearest = n;
    }
  }
  return nearest;
}

void WriteTable(const std::vector<marrow::SkeletonMatch>& leaves, vtkTable* table)
{
  using Leaf = marrow::SkeletonMatch;
  table->Initialize();
  for (auto [name, member] : { std::pair{ "GlobalCost", &Leaf::GlobalCost },
         std::pair{ "PaperCost", &Leaf::PaperCost }, std::pair{ "Confidence", &Leaf::Confidence },
         std::pair{ "SourceCoverage", &Leaf::SourceCoverage },
         std::pair{ "TargetCoverage", &Leaf::TargetCoverage } })
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (const Leaf& leaf : leaves)
    {
      column->InsertNextValue(leaf.*member);
    }
    table->AddColumn(column);
  }
  vtkNew<vtkUnsignedCharArray> refined;
  refined->SetName("Refined");
  for (const Leaf& leaf : leaves)
  {
    refined->InsertNextValue(leaf.Refined ? 1 : 0);
  }
  table->AddColumn(refined);
  for (auto [name, member] : { std::pair{ "JunctionPairs", &Leaf::JunctionPairs },
         std::pair{ "TerminalPairs", &Leaf::TerminalPairs },
         std::pair{ "BranchPairs", &Leaf::BranchPairs }, std::pair{ "Merges", &Leaf::Merges } })
  {
    vtkNew<vtkIdTypeArray> column;
    column->SetName(name);
    for (const Leaf& leaf : leaves)
    {
      column->InsertNextValue(leaf.*member);
    }
    table->AddColumn(column);
  }
}
}

vtkStandardNewMacro(vtkSkeletonCorrespondence);

vtkSkeletonCorrespondence::vtkSkeletonCorrespondence()
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(3);
}

int vtkSkeletonCorrespondence::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port < 2 ? "vtkPolyData" : "vtkPointSet");
  if (port >= 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkSkeletonCorrespondence::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 2 ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkSkeletonCorrespondence::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  for (int port = 0; port < 3; ++port)
  {
    vtkInformation* info = outputVector->GetInformationObject(port);
    vtkDataObject* output = info->Get(vtkDataObject::DATA_OBJECT());
    const char* type = port == 2 ? "vtkTable" : "vtkPolyData";
    if (!output || !output->IsA(type))
    {
      vtkSmartPointer<vtkDataObject> made;
      if (port == 2)
      {
        made = vtkSmartPointer<vtkTable>::New();
      }
      else
      {
        made = vtkSmartPointer<vtkPolyData>::New();
      }
      info->Set(vtkDataObject::DATA_OBJECT(), made);
    }
  }
  return 1;
}

int vtkSkeletonCorrespondence::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* inputs[2] = { vtkPolyData::GetData(inputVector[0]),
    vtkPolyData::GetData(inputVector[1]) };
  if (marrow::IsIdleProcess(outputVector, inputs[0]))
  {
    return 1;
  }
  marrow::Skeleton skeletons[2];
  for (int side = 0; side < 2; ++side)
  {
    const std::string error = marrow::ToSkeleton(inputs[side], skeletons[side]);
    if (!error.empty())
    {
      vtkErrorMacro(<< (side == 0 ? "Source: " : "Target: ") << error);
      return 0;
    }
  }

  std::vector<marrow::PointHint> hints;
  const std::string error = marrow::ReadHints(
    vtkPointSet::GetData(inputVector[2]), vtkPointSet::GetData(inputVector[3]), hints);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 0;
  }

  marrow::MatchingParameters parameters;
  for (const marrow::PointHint& hint : hints)
  {
    parameters.Hints.push_back({ NearestNode(skeletons[0], hint.Source),
      NearestNode(skeletons[1], hint.Target), hint.IsForbidden });
  }
  parameters.Method = this->Matcher == ELECTORS_VOTING ? marrow::Matcher::ElectorsVoting
                                                       : marrow::Matcher::CorrespondenceTree;
  parameters.Voting.CentricityTolerance = this->CentricityTolerance;
  parameters.Voting.PathTolerance = this->PathTolerance;
  parameters.Voting.SpatialTolerance = this->SpatialTolerance;
  parameters.Tree.JunctionThreshold = this->JunctionThreshold;
  parameters.Tree.MergeDistance = this->MergeDistance;
  parameters.Tree.ClusterDistance = this->ClusterDistance;
  parameters.DescriptorPieces = this->DescriptorPieces;
  parameters.GlobalSelection = this->GlobalSelection;
  marrow::SkeletonMatching matching;
  if (!marrow::MatchSkeletons(
        skeletons[0], skeletons[1], parameters, matching, marrow::ProgressOf(this)))
  {
    return 1;
  }
  if (this->LeafIndex >= static_cast<int>(matching.Leaves.size()))
  {
    vtkErrorMacro("LeafIndex is " << this->LeafIndex << " but there are only "
                                  << matching.Leaves.size()
                                  << " leaves: set it to less than that.");
    return 0;
  }

  const marrow::SkeletonMatch& leaf = matching.Leaves[this->LeafIndex];
  for (int side = 0; side < 2; ++side)
  {
    vtkPolyData* output = vtkPolyData::GetData(outputVector, side);
    output->ShallowCopy(inputs[side]);
    Write(output, side == 0 ? leaf.Source : leaf.Target, leaf.Confidence, matching.Statistics);
  }
  WriteTable(matching.Leaves, vtkTable::GetData(outputVector, 2));
  return 1;
}

void vtkSkeletonCorrespondence::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "Matcher: " << (this->Matcher == ELECTORS_VOTING ? "ElectorsVoting" : "CorrespondenceTree")
     << endl;
  os << indent << "LeafIndex: " << this->LeafIndex << endl;
  os << indent << "GlobalSelection: " << this->GlobalSelection << endl;
  os << indent << "JunctionThreshold: " << this->JunctionThreshold << endl;
  os << indent << "MergeDistance: " << this->MergeDistance << endl;
  os << indent << "ClusterDistance: " << this->ClusterDistance << endl;
  os << indent << "DescriptorPieces: " << this->DescriptorPieces << endl;
  os << indent << "CentricityTolerance: " << this->CentricityTolerance << endl;
  os << indent << "PathTolerance: " << this->PathTolerance << endl;
  os << indent << "SpatialTolerance: " << this->SpatialTolerance << endl;
}
