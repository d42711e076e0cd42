// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayNames.h"
#include "MeshBridge.h"
#include "SkeletonBridge.h"
#include "TestMeshes.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace marrow;
using namespace marrow::test;

namespace
{
/// A junction with three arms, one of them with a loop at its end.
Skeleton MakeSkeleton()
{
  Skeleton skeleton;
  const Eigen::Vector3d positions[] = { { 0, 0, 0 }, { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 },
    { 0, 2, 0 }, { 1, 2, 0 }, { 0, 3, 0 } };
  int vertex = 0;
  for (const auto& position : positions)
  {
    SkeletonNode node;
    node.Position = position;
    node.AGD = 0.1 * vertex;
    node.MSP = 1.0 + vertex;
    node.Radius = 0.5 + 0.01 * vertex;
    node.Vertices = { vertex, vertex + 10 };
    ++vertex;
    boost::add_vertex(node, skeleton.Graph);
  }
  const int edges[][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 3, 4 }, { 4, 5 }, { 5, 6 }, { 6, 4 } };
  for (const auto& edge : edges)
  {
    boost::add_edge(edge[0], edge[1], skeleton.Graph);
  }
  skeleton.MeshDiagonal = 7.5;
  skeleton.MeshMaximumMSP = 42.0;
  skeleton.ExtractBranches();
  return skeleton;
}

std::string ErrorOf(vtkPolyData* skeleton)
{
  Skeleton ignored;
  return ToSkeleton(skeleton, ignored);
}
}

TEST(MeshBridge, PointsAndCellsKeepTheirNumbers)
{
  const TriangleMesh mesh = MakeTorus(2.0, 0.5, 9, 7);
  TriangleMesh back;
  EXPECT_EQ(ToTriangleMesh(ToPolyData(mesh), back), "");
  EXPECT_EQ(back.Points, mesh.Points);
  EXPECT_EQ(back.Triangles, mesh.Triangles);
  EXPECT_EQ(back.Opposite, mesh.Opposite);
}

TEST(MeshBridge, RefusesWhatIsNoTriangleMesh)
{
  TriangleMesh mesh;
  EXPECT_EQ(ToTriangleMesh(nullptr, mesh),
    "The mesh is empty: it has no points or no cells; connect a surface of triangles.");
  vtkNew<vtkPolyData> empty;
  EXPECT_NE(ToTriangleMesh(empty, mesh).find("is empty"), std::string::npos);

  auto polygons = ToPolyData(MakeSphere(1.0, 0));
  polygons->GetPolys()->InsertNextCell({ 0, 2, 1, 3 });
  EXPECT_EQ(ToTriangleMesh(polygons, mesh),
    "The mesh has 1 polygons that are not triangles (the first is cell 8): run vtkTriangleFilter "
    "first.");

  auto lines = ToPolyData(MakeSphere(1.0, 0));
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({ 0, 1 });
  lines->SetLines(line);
  EXPECT_EQ(ToTriangleMesh(lines, mesh),
    "The mesh has 0 vertex, 1 line and 0 strip cells beside its polygons: run vtkTriangleFilter "
    "with PassVertsOff and PassLinesOff first.");

  auto outside = ToPolyData(MakeSphere(1.0, 0));
  outside->GetPolys()->InsertNextCell({ 0, 2, 6 });
  EXPECT_EQ(ToTriangleMesh(outside, mesh),
    "The mesh has 1 triangles that name a point that does not exist (the first is cell 8): repair "
    "the cells.");

  auto infinite = ToPolyData(MakeSphere(1.0, 0));
  infinite->GetPoints()->SetPoint(3, 0.0, std::numeric_limits<double>::infinity(), 0.0);
  EXPECT_EQ(ToTriangleMesh(infinite, mesh),
    "The mesh has points whose coordinates are not finite (the first in use is point 3): remove or "
    "repair them.");
}

TEST(MeshBridge, ArraysGoThereAndBack)
{
  vtkNew<vtkPolyData> data;
  vtkPointData* arrays = data->GetPointData();
  const std::vector<double> scalars{ 0.5, -2.0, 1e300 };
  const std::vector<Eigen::Vector3d> vectors{ { 1, 2, 3 }, { 4, 5, 6 }, { 7, 8, 9 } };
  const std::vector<unsigned char> bytes{ 0, 255, 7 };
  const std::vector<int> integers{ -1, 0, 2000000000 };
  SetArray(arrays, "scalars", scalars);
  SetArray(arrays, "vectors", vectors);
  SetArray(arrays, "bytes", bytes);
  SetIntArray(arrays, "integers", integers);
  SetIdArray(arrays, "ids", integers);

  std::vector<double> scalarsBack;
  std::vector<Eigen::Vector3d> vectorsBack;
  std::vector<unsigned char> bytesBack;
  std::vector<int> integersBack;
  EXPECT_TRUE(GetArray(arrays, "scalars", 3, scalarsBack));
  EXPECT_EQ(scalarsBack, scalars);
  EXPECT_TRUE(GetArray(arrays, "vectors", 3, vectorsBack));
  EXPECT_EQ(vectorsBack, vectors);
  EXPECT_TRUE(GetArray(arrays, "bytes", 3, bytesBack));
  EXPECT_EQ(bytesBack, bytes);
  EXPECT_TRUE(GetArray(arrays, "integers", 3, integersBack));
  EXPECT_EQ(integersBack, integers);
  EXPECT_TRUE(GetArray(arrays, "ids", 3, integersBack));
  EXPECT_EQ(integersBack, integers);
  EXPECT_EQ(arrays->GetArray("ids")->GetDataType(), VTK_ID_TYPE);
  EXPECT_EQ(arrays->GetArray("integers")->GetDataType(), VTK_INT);
  EXPECT_EQ(arrays->GetArray("ids")->GetMaxDiscreteValues(), MostLabels);
  EXPECT_EQ(arrays->GetArray("integers")->GetMaxDiscreteValues(), MostLabels);

  EXPECT_FALSE(GetArray(arrays, "absent", 3, scalarsBack));
  EXPECT_FALSE(GetArray(arrays, "scalars", 4, scalarsBack)) << "wrong number of tuples";
  EXPECT_FALSE(GetArray(arrays, "vectors", 3, scalarsBack)) << "wrong number of components";
  EXPECT_FALSE(GetArray(arrays, "scalars", 3, vectorsBack)) << "wrong number of components";

  SetArray(arrays, "scalars", std::vector<double>{ 1.0, 2.0, 3.0 });
  EXPECT_EQ(arrays->GetNumberOfArrays(), 5) << "an array of the same name is replaced";
}

TEST(SkeletonBridge, SkeletonGoesThereAndBack)
{
  const Skeleton skeleton = MakeSkeleton();
  vtkNew<vtkPolyData> data;
  ToPolyData(skeleton, data);
  EXPECT_EQ(data->GetNumberOfPoints(), 7);
  EXPECT_EQ(data->GetNumberOfLines(), 4);
  const int types[] = { 3, 1, 1, 2, 3, 2, 2 };
  for (int n = 0; n < 7; ++n)
  {
    EXPECT_EQ(data->GetPointData()->GetArray(names::NodeType)->GetTuple1(n), types[n]);
    EXPECT_EQ(data->GetPointData()->GetArray(names::VertexCount)->GetTuple1(n), 2);
  }
  vtkDataArray* length = data->GetCellData()->GetArray(names::BranchLength);
  EXPECT_DOUBLE_EQ(length->GetTuple1(3), 2.0 + std::sqrt(2.0)) << "the loop";

  Skeleton back;
  ASSERT_EQ(ToSkeleton(data, back), "");
  ASSERT_EQ(back.NumberOfNodes(), skeleton.NumberOfNodes());
  ASSERT_EQ(back.NumberOfBranches(), skeleton.NumberOfBranches());
  for (int n = 0; n < skeleton.NumberOfNodes(); ++n)
  {
    EXPECT_EQ(back.Graph[n].Position, skeleton.Graph[n].Position);
    EXPECT_EQ(back.Graph[n].AGD, skeleton.Graph[n].AGD);
    EXPECT_EQ(back.Graph[n].MSP, skeleton.Graph[n].MSP);
    EXPECT_EQ(back.Graph[n].Radius, skeleton.Graph[n].Radius);
    EXPECT_EQ(back.TypeOf(n), skeleton.TypeOf(n));
  }
  for (int b = 0; b < skeleton.NumberOfBranches(); ++b)
  {
    EXPECT_EQ(back.Branches[b].Nodes, skeleton.Branches[b].Nodes);
    EXPECT_EQ(back.Branches[b].ArcLength, skeleton.Branches[b].ArcLength);
  }
  EXPECT_EQ(back.NumberOfLoops(), 1);
  EXPECT_EQ(back.MeshDiagonal, 7.5);
  EXPECT_EQ(back.MeshMaximumMSP, 42.0);
}

TEST(SkeletonBridge, DirectionOfThePolylinesIsKept)
{
  vtkNew<vtkPolyData> data;
  ToPolyData(MakeSkeleton(), data);
  vtkNew<vtkCellArray> reversed;
  reversed->InsertNextCell({ 4, 3, 0 });
  reversed->InsertNextCell({ 2, 0 });
  reversed->InsertNextCell({ 0, 1 });
  reversed->InsertNextCell({ 4, 6, 5, 4 });
  data->SetLines(reversed);
  Skeleton skeleton;
  ASSERT_EQ(ToSkeleton(data, skeleton), "");
  EXPECT_EQ(skeleton.Branches[0].Nodes, (std::vector<int>{ 4, 3, 0 }));
  EXPECT_EQ(skeleton.Branches[3].Nodes, (std::vector<int>{ 4, 6, 5, 4 }));
}

TEST(SkeletonBridge, RefusesWhatIsNoSkeleton)
{
  EXPECT_EQ(ErrorOf(nullptr),
    "The skeleton is empty: it has no points or no lines; connect the first output of "
    "vtkMSPSkeleton.");

  vtkNew<vtkPolyData> data;
  ToPolyData(MakeSkeleton(), data);
  data->GetPointData()->RemoveArray(names::MSP);
  EXPECT_EQ(ErrorOf(data),
    "The skeleton has no point array \"MSP\" with one component: connect the first output of "
    "vtkMSPSkeleton.");

  ToPolyData(MakeSkeleton(), data);
  data->GetPointData()->GetArray(names::AGD)->SetTuple1(2, std::nan(""));
  EXPECT_EQ(ErrorOf(data),
    "The skeleton's point array \"AGD\" is not finite at point 2: compute the skeleton again.");

  ToPolyData(MakeSkeleton(), data);
  data->GetPoints()->SetPoint(1, std::nan(""), 0.0, 0.0);
  EXPECT_EQ(ErrorOf(data),
    "The skeleton's point 1 has coordinates that are not finite: compute the skeleton again.");

  ToPolyData(MakeSkeleton(), data);
  data->GetLines()->InsertNextCell({ 3 });
  EXPECT_NE(ErrorOf(data).find("line 4 has fewer than two points"), std::string::npos);

  ToPolyData(MakeSkeleton(), data);
  data->GetLines()->InsertNextCell({ 3, 7 });
  EXPECT_NE(ErrorOf(data).find("line 4 names a point that does not exist"), std::string::npos);

  ToPolyData(MakeSkeleton(), data);
  vtkNew<vtkCellArray> through;
  through->InsertNextCell({ 1, 0, 2 });
  through->InsertNextCell({ 0, 3 });
  data->SetLines(through);
  EXPECT_NE(ErrorOf(data).find("line 0 runs through the junction at point 0"), std::string::npos);
}

TEST(SkeletonBridge, NodeOfVerticesGoesThereAndBack)
{
  Skeleton skeleton = MakeSkeleton();
  const std::vector<int> nodeOfVertex = NodeOfVertices(skeleton, 18);
  EXPECT_EQ(nodeOfVertex[3], 3);
  EXPECT_EQ(nodeOfVertex[13], 3);
  EXPECT_EQ(nodeOfVertex[8], -1);
  Skeleton empty = MakeSkeleton();
  for (int n = 0; n < empty.NumberOfNodes(); ++n)
  {
    empty.Graph[n].Vertices.clear();
  }
  EXPECT_TRUE(SetNodeOfVertices(empty, nodeOfVertex));
  for (int n = 0; n < empty.NumberOfNodes(); ++n)
  {
    EXPECT_EQ(empty.Graph[n].Vertices, skeleton.Graph[n].Vertices);
  }
  EXPECT_FALSE(SetNodeOfVertices(empty, { 0, 7 }));
  EXPECT_FALSE(SetNodeOfVertices(empty, { -2 }));
}
