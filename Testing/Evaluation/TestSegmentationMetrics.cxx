// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayNames.h"
#include "ErrorObserver.h"
#include "MeshBridge.h"
#include "TestShapes.h"
#include "vtkMarrowSegmentationMetrics.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace marrow;
using namespace marrow::test;

namespace
{
/// Faces 0 to 3 touch the upper apex, 4 to 7 the lower one; faces 0, 3, 4, 7 have x > 0.
TriangleMesh MakeOctahedron(double upperApex = 1.0)
{
  TriangleMesh mesh;
  mesh.Points = { { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, upperApex },
    { 0, 0, -1 } };
  for (int i = 0; i < 4; ++i)
  {
    mesh.Triangles.push_back({ i, (i + 1) % 4, 4 });
  }
  for (int i = 0; i < 4; ++i)
  {
    mesh.Triangles.push_back({ (i + 1) % 4, i, 5 });
  }
  mesh.BuildConnectivity();
  return mesh;
}

vtkSmartPointer<vtkPolyData> Segmented(
  const TriangleMesh& mesh, const std::vector<int>& segments, const char* name = "SegmentId")
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Eigen::Vector3d& p : mesh.Points)
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : mesh.Triangles)
  {
    triangles->InsertNextCell({ t[0], t[1], t[2] });
  }
  data->SetPoints(points);
  data->SetPolys(triangles);
  SetIntArray(data->GetCellData(), name, segments);
  return data;
}

vtkSmartPointer<vtkMarrowSegmentationMetrics> Compare(
  const TriangleMesh& mesh, const std::vector<int>& segments, const std::vector<int>& reference)
{
  auto metrics = vtkSmartPointer<vtkMarrowSegmentationMetrics>::New();
  metrics->SetInputData(0, Segmented(mesh, segments));
  metrics->SetInputData(1, Segmented(mesh, reference));
  metrics->Update();
  return metrics;
}

const std::vector<int> UpperLower = { 1, 1, 1, 1, 2, 2, 2, 2 };
const std::vector<int> RightLeft = { 1, 2, 2, 1, 1, 2, 2, 1 };
const std::vector<int> Whole(8, 1);

TEST(SegmentationMetrics, EqualSegmentationsHaveNoError)
{
  const auto metrics = Compare(MakeOctahedron(), RightLeft, RightLeft);
  EXPECT_DOUBLE_EQ(metrics->GetCutDiscrepancy(), 0.0);
  EXPECT_DOUBLE_EQ(metrics->GetHammingDistance(), 0.0);
  EXPECT_DOUBLE_EQ(metrics->GetRandError(), 0.0);
  EXPECT_DOUBLE_EQ(metrics->GetGlobalConsistencyError(), 0.0);
  EXPECT_DOUBLE_EQ(metrics->GetLocalConsistencyError(), 0.0);
  EXPECT_DOUBLE_EQ(metrics->GetBoundaryDistance(), 0.0);
  EXPECT_DOUBLE_EQ(metrics->GetLabelAccuracy(), 1.0);
}

TEST(SegmentationMetrics, HalvesAcrossEachOther)
{
  const auto metrics = Compare(MakeOctahedron(), UpperLower, RightLeft);
  // Half of each boundary's vertices lie on the other one, half an edge of √2 away; the mean distance
  // of the surface from its centroid counts each face by its own centroid, 1/√3 away.
  EXPECT_NEAR(metrics->GetCutDiscrepancy(), 0.5 * std::sqrt(2.0) * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(metrics->GetBoundaryDistance(), 0.5 * std::sqrt(2.0) / std::sqrt(12.0), 1e-12);
  EXPECT_NEAR(metrics->GetHammingDistance(), 0.5, 1e-12);
  // Of 28 pairs 12 are together in each and 4 in both.
  EXPECT_NEAR(metrics->GetRandError(), (12.0 + 12.0 - 2.0 * 4.0) / 28.0, 1e-12);
  EXPECT_NEAR(metrics->GetGlobalConsistencyError(), 0.5, 1e-12);
  EXPECT_NEAR(metrics->GetLocalConsistencyError(), 0.5, 1e-12);
  EXPECT_NEAR(metrics->GetLabelAccuracy(), 0.5, 1e-12);
}

TEST(SegmentationMetrics, MissingAndFalseAlarmAreNotSymmetric)
{
  const TriangleMesh mesh = MakeOctahedron();
  const auto coarse = Compare(mesh, Whole, UpperLower);
  EXPECT_NEAR(coarse->GetMissingRate(), 0.0, 1e-12);
  EXPECT_NEAR(coarse->GetFalseAlarmRate(), 0.5, 1e-12);
  const auto fine = Compare(mesh, UpperLower, Whole);
  EXPECT_NEAR(fine->GetMissingRate(), 0.5, 1e-12);
  EXPECT_NEAR(fine->GetFalseAlarmRate(), 0.0, 1e-12);
  EXPECT_NEAR(fine->GetHammingDistance(), 0.25, 1e-12);
}

TEST(SegmentationMetrics, RefinementIsConsistent)
{
  const auto refined = Compare(MakeOctahedron(), { 1, 2, 3, 4, 5, 5, 5, 5 }, UpperLower);
  EXPECT_NEAR(refined->GetGlobalConsistencyError(), 0.0, 1e-12);
  EXPECT_NEAR(refined->GetLocalConsistencyError(), 0.0, 1e-12);
  EXPECT_GT(refined->GetRandError(), 0.2);
}

TEST(SegmentationMetrics, LocalConsistencyForgivesRefinementInBothDirections)
{
  // The upper half is finer in the one, the lower half in the other.
  const auto metrics =
    Compare(MakeOctahedron(), { 1, 2, 2, 1, 3, 3, 3, 3 }, { 1, 1, 1, 1, 2, 3, 3, 2 });
  EXPECT_NEAR(metrics->GetLocalConsistencyError(), 0.0, 1e-12);
  EXPECT_NEAR(metrics->GetGlobalConsistencyError(), 0.25, 1e-12);
}

TEST(SegmentationMetrics, HammingWeighsByAreaAndRandCountsFaces)
{
  const auto regular = Compare(MakeOctahedron(1.0), Whole, UpperLower);
  const auto tall = Compare(MakeOctahedron(3.0), Whole, UpperLower);
  EXPECT_DOUBLE_EQ(regular->GetRandError(), tall->GetRandError());
  // A face's area is half of √(1 + 2 h²).
  const double upper = std::sqrt(19.0);
  const double lower = std::sqrt(3.0);
  EXPECT_NEAR(tall->GetFalseAlarmRate(), lower / (upper + lower), 1e-12);
  EXPECT_NEAR(tall->GetLabelAccuracy(), upper / (upper + lower), 1e-12);
}

TEST(SegmentationMetrics, NumberingMattersToLabelAccuracyOnly)
{
  const TriangleMesh mesh = MakeOctahedron();
  std::vector<int> renumbered;
  for (const int id : UpperLower)
  {
    renumbered.push_back(-1000000 * id);
  }
  const auto metrics = Compare(mesh, renumbered, UpperLower);
  EXPECT_DOUBLE_EQ(metrics->GetRandError(), 0.0);
  EXPECT_DOUBLE_EQ(metrics->GetHammingDistance(), 0.0);
  EXPECT_DOUBLE_EQ(metrics->GetCutDiscrepancy(), 0.0);
  EXPECT_DOUBLE_EQ(metrics->GetLabelAccuracy(), 0.0);
}

TEST(SegmentationMetrics, UnitsAndOrderDoNotMatter)
{
  const TriangleMesh mesh = MakeCylinder(1.0, 6.0, 24, 36);
  const auto cutAt = [](const TriangleMesh& m, double z)
  {
    std::vector<int> segments;
    for (int t = 0; t < m.NumberOfTriangles(); ++t)
    {
      segments.push_back(m.Centroid(t).z() > z ? 1 : 0);
    }
    return segments;
  };
  const auto metrics = Compare(mesh, cutAt(mesh, 0.0), cutAt(mesh, 1.0));
  // Straight up the side it is 1.0; boundaries and paths along edges zigzag.
  const double diagonal = std::sqrt(4.0 + 4.0 + 36.0);
  EXPECT_GT(metrics->GetBoundaryDistance() * diagonal, 1.0 - 1e-9);
  EXPECT_LT(metrics->GetBoundaryDistance() * diagonal, 1.35);

  const TriangleMesh large = Scaled(mesh, 1000.0);
  const auto scaled = Compare(large, cutAt(large, 0.0), cutAt(large, 1000.0));
  EXPECT_NEAR(scaled->GetCutDiscrepancy(), metrics->GetCutDiscrepancy(), 1e-9);
  EXPECT_NEAR(scaled->GetBoundaryDistance(), metrics->GetBoundaryDistance(), 1e-9);

  const TriangleMesh other = Permuted(mesh, 7).Mesh;
  const auto permuted = Compare(other, cutAt(other, 0.0), cutAt(other, 1.0));
  EXPECT_NEAR(permuted->GetCutDiscrepancy(), metrics->GetCutDiscrepancy(), 1e-9);
  EXPECT_NEAR(permuted->GetHammingDistance(), metrics->GetHammingDistance(), 1e-9);
  EXPECT_DOUBLE_EQ(permuted->GetRandError(), metrics->GetRandError());
}

TEST(SegmentationMetrics, BoundaryAgainstNoneIsUndefined)
{
  const TriangleMesh mesh = MakeOctahedron();
  EXPECT_TRUE(std::isnan(Compare(mesh, Whole, UpperLower)->GetCutDiscrepancy()));
  EXPECT_TRUE(std::isnan(Compare(mesh, UpperLower, Whole)->GetBoundaryDistance()));
  EXPECT_DOUBLE_EQ(Compare(mesh, Whole, Whole)->GetCutDiscrepancy(), 0.0);
}

TEST(SegmentationMetrics, BoundaryOnAComponentOfItsOwnDoesNotCount)
{
  // Two octahedra, far apart; only the reference cuts the second one.
  TriangleMesh mesh = MakeOctahedron();
  const TriangleMesh second = Translated(MakeOctahedron(), { 10.0, 0.0, 0.0 });
  mesh.Points.insert(mesh.Points.end(), second.Points.begin(), second.Points.end());
  for (const auto& t : second.Triangles)
  {
    mesh.Triangles.push_back({ t[0] + 6, t[1] + 6, t[2] + 6 });
  }
  std::vector<int> segments = UpperLower;
  segments.insert(segments.end(), 8, 3);
  std::vector<int> reference = UpperLower;
  reference.insert(reference.end(), RightLeft.begin(), RightLeft.end());
  const auto metrics = Compare(mesh, segments, reference);
  EXPECT_DOUBLE_EQ(metrics->GetCutDiscrepancy(), 0.0);
  EXPECT_DOUBLE_EQ(metrics->GetBoundaryDistance(), 0.0);
}

TEST(SegmentationMetrics, OneSegmentAFaceIsNoTrouble)
{
  const TriangleMesh mesh = MakeSphere(1.0, 6); // 32,768 faces: a full table would not fit
  std::vector<int> segments(mesh.NumberOfTriangles());
  std::iota(segments.begin(), segments.end(), 0);
  const auto metrics = Compare(mesh, segments, segments);
  EXPECT_DOUBLE_EQ(metrics->GetRandError(), 0.0);
  EXPECT_NEAR(metrics->GetHammingDistance(), 0.0, 1e-9);
}

TEST(SegmentationMetrics, TableHoldsWhatTheGettersGive)
{
  const auto metrics = Compare(MakeOctahedron(), UpperLower, RightLeft);
  vtkTable* table = metrics->GetOutput();
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  const auto value = [table](const char* name)
  { return table->GetValueByName(0, name).ToDouble(); };
  EXPECT_EQ(value("CutDiscrepancy"), metrics->GetCutDiscrepancy());
  EXPECT_EQ(value("HammingDistance"), metrics->GetHammingDistance());
  EXPECT_EQ(value("MissingRate"), metrics->GetMissingRate());
  EXPECT_EQ(value("FalseAlarmRate"), metrics->GetFalseAlarmRate());
  EXPECT_EQ(value("RandError"), metrics->GetRandError());
  EXPECT_EQ(value("GlobalConsistencyError"), metrics->GetGlobalConsistencyError());
  EXPECT_EQ(value("LocalConsistencyError"), metrics->GetLocalConsistencyError());
  EXPECT_EQ(value("LabelAccuracy"), metrics->GetLabelAccuracy());
  EXPECT_EQ(value("BoundaryDistance"), metrics->GetBoundaryDistance());
}

TEST(SegmentationMetrics, ArraysAreSelectable)
{
  const TriangleMesh mesh = MakeOctahedron();
  vtkNew<vtkMarrowSegmentationMetrics> metrics;
  metrics->SetInputData(0, Segmented(mesh, UpperLower, "Mine"));
  metrics->SetInputData(1, Segmented(mesh, RightLeft, "Theirs"));
  metrics->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Mine");
  metrics->SetInputArrayToProcess(1, 1, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Theirs");
  metrics->Update();
  EXPECT_NEAR(metrics->GetRandError(), 16.0 / 28.0, 1e-12);
}

TEST(SegmentationMetrics, ErrorsSayWhatIsWrong)
{
  const TriangleMesh mesh = MakeOctahedron();
  vtkNew<vtkMarrowSegmentationMetrics> metrics;
  ErrorObserver errors(metrics);
  metrics->SetInputData(0, Segmented(mesh, UpperLower));
  metrics->SetInputData(1, Segmented(MakeSphere(1.0, 1), std::vector<int>(32, 0)));
  metrics->Update();
  EXPECT_TRUE(errors.HasError("has 8 cells and the reference 32")) << errors.Text();
  EXPECT_EQ(metrics->GetOutput()->GetNumberOfRows(), 0);

  errors.Clear();
  metrics->SetInputData(1, Segmented(mesh, UpperLower, "Other"));
  metrics->Update();
  EXPECT_TRUE(errors.HasError("reference has no such cell array")) << errors.Text();

  errors.Clear();
  metrics->SetInputData(1, Segmented(mesh, { 1, 2, 3 }));
  metrics->Update();
  EXPECT_TRUE(errors.HasError("3 tuples of 1 components but the mesh has 8 cells"))
    << errors.Text();

  errors.Clear();
  const TriangleMesh flat = Scaled(mesh, 0.0);
  metrics->SetInputData(0, Segmented(flat, UpperLower));
  metrics->SetInputData(1, Segmented(flat, UpperLower));
  metrics->Update();
  EXPECT_TRUE(errors.HasError("no area")) << errors.Text();
  EXPECT_EQ(metrics->GetRandError(), 0.0);
}

TEST(SegmentationMetrics, MissingReferenceIsAnError)
{
  vtkNew<vtkMarrowSegmentationMetrics> metrics;
  ErrorObserver errors(metrics);
  metrics->SetInputData(0, Segmented(MakeOctahedron(), UpperLower));
  metrics->Update();
  EXPECT_FALSE(errors.Errors.empty());
}
}

TEST(SegmentationMetrics, APolygonIsOneFaceAndABoundaryDoesNotEndAtASeam)
{
  // The sides of a box around z, of four quads each, and the same cut into triangles. Of the quads every
  // corner is there for itself, as where a texture has a seam.
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  TriangleMesh triangles;
  std::vector<int> ofQuads, ofTriangles, referenceOfQuads, referenceOfTriangles;
  for (int level = 0; level < 5; ++level)
  {
    for (const auto& corner : { std::pair(1, 1), { -1, 1 }, { -1, -1 }, { 1, -1 } })
    {
      triangles.Points.emplace_back(corner.first, corner.second, level);
    }
  }
  for (int level = 0; level < 4; ++level)
  {
    for (int side = 0; side < 4; ++side)
    {
      const int a = 4 * level + side;
      const int b = 4 * level + (side + 1) % 4;
      polygons->InsertNextCell(4);
      for (int corner : { a, b, b + 4, a + 4 })
      {
        polygons->InsertCellPoint(points->InsertNextPoint(triangles.Points[corner].data()));
      }
      triangles.Triangles.push_back({ a, b, b + 4 });
      triangles.Triangles.push_back({ a, b + 4, a + 4 });
      ofQuads.push_back(level < 1 ? 0 : 1);
      referenceOfQuads.push_back(level < 3 ? 0 : 1);
      ofTriangles.insert(ofTriangles.end(), 2, ofQuads.back());
      referenceOfTriangles.insert(referenceOfTriangles.end(), 2, referenceOfQuads.back());
    }
  }
  triangles.BuildConnectivity();
  const auto quads = [&](const std::vector<int>& segments)
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetPolys(polygons);
    SetIntArray(mesh->GetCellData(), names::SegmentId, segments);
    return mesh;
  };
  vtkNew<vtkMarrowSegmentationMetrics> metrics;
  metrics->SetInputData(0, quads(ofQuads));
  metrics->SetInputData(1, quads(referenceOfQuads));
  metrics->Update();
  const auto expected = Compare(triangles, ofTriangles, referenceOfTriangles);
  EXPECT_NEAR(metrics->GetLabelAccuracy(), 0.5, 1e-12);
  EXPECT_NEAR(metrics->GetHammingDistance(), expected->GetHammingDistance(), 1e-12);
  EXPECT_NEAR(metrics->GetBoundaryDistance(), expected->GetBoundaryDistance(), 1e-12);
  EXPECT_GT(metrics->GetBoundaryDistance(), 0.0);
  // Pairs of faces: 4 of 16 against 12 of 16, not 8 of 32 against 24.
  EXPECT_NEAR(metrics->GetRandError(), (4.0 * 8.0 + 4.0 * 8.0) / 120.0, 1e-12);
}
