// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentationScores.h"

#include "OverlapTable.h"
#include "SegmentBoundary.h"

namespace marrow
{
namespace
{
/// Mean over the area of the distance to the surface's centroid: the benchmark's unit of length.
double AverageRadius(const TriangleMesh& mesh, const std::vector<double>& areas)
{
  double area = 0.0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    area += areas[t];
    centroid += areas[t] * mesh.Centroid(t);
  }
  centroid /= area;
  double sum = 0.0;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    sum += areas[t] * (mesh.Centroid(t) - centroid).norm();
  }
  return sum / area;
}

std::vector<int> OfTriangles(
  const std::vector<int>& faceOfTriangle, const std::vector<int>& ofFaces)
{
  std::vector<int> ofTriangles;
  ofTriangles.reserve(faceOfTriangle.size());
  for (int face : faceOfTriangle)
  {
    ofTriangles.push_back(ofFaces[face]);
  }
  return ofTriangles;
}
}

SegmentationScores CompareSegmentations(const TriangleMesh& mesh,
  const std::vector<int>& faceOfTriangle, const std::vector<int>& segments,
  const std::vector<int>& reference)
{
  const std::vector<double> areasOfTriangles = mesh.TriangleAreas();
  std::vector<double> areas(segments.size(), 0.0);
  for (std::size_t t = 0; t < areasOfTriangles.size(); ++t)
  {
    areas[faceOfTriangle[t]] += areasOfTriangles[t];
  }
  const OverlapTable overlaps(segments, reference, areas);
  const BoundaryDistances distances = MeasureBoundaryDistances(
    mesh, OfTriangles(faceOfTriangle, segments), OfTriangles(faceOfTriangle, reference));

  SegmentationScores scores;
  scores.CutDiscrepancy = distances.VertexMean / AverageRadius(mesh, areasOfTriangles);
  scores.MissingRate = overlaps.MissingRate();
  scores.FalseAlarmRate = overlaps.FalseAlarmRate();
  scores.HammingDistance = 0.5 * (scores.MissingRate + scores.FalseAlarmRate);
  scores.RandError = overlaps.RandError();
  scores.GlobalConsistencyError = overlaps.GlobalConsistencyError();
  scores.LocalConsistencyError = overlaps.LocalConsistencyError();
  scores.LabelAccuracy = LabelAccuracy(areas, segments, reference);
  scores.BoundaryDistance = distances.LengthMean / mesh.BoundingBoxDiagonal();
  return scores;
}

double LabelAccuracy(const std::vector<double>& areas, const std::vector<int>& labels,
  const std::vector<int>& reference)
{
  double total = 0.0;
  double equal = 0.0;
  for (std::size_t t = 0; t < areas.size(); ++t)
  {
    total += areas[t];
    equal += labels[t] == reference[t] ? areas[t] : 0.0;
  }
  return equal / total;
}
}
