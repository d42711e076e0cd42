// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSegmentationFusion.h"

#include "ArrayNames.h"
#include "FilterSupport.h"
#include "FusedSurface.h"
#include "LabelBridge.h"
#include "LabelVotes.h"
#include "MeshBridge.h"
#include "SegmentationTransfer.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkMSPSkeleton.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

vtkStandardNewMacro(vtkSegmentationFusion);

namespace
{
/// Costs run from some 0.05 to 0.5; measured on collections, anything from 5 to 12 does.
constexpr double CostFactor = 8.0;

/// What a labelling says. One sentence on what is wrong with it, or an empty one.
std::string ReadLabelling(
  vtkPolyData* mesh, vtkPolyData* first, const std::string& name, marrow::Labelling& labelling)
{
  if (mesh->GetNumberOfCells() != first->GetNumberOfCells() ||
    mesh->GetNumberOfPoints() != first->GetNumberOfPoints())
  {
    return "it has " + std::to_string(mesh->GetNumberOfPoints()) + " points and " +
      std::to_string(mesh->GetNumberOfCells()) + " cells, the first has " +
      std::to_string(first->GetNumberOfPoints()) + " and " +
      std::to_string(first->GetNumberOfCells()) + ": connect labellings of one mesh.";
  }
  const std::string error =
    marrow::ReadLabels(mesh, mesh->GetCellData()->GetArray(name.c_str()), name, labelling.Labels);
  if (!error.empty())
  {
    return error;
  }
  marrow::GetArray(mesh->GetCellData(), marrow::names::SegmentConfidence,
    static_cast<int>(mesh->GetNumberOfCells()), labelling.Confidence);
  for (double& confidence : labelling.Confidence)
  {
    if (!std::isfinite(confidence))
    {
      return std::string("a value of \"") + marrow::names::SegmentConfidence +
        "\" is not finite: remove the array, or mend it.";
    }
    confidence = std::clamp(confidence, 0.0, 1.0);
  }
  vtkDataArray* cost = mesh->GetFieldData()->GetArray(marrow::names::MatchingCost);
  if (cost && cost->GetNumberOfTuples() > 0 && std::isfinite(cost->GetTuple1(0)))
  {
    labelling.Weight = std::exp(-CostFactor * std::max(cost->GetTuple1(0), 0.0));
  }
  return {};
}

void WriteShares(const marrow::LabelVotes& votes, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> shares;
  shares->SetName(marrow::names::SegmentShares);
  shares->SetNumberOfComponents(static_cast<int>(votes.Labels.size()));
  shares->SetNumberOfTuples(votes.Shares.rows());
  vtkNew<vtkIntArray> ids;
  ids->SetName(marrow::names::SegmentShareId);
  for (std::size_t column = 0; column < votes.Labels.size(); ++column)
  {
    const int component = static_cast<int>(column);
    ids->InsertNextValue(votes.Labels[column]);
    shares->SetComponentName(component, std::to_string(votes.Labels[column]).c_str());
    for (Eigen::Index face = 0; face < votes.Shares.rows(); ++face)
    {
      shares->SetTypedComponent(face, component, votes.Shares(face, component));
    }
  }
  output->GetCellData()->AddArray(shares);
  output->GetFieldData()->AddArray(ids);
}

void WriteWeights(const std::vector<marrow::Labelling>& labellings, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> weights;
  weights->SetName(marrow::names::LabellingWeight);
  double most = 0.0;
  for (const marrow::Labelling& labelling : labellings)
  {
    most = std::max(most, labelling.Weight);
  }
  for (const marrow::Labelling& labelling : labellings)
  {
    weights->InsertNextValue(most > 0.0 ? labelling.Weight / most : 0.0);
  }
  output->GetFieldData()->AddArray(weights);
}
}

vtkSegmentationFusion::vtkSegmentationFusion()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, marrow::names::SegmentId);
}

int vtkSegmentationFusion::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

int vtkSegmentationFusion::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* first = vtkPolyData::GetData(inputVector[0], 0);
  if (marrow::IsIdleProcess(outputVector, first))
  {
    return 1;
  }
  const auto fail = [this](const std::string& error)
  {
    vtkErrorMacro(<< error);
    return 0;
  };
  const std::string name = marrow::NameOfSegments(this);
  std::vector<marrow::Labelling> labellings(inputVector[0]->GetNumberOfInformationObjects());
  for (std::size_t i = 0; i < labellings.size(); ++i)
  {
    vtkPolyData* mesh = vtkPolyData::GetData(inputVector[0], static_cast<int>(i));
    const std::string error = ReadLabelling(mesh, first, name, labellings[i]);
    if (!error.empty())
    {
      return fail("Labelling " + std::to_string(i) + ": " + error);
    }
  }
  vtkNew<vtkMSPSkeleton> defaults;
  marrow::PreparedSurface surface;
  const std::string error = marrow::PrepareSurface(first, defaults->GetMaximumFaces(),
    marrow::BodyMode::Apart, surface, marrow::ProgressOf(this, 0.0, 0.3));
  if (!error.empty())
  {
    return fail(error);
  }
  if (marrow::IsAborted(this))
  {
    return 1;
  }
  // In an order of their own, so that sums are the same however they are connected.
  std::vector<std::size_t> order(labellings.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    {
      const marrow::Labelling& x = labellings[a];
      const marrow::Labelling& y = labellings[b];
      return std::tie(x.Labels, x.Confidence, x.Weight) <
        std::tie(y.Labels, y.Confidence, y.Weight);
    });
  std::vector<marrow::Labelling> sorted;
  for (const std::size_t i : order)
  {
    sorted.push_back(labellings[i]);
  }
  if (this->EstimateTrust)
  {
    marrow::WeighByTrust(marrow::AreaOfCells(surface), sorted);
  }
  const marrow::LabelVotes votes = marrow::CountVotes(sorted);
  if (votes.Labels.size() > static_cast<std::size_t>(marrow::MostPieces))
  {
    return fail("The labellings have " + std::to_string(votes.Labels.size()) +
      " different segments, more than " + std::to_string(marrow::MostPieces) +
      ": give equal segments of different labellings equal numbers.");
  }
  const marrow::CellLabels fused =
    marrow::FuseOnSurface(surface, votes, sorted, marrow::ProgressOf(this, 0.3, 1.0));
  if (marrow::IsAborted(this))
  {
    return 1;
  }
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    labellings[order[i]].Weight = sorted[i].Weight;
  }

  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(first);
  marrow::SetIntArray(output->GetCellData(), marrow::names::SegmentId, fused.Labels);
  output->GetCellData()->SetActiveScalars(marrow::names::SegmentId);
  // Viewers prefer point scalars to cell scalars.
  output->GetPointData()->SetActiveScalars(nullptr);
  marrow::SetArray(output->GetCellData(), marrow::names::SegmentConfidence, fused.Confidence);
  marrow::SetArray(output->GetCellData(), marrow::names::SegmentDisagreement, votes.Disagreement);
  output->GetFieldData()->RemoveArray(marrow::names::MatchingCost);
  WriteShares(votes, output);
  WriteWeights(labellings, output);
  marrow::WriteNote(surface, output);
  return 1;
}

void vtkSegmentationFusion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "EstimateTrust: " << (this->EstimateTrust ? "On" : "Off") << "\n";
}
