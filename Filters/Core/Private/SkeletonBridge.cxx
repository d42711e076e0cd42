// SPDX-License-Identifier: BSD-3-Clause
#include "SkeletonBridge.h"

#include "ArrayNames.h"
#include "MeshBridge.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace marrow
{
namespace
{
void SetFieldValue(vtkPolyData* data, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  data->GetFieldData()->AddArray(array);
}

double GetFieldValue(vtkPolyData* data, const char* name, double otherwise)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetTuple1(0) : otherwise;
}
}

void ToPolyData(const Skeleton& skeleton, vtkPolyData* output)
{
  const int numberOfNodes = skeleton.NumberOfNodes();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(numberOfNodes);
  std::vector<int> type(numberOfNodes);
  std::vector<double> radius(numberOfNodes);
  std::vector<double> agd(numberOfNodes);
  std::vector<double> msp(numberOfNodes);
  std::vector<int> vertexCount(numberOfNodes);
  for (int n = 0; n < numberOfNodes; ++n)
  {
    const SkeletonNode& node = skeleton.Graph[n];
    points->SetPoint(n, node.Position.data());
    type[n] = static_cast<int>(skeleton.TypeOf(n));
    radius[n] = node.Radius;
    agd[n] = node.AGD;
    msp[n] = node.MSP;
    vertexCount[n] = static_cast<int>(node.Vertices.size());
  }

  vtkNew<vtkCellArray> lines;
  std::vector<int> branchId;
  std::vector<double> branchLength;
  for (int b = 0; b < skeleton.NumberOfBranches(); ++b)
  {
    const Branch& branch = skeleton.Branches[b];
    lines->InsertNextCell(static_cast<int>(branch.Nodes.size()));
    for (int node : branch.Nodes)
    {
      lines->InsertCellPoint(node);
    }
    branchId.push_back(b);
    branchLength.push_back(branch.Length());
  }

  output->Initialize();
  output->SetPoints(points);
  output->SetLines(lines);
  SetIntArray(output->GetPointData(), names::NodeType, type);
  SetArray(output->GetPointData(), names::Radius, radius);
  SetArray(output->GetPointData(), names::AGD, agd);
  SetArray(output->GetPointData(), names::MSP, msp);
  SetIdArray(output->GetPointData(), names::VertexCount, vertexCount);
  SetIdArray(output->GetCellData(), names::BranchId, branchId);
  SetArray(output->GetCellData(), names::BranchLength, branchLength);
  SetFieldValue(output, names::MeshDiagonal, skeleton.MeshDiagonal);
  SetFieldValue(output, names::MeshMaximumMSP, skeleton.MeshMaximumMSP);
}

std::string ToSkeleton(vtkPolyData* input, Skeleton& skeleton)
{
  if (!input || input->GetNumberOfPoints() == 0 || input->GetNumberOfLines() == 0)
  {
    return "The skeleton is empty: it has no points or no lines; connect the first output of "
           "vtkMSPSkeleton.";
  }
  const int numberOfNodes = static_cast<int>(input->GetNumberOfPoints());
  std::vector<double> agd;
  std::vector<double> msp;
  std::vector<double> radius;
  vtkPointData* pointData = input->GetPointData();
  for (auto [name, values] :
    { std::pair{ names::AGD, &agd }, { names::MSP, &msp }, { names::Radius, &radius } })
  {
    if (!GetArray(pointData, name, numberOfNodes, *values))
    {
      return std::string("The skeleton has no point array \"") + name +
        "\" with one component: connect the first output of vtkMSPSkeleton.";
    }
    const auto bad = std::find_if_not(
      values->begin(), values->end(), [](double value) { return std::isfinite(value); });
    if (bad != values->end())
    {
      return std::string("The skeleton's point array \"") + name + "\" is not finite at point " +
        std::to_string(bad - values->begin()) + ": compute the skeleton again.";
    }
  }

  skeleton = Skeleton();
  skeleton.Graph = SkeletonGraph(numberOfNodes);
  double maximumMSP = 0.0;
  for (int n = 0; n < numberOfNodes; ++n)
  {
    SkeletonNode& node = skeleton.Graph[n];
    input->GetPoint(n, node.Position.data());
    if (!node.Position.allFinite())
    {
      return "The skeleton's point " + std::to_string(n) +
        " has coordinates that are not finite: compute the skeleton again.";
    }
    node.AGD = agd[n];
    node.MSP = msp[n];
    node.Radius = radius[n];
    maximumMSP = std::max(maximumMSP, msp[n]);
  }
  auto iterator = vtk::TakeSmartPointer(input->GetLines()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    if (size < 2)
    {
      return "The skeleton's line " + std::to_string(iterator->GetCurrentCellId()) +
        " has fewer than two points: connect the first output of vtkMSPSkeleton.";
    }
    Branch branch;
    for (vtkIdType i = 0; i < size; ++i)
    {
      const int node = static_cast<int>(ids[i]);
      if (node < 0 || node >= numberOfNodes)
      {
        return "The skeleton's line " + std::to_string(iterator->GetCurrentCellId()) +
          " names a point that does not exist: compute the skeleton again.";
      }
      double arc = 0.0;
      if (i > 0)
      {
        const int previous = branch.Nodes.back();
        boost::add_edge(previous, node, skeleton.Graph);
        arc = branch.ArcLength.back() +
          (skeleton.Graph[node].Position - skeleton.Graph[previous].Position).norm();
      }
      branch.Nodes.push_back(node);
      branch.ArcLength.push_back(arc);
    }
    skeleton.Branches.push_back(std::move(branch));
  }
  for (int b = 0; b < skeleton.NumberOfBranches(); ++b)
  {
    const Branch& branch = skeleton.Branches[b];
    for (std::size_t i = 1; i + 1 < branch.Nodes.size(); ++i)
    {
      if (boost::out_degree(branch.Nodes[i], skeleton.Graph) != 2)
      {
        return "The skeleton's line " + std::to_string(b) + " runs through the junction at point " +
          std::to_string(branch.Nodes[i]) +
          ": give every branch a line of its own, as vtkMSPSkeleton does.";
      }
    }
  }
  double bounds[6];
  input->GetBounds(bounds);
  const double diagonal =
    Eigen::Vector3d(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]).norm();
  skeleton.MeshDiagonal = GetFieldValue(input, names::MeshDiagonal, diagonal);
  skeleton.MeshMaximumMSP = GetFieldValue(input, names::MeshMaximumMSP, maximumMSP);
  return {};
}

std::vector<int> NodeOfVertices(const Skeleton& skeleton, int numberOfVertices)
{
  std::vector<int> result(numberOfVertices, -1);
  for (int n = 0; n < skeleton.NumberOfNodes(); ++n)
  {
    for (int vertex : skeleton.Graph[n].Vertices)
    {
      result[vertex] = n;
    }
  }
  return result;
}

bool SetNodeOfVertices(Skeleton& skeleton, const std::vector<int>& nodeOfVertex)
{
  const int numberOfNodes = skeleton.NumberOfNodes();
  for (int n = 0; n < numberOfNodes; ++n)
  {
    skeleton.Graph[n].Vertices.clear();
  }
  for (std::size_t v = 0; v < nodeOfVertex.size(); ++v)
  {
    const int node = nodeOfVertex[v];
    if (node < -1 || node >= numberOfNodes)
    {
      return false;
    }
    if (node >= 0)
    {
      skeleton.Graph[node].Vertices.push_back(static_cast<int>(v));
    }
  }
  return true;
}
}
