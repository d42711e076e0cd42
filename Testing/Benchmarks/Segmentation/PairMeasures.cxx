// SPDX-License-Identifier: BSD-3-Clause
#include "PairMeasures.h"

#include "ArrayNames.h"
#include "CorrespondenceMeasures.h"
#include "FilterRun.h"
#include "MeshBridge.h"
#include "SegmentationScores.h"
#include "vtkSegmentationTransfer.h"
#include "vtkSkeletonCorrespondence.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>

namespace marrow::bench
{
namespace
{
/// Filters on several threads must not share a data object: VTK keeps state in it.
vtkSmartPointer<vtkPolyData> Copy(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

MatchedSide SideOf(const PreparedCategory& category, int mesh, vtkPolyData* matchedSkeleton)
{
  MatchedSide side{ category.Meshes[mesh], category.Features[mesh], {} };
  GetArray(matchedSkeleton->GetPointData(), names::CorrespondenceId,
    side.Mesh.PlainSkeleton.NumberOfNodes(), side.CorrespondenceOfNode);
  return side;
}

SegmentationScores Compare(
  const PreparedMesh& mesh, const std::vector<int>& segments, const std::vector<int>& reference)
{
  std::vector<int> faceOfTriangle(segments.size());
  std::iota(faceOfTriangle.begin(), faceOfTriangle.end(), 0);
  return CompareSegmentations(mesh.Mesh, faceOfTriangle, segments, reference);
}

/// Against every human segmentation, on average.
void CompareWithHumans(const PreparedMesh& mesh, const std::vector<int>& segments, Result& result)
{
  SegmentationScores mean;
  const double weight = 1.0 / mesh.Humans.size();
  for (const std::vector<int>& human : mesh.Humans)
  {
    const SegmentationScores scores = Compare(mesh, segments, human);
    mean.RandError += weight * scores.RandError;
    mean.HammingDistance += weight * scores.HammingDistance;
    mean.MissingRate += weight * scores.MissingRate;
    mean.FalseAlarmRate += weight * scores.FalseAlarmRate;
    mean.GlobalConsistencyError += weight * scores.GlobalConsistencyError;
    mean.LocalConsistencyError += weight * scores.LocalConsistencyError;
    mean.CutDiscrepancy += weight * scores.CutDiscrepancy;
  }
  result.Values["rand_error"] = mean.RandError;
  result.Values["hamming_distance"] = mean.HammingDistance;
  result.Values["missing_rate"] = mean.MissingRate;
  result.Values["false_alarm_rate"] = mean.FalseAlarmRate;
  result.Values["gce"] = mean.GlobalConsistencyError;
  result.Values["lce"] = mean.LocalConsistencyError;
  result.Values["cut_discrepancy"] = mean.CutDiscrepancy;
}

/// The share of the target's area whose label the source has too: no transfer can get more of it right.
double PossibleAccuracy(const PreparedMesh& source, const PreparedMesh& target)
{
  const std::set<int> known(source.Labels.begin(), source.Labels.end());
  std::vector<int> best = target.Labels;
  std::replace_if(
    best.begin(), best.end(), [&](int label) { return known.count(label) == 0; }, -1);
  return LabelAccuracy(target.Areas, best, target.Labels);
}

/// Against the labels and pieces of the target itself.
void CompareWithLabels(const PreparedMesh& source, const PreparedMesh& target,
  const std::vector<int>& segments, Result& result)
{
  std::vector<int> labels(segments.size());
  std::transform(segments.begin(), segments.end(), labels.begin(),
    [&](int piece)
    {
      const auto label = source.LabelOfPiece.find(piece);
      return label == source.LabelOfPiece.end() ? -1 : label->second;
    });
  const SegmentationScores scores = Compare(target, segments, target.Pieces);
  result.Values["label_accuracy"] = LabelAccuracy(target.Areas, labels, target.Labels);
  result.Values["label_accuracy_possible"] = PossibleAccuracy(source, target);
  result.Values["rand_error_to_labels"] = scores.RandError;
  result.Values["boundary_distance_to_labels"] = scores.BoundaryDistance;
  const std::set<int> present(segments.begin(), segments.end());
  result.Values["segments_missing"] = static_cast<double>(std::count_if(source.LabelOfPiece.begin(),
    source.LabelOfPiece.end(), [&](const auto& piece) { return present.count(piece.first) == 0; }));
}

double MeanConfidence(const PreparedMesh& target, const std::vector<double>& confidence)
{
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t face = 0; face < confidence.size(); ++face)
  {
    sum += target.Areas[face] * confidence[face];
    area += target.Areas[face];
  }
  return sum / area;
}

void MeasureTransfer(const PreparedMesh& source, const PreparedMesh& target,
  vtkPolyData* sourceSkeleton, vtkPolyData* targetSkeleton, std::vector<int>& segments,
  Result& result)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  transfer->SetInputData(0, Copy(source.Surface));
  transfer->SetInputData(1, Copy(target.Surface));
  transfer->SetInputData(2, sourceSkeleton);
  transfer->SetInputData(3, targetSkeleton);
  int warnings = 0;
  result.Values["seconds_transfer"] = Run(transfer, &warnings);
  result.Values["warnings"] = warnings;

  vtkCellData* cells = transfer->GetOutput()->GetCellData();
  const int faces = target.Mesh.NumberOfTriangles();
  std::vector<double> confidence;
  if (!GetArray(cells, names::SegmentId, faces, segments) ||
    !GetArray(cells, names::SegmentConfidence, faces, confidence))
  {
    throw std::runtime_error("The transfer's output lacks its arrays.");
  }
  result.Values["segment_confidence"] = MeanConfidence(target, confidence);
  vtkFieldData* whole = transfer->GetOutput()->GetFieldData();
  result.Values["matching_cost"] = whole->GetArray(names::MatchingCost)->GetTuple1(0);
  result.Values["matching_evidence"] = whole->GetArray(names::MatchingEvidence)->GetTuple1(0);
  result.Values["matching_confidence"] = whole->GetArray(names::MatchingConfidence)->GetTuple1(0);
  CompareWithHumans(target, segments, result);
  CompareWithLabels(source, target, segments, result);
}
}

const std::vector<std::string>& PairColumns()
{
  static const std::vector<std::string> columns = { "label_accuracy", "label_accuracy_possible",
    "rand_error", "hamming_distance", "missing_rate", "false_alarm_rate", "gce", "lce",
    "cut_discrepancy", "rand_error_to_labels", "boundary_distance_to_labels", "segments_missing",
    "correspondence_confidence", "segment_confidence", "matching_cost", "matching_evidence",
    "matching_confidence", "warnings", "seconds_correspondence", "seconds_transfer",
    "matched_pairs", "same_label_pairs", "matched_terminals", "same_label_terminals",
    "judged_pairs", "consistent_pairs", "left_right_flips", "front_back_flips", "feature_nodes",
    "matched_feature_nodes" };
  return columns;
}

Result MeasurePair(const PreparedCategory& category, int source, int target, MatcherKind matcher,
  bool transfer, std::vector<int>& segments)
{
  const PreparedMesh& sourceMesh = category.Meshes[source];
  const PreparedMesh& targetMesh = category.Meshes[target];
  Result result;
  result.Source = sourceMesh.Id;
  result.Target = targetMesh.Id;
  result.Error = sourceMesh.Error.empty() ? targetMesh.Error : sourceMesh.Error;
  if (!result.Error.empty())
  {
    return result;
  }
  try
  {
    vtkNew<vtkSkeletonCorrespondence> correspondence;
    correspondence->SetMatcher(matcher == MatcherKind::Electors
        ? vtkSkeletonCorrespondence::ELECTORS_VOTING
        : vtkSkeletonCorrespondence::CORRESPONDENCE_TREE);
    correspondence->SetInputData(0, Copy(sourceMesh.Skeleton));
    correspondence->SetInputData(1, Copy(targetMesh.Skeleton));
    result.Values["seconds_correspondence"] = Run(correspondence);
    auto* sourceSkeleton = vtkPolyData::SafeDownCast(correspondence->GetOutputDataObject(0));
    auto* targetSkeleton = vtkPolyData::SafeDownCast(correspondence->GetOutputDataObject(1));
    MeasureCorrespondence(SideOf(category, source, sourceSkeleton),
      SideOf(category, target, targetSkeleton), category.MirrorFeatures, result);
    if (vtkDataArray* confidence =
          sourceSkeleton->GetFieldData()->GetArray("CorrespondenceConfidence"))
    {
      result.Values["correspondence_confidence"] = confidence->GetTuple1(0);
    }
    if (transfer)
    {
      // By default the transfer matches by itself: the surfaces choose among several answers, which
      // need not be the one measured above.
      const bool matched = matcher == MatcherKind::Electors;
      MeasureTransfer(sourceMesh, targetMesh,
        matched ? sourceSkeleton : Copy(sourceMesh.Skeleton).Get(),
        matched ? targetSkeleton : Copy(targetMesh.Skeleton).Get(), segments, result);
    }
  }
  catch (const std::exception& error)
  {
    result.Error = error.what();
  }
  return result;
}
}
