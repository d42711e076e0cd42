// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_SegmentationScores_h
#define marrow_SegmentationScores_h

#include "TriangleMesh.h"

#include <vector>

namespace marrow
{
/// The measures of vtkMarrowSegmentationMetrics, whose header says what they mean.
struct SegmentationScores
{
  double CutDiscrepancy = 0.0;
  double HammingDistance = 0.0;
  double MissingRate = 0.0;
  double FalseAlarmRate = 0.0;
  double RandError = 0.0;
  double GlobalConsistencyError = 0.0;
  double LocalConsistencyError = 0.0;
  double LabelAccuracy = 0.0;
  double BoundaryDistance = 0.0;
};

/// Compares two segmentations of a mesh of positive area; one id per face each. A polygon is a face of
/// several triangles. O(n log n).
SegmentationScores CompareSegmentations(const TriangleMesh& mesh,
  const std::vector<int>& faceOfTriangle, const std::vector<int>& segments,
  const std::vector<int>& reference);

/// Share of the area of the faces whose ids are equal.
double LabelAccuracy(const std::vector<double>& areas, const std::vector<int>& labels,
  const std::vector<int>& reference);
}

#endif
