// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayNames.h"
#include "Constants.h"
#include "ErrorObserver.h"
#include "MeshBridge.h"
#include "SegmentCut.h"
#include "TestMeshes.h"
#include "TestShapes.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkMarrowSegmentCutter.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

using namespace marrow;
using namespace marrow::test;

namespace
{
constexpr double Radius = 0.5;
/// Edges of the cylinder below.
constexpr double Edge = 0.066;

PolygonMesh ToPolygons(const TriangleMesh& triangles)
{
  PolygonMesh mesh;
  mesh.Points = triangles.Points;
  for (const auto& triangle : triangles.Triangles)
  {
    mesh.Corners.insert(mesh.Corners.end(), triangle.begin(), triangle.end());
    mesh.Offsets.push_back(static_cast<int>(mesh.Corners.size()));
  }
  return mesh;
}

PolygonMesh Cylinder()
{
  return ToPolygons(MakeCylinder(Radius, 3.0, 48, 52));
}

Eigen::Vector3d Centroid(const PolygonMesh& mesh, int polygon)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < mesh.SizeOf(polygon); ++k)
  {
    sum += mesh.Points[mesh.CornersOf(polygon)[k]];
  }
  return sum / mesh.SizeOf(polygon);
}

/// The number of whole segments below a polygon's centre, by heights that depend on the angle.
std::vector<int> LabelsBy(
  const PolygonMesh& mesh, const std::vector<std::function<double(double)>>& heights)
{
  std::vector<int> labels;
  for (int p = 0; p < mesh.NumberOfPolygons(); ++p)
  {
    const Eigen::Vector3d center = Centroid(mesh, p);
    int label = 0;
    for (const auto& height : heights)
    {
      label += center.z() > height(std::atan2(center.y(), center.x())) ? 1 : 0;
    }
    labels.push_back(label);
  }
  return labels;
}

Eigen::Vector3d PositionOf(const PolygonMesh& mesh, const SegmentCut& cut, int point)
{
  if (point < mesh.NumberOfPoints())
  {
    return mesh.Points[point];
  }
  const SegmentCut::NewPoint& made = cut.NewPoints[point - mesh.NumberOfPoints()];
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  for (int k = 0; k < made.Size; ++k)
  {
    position += made.Weights[k] * mesh.Points[made.Points[k]];
  }
  return position;
}

double AreaOf(const PolygonMesh& mesh, const SegmentCut& cut)
{
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < cut.Offsets.size(); ++i)
  {
    const auto at = [&](int k) { return PositionOf(mesh, cut, cut.Corners[cut.Offsets[i] + k]); };
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = 1; k + 1 < cut.Offsets[i + 1] - cut.Offsets[i]; ++k)
    {
      sum += (at(k) - at(0)).cross(at(k + 1) - at(0));
    }
    area += 0.5 * sum.norm();
  }
  return area;
}

/// How far the boundary between the segments 0 and 1 runs from `height`, at its worst point and in the mean,
/// and its length over that of the wanted line.
struct BoundaryError
{
  double Largest = 0.0;
  double Mean = 0.0;
  double Length = 0.0;
};

BoundaryError ErrorOf(const std::vector<int>& offsets, const std::vector<int>& corners,
  const std::vector<int>& labels, const std::function<Eigen::Vector3d(int)>& position,
  const std::function<double(double)>& height)
{
  std::map<std::pair<int, int>, std::set<int>> labelsOfEdges;
  for (std::size_t i = 0; i + 1 < offsets.size(); ++i)
  {
    const int size = offsets[i + 1] - offsets[i];
    for (int k = 0; k < size; ++k)
    {
      const int a = corners[offsets[i] + k];
      const int b = corners[offsets[i] + (k + 1) % size];
      labelsOfEdges[{ std::min(a, b), std::max(a, b) }].insert(labels[i]);
    }
  }
  BoundaryError error;
  double count = 0.0;
  for (const auto& [edge, around] : labelsOfEdges)
  {
    if (around.size() > 1)
    {
      const Eigen::Vector3d a = position(edge.first);
      const Eigen::Vector3d b = position(edge.second);
      const double off = std::abs(a.z() - height(std::atan2(a.y(), a.x())));
      error.Largest = std::max(error.Largest, off);
      error.Mean += off;
      error.Length += (a - b).norm();
      count += 1.0;
    }
  }
  error.Mean /= count;
  double length = 0.0;
  const int steps = 1000;
  for (int i = 0; i < steps; ++i)
  {
    const double from = 2.0 * Pi * i / steps - Pi;
    const double to = 2.0 * Pi * (i + 1) / steps - Pi;
    length += std::hypot(Radius * (to - from), height(to) - height(from));
  }
  error.Length /= length;
  return error;
}
}

TEST(SegmentCut, StraightTiltedAndWavyBoundariesComeOutAsTheyAre)
{
  const PolygonMesh mesh = Cylinder();
  const std::pair<const char*, std::function<double(double)>> shapes[] = {
    { "straight", [](double) { return 0.021; } },
    { "tilted", [](double angle) { return 0.4 * std::cos(angle); } },
    { "wavy", [](double angle) { return 0.15 * std::sin(3.0 * angle); } },
  };
  for (const auto& [name, height] : shapes)
  {
    const std::vector<int> labels = LabelsBy(mesh, { height });
    const SegmentCut cut = CutAlongSegments(mesh, labels);
    const BoundaryError smooth = ErrorOf(
      cut.Offsets, cut.Corners, cut.LabelOfPiece,
      [&](int point) { return PositionOf(mesh, cut, point); }, height);
    const BoundaryError steps = ErrorOf(
      mesh.Offsets, mesh.Corners, labels, [&](int point) { return mesh.Points[point]; }, height);
    EXPECT_LT(smooth.Largest, Edge) << name;
    EXPECT_LT(smooth.Mean, 0.4 * Edge) << name;
    // Steps make a boundary longer than it is; a smooth line is as long as the wanted one.
    EXPECT_NEAR(smooth.Length, 1.0, 0.05) << name;
    EXPECT_GT(steps.Length, 1.1) << name;
  }
}

TEST(SegmentCut, NothingIsLostAndWhatIsInsideStays)
{
  const PolygonMesh mesh = Cylinder();
  const auto tilted = [](double angle) { return 0.4 * std::cos(angle); };
  const std::vector<int> labels = LabelsBy(mesh, { tilted, [](double) { return 0.9; } });
  const SegmentCut cut = CutAlongSegments(mesh, labels);
  double area = 0.0;
  for (int p = 0; p < mesh.NumberOfPolygons(); ++p)
  {
    const auto at = [&](int k) { return mesh.Points[mesh.CornersOf(p)[k]]; };
    area += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
  }
  EXPECT_NEAR(AreaOf(mesh, cut), area, 1e-9 * area);

  // In the order of the polygons; those far from boundaries bit for bit.
  std::map<int, int> pieces;
  for (std::size_t i = 0; i < cut.PolygonOfPiece.size(); ++i)
  {
    ++pieces[cut.PolygonOfPiece[i]];
    ASSERT_TRUE(i == 0 || cut.PolygonOfPiece[i - 1] <= cut.PolygonOfPiece[i]);
  }
  ASSERT_EQ(static_cast<int>(pieces.size()), mesh.NumberOfPolygons());
  for (std::size_t i = 0; i < cut.PolygonOfPiece.size(); ++i)
  {
    const int p = cut.PolygonOfPiece[i];
    const double z = Centroid(mesh, p).z();
    if (std::abs(z) > 0.6 && std::abs(z - 0.9) > 0.2)
    {
      ASSERT_EQ(pieces[p], 1);
      ASSERT_EQ(cut.LabelOfPiece[i], labels[p]);
      ASSERT_EQ(std::vector<int>(
                  cut.Corners.begin() + cut.Offsets[i], cut.Corners.begin() + cut.Offsets[i + 1]),
        std::vector<int>(mesh.CornersOf(p), mesh.CornersOf(p) + 3));
    }
  }
}

TEST(SegmentCut, TheSurfaceStaysClosedWhereThreeSegmentsMeet)
{
  const PolygonMesh mesh = Cylinder();
  std::vector<int> labels = LabelsBy(mesh, { [](double) { return 0.0; } });
  for (int p = 0; p < mesh.NumberOfPolygons(); ++p)
  {
    labels[p] = labels[p] == 1 && Centroid(mesh, p).x() > 0.0 ? 7 : labels[p];
  }
  const SegmentCut cut = CutAlongSegments(mesh, labels);
  std::map<std::pair<int, int>, int> uses;
  for (std::size_t i = 0; i + 1 < cut.Offsets.size(); ++i)
  {
    const int size = cut.Offsets[i + 1] - cut.Offsets[i];
    for (int k = 0; k < size; ++k)
    {
      ++uses[{ cut.Corners[cut.Offsets[i] + k], cut.Corners[cut.Offsets[i] + (k + 1) % size] }];
    }
  }
  for (const auto& [edge, count] : uses)
  {
    ASSERT_EQ(count, 1);
    ASSERT_EQ((uses.count({ edge.second, edge.first })), 1u) << edge.first << " " << edge.second;
  }
  EXPECT_EQ(
    std::set<int>(cut.LabelOfPiece.begin(), cut.LabelOfPiece.end()), (std::set<int>{ 0, 1, 7 }));
}

TEST(SegmentCut, SeamsDoNotMatterAndATinySegmentStays)
{
  // A soup: every triangle has points of its own, as in an STL file.
  const PolygonMesh mesh = Cylinder();
  PolygonMesh soup;
  for (const int corner : mesh.Corners)
  {
    soup.Corners.push_back(soup.NumberOfPoints());
    soup.Points.push_back(mesh.Points[corner]);
  }
  soup.Offsets = mesh.Offsets;
  std::vector<int> labels = LabelsBy(mesh, { [](double angle) { return 0.4 * std::cos(angle); } });
  labels.back() = 99;
  const SegmentCut cut = CutAlongSegments(mesh, labels);
  const SegmentCut ofSoup = CutAlongSegments(soup, labels);
  EXPECT_EQ(ofSoup.LabelOfPiece, cut.LabelOfPiece);
  EXPECT_EQ(ofSoup.PolygonOfPiece, cut.PolygonOfPiece);
  EXPECT_EQ(std::count(cut.LabelOfPiece.begin(), cut.LabelOfPiece.end(), 99), 1);
}

TEST(SegmentCut, FilterKeepsArraysAndNamesWhatIsMissing)
{
  const auto mesh = MakeCreature(vtkCreatureSource::BIPED, {}).Mesh;
  std::vector<double> heights;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    heights.push_back(mesh->GetPoint(i)[1]);
  }
  SetArray(mesh->GetPointData(), "Height", heights);
  std::vector<double> numbers;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    numbers.push_back(static_cast<double>(i));
  }
  SetArray(mesh->GetCellData(), "Number", numbers);
  vtkNew<vtkMarrowSegmentCutter> cutter;
  cutter->SetInputData(mesh);
  cutter->Update();
  vtkPolyData* cut = cutter->GetOutput();
  ASSERT_GT(cut->GetNumberOfPoints(), mesh->GetNumberOfPoints());
  ASSERT_GT(cut->GetNumberOfCells(), mesh->GetNumberOfCells());
  for (vtkIdType i = 0; i < cut->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(cut->GetPointData()->GetArray("Height")->GetTuple1(i), cut->GetPoint(i)[1], 1e-6);
  }
  for (vtkIdType i = 0; i < cut->GetNumberOfCells(); ++i)
  {
    ASSERT_EQ(cut->GetCellData()->GetArray("Number")->GetTuple1(i),
      cut->GetCellData()->GetArray(names::OriginalCellIds)->GetTuple1(i));
  }
  EXPECT_STREQ(cut->GetCellData()->GetScalars()->GetName(), names::SegmentId);

  mesh->GetCellData()->RemoveArray(names::SegmentId);
  mesh->Modified();
  ErrorObserver errors(cutter);
  cutter->Update();
  EXPECT_TRUE(errors.HasError("no cell array \"SegmentId\"")) << errors.Text();
  EXPECT_TRUE(errors.HasError("it has \"Number\"")) << errors.Text();
}
