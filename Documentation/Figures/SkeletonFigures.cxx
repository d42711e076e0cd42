// SPDX-License-Identifier: BSD-3-Clause
#include "EdgeCollapser.h"
#include "Figures.h"
#include "MeshBridge.h"
#include "ShrunkMesh.h"

#ifdef MARROW_HAS_SKELETON_CGAL
#include <vtkMarrowMeanCurvatureSkeleton.h>
#endif

#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkMSPField.h>
#include <vtkMSPSkeleton.h>
#include <vtkMarrowLabelColors.h>
#include <vtkMarrowSkeletonGlyphs.h>
#include <vtkMarrowSkeletonMapper.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>

namespace figures
{
namespace
{
/// The shrunk mesh of the camel, and what it comes from.
struct Shrunk
{
  Data Mesh;
  marrow::TriangleMesh Plain;
  std::vector<double> MSP;
  std::vector<Eigen::Vector3d> Positions;
};

Shrunk Shrink(const std::string& meshes)
{
  vtkNew<vtkMSPField> field;
  field->SetInputData(ReadMesh(meshes, "camel"));
  field->Update();
  Shrunk shrunk;
  shrunk.Mesh = Output(field);
  marrow::ToTriangleMesh(shrunk.Mesh, shrunk.Plain);
  const int size = shrunk.Plain.NumberOfVertices();
  std::vector<Eigen::Vector3d> centers;
  std::vector<unsigned char> valid;
  marrow::GetArray(shrunk.Mesh->GetPointData(), "MSP", size, shrunk.MSP);
  marrow::GetArray(shrunk.Mesh->GetPointData(), "MSPCenter", size, centers);
  marrow::GetArray(shrunk.Mesh->GetPointData(), "MSPValid", size, valid);
  shrunk.Positions = marrow::ShrinkMesh(
    shrunk.Plain, shrunk.MSP, centers, marrow::SliceReliability(shrunk.Plain, shrunk.MSP, valid));
  return shrunk;
}

/// A surface of these triangles, drawn with its edges.
vtkSmartPointer<vtkActor> Net(const std::vector<Eigen::Vector3d>& points,
  const std::vector<std::array<int, 3>>& triangles, const std::vector<std::array<int, 2>>& edges)
{
  vtkNew<vtkPoints> places;
  for (const Eigen::Vector3d& point : points)
  {
    places->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& triangle : triangles)
  {
    polygons->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  vtkNew<vtkCellArray> lines;
  for (const auto& edge : edges)
  {
    lines->InsertNextCell({ edge[0], edge[1] });
  }
  vtkNew<vtkPolyData> net;
  net->SetPoints(places);
  net->SetPolys(polygons);
  net->SetLines(lines);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(net);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* look = actor->GetProperty();
  look->SetColor(0.93, 0.62, 0.35);
  look->EdgeVisibilityOn();
  look->SetEdgeColor(0.35, 0.2, 0.1);
  look->SetLineWidth(1);
  return actor;
}

Picture DrawShrunkMesh(const std::string& meshes)
{
  const Shrunk shrunk = Shrink(meshes);
  const auto scene = Scene(340, 340);
  const int surface = scene->AddMesh(shrunk.Mesh, nullptr, "surface");
  const int inside = scene->AddMesh(shrunk.Mesh, nullptr, "every vertex at its slice centre");
  scene->SetTileOpacity(surface, 1.0);
  scene->SetTileOpacity(inside, 0.15);
  scene->AddActor(inside, Net(shrunk.Positions, shrunk.Plain.Triangles, {}));
  return Drawn(scene);
}

/// The complex at the moments when this many triangles are left.
Picture DrawCollapse(const std::string& meshes)
{
  const Shrunk shrunk = Shrink(meshes);
  const auto scene = Scene(210, 300);
  // The hind part, from the side.
  double box[6];
  shrunk.Mesh->GetBounds(box);
  const Data hind = Faces(shrunk.Mesh,
    [&](vtkIdType face)
    {
      const double* corner = shrunk.Mesh->GetPoint(shrunk.Mesh->GetCell(face)->GetPointId(0));
      return corner[2] < box[4] + 0.35 * (box[5] - box[4]) &&
        corner[1] > box[2] + 0.3 * (box[3] - box[2]);
    });
  marrow::EdgeCollapser collapser(shrunk.Plain, shrunk.Positions, shrunk.MSP);
  const auto add = [&](const std::string& caption)
  {
    const marrow::CollapseComplex& complex = collapser.GetComplex();
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<int, 2>> edges;
    for (int e = 0; e < complex.NumberOfEdges(); ++e)
    {
      const auto& edge = complex.EdgeAt(e);
      if (!edge.Alive)
      {
        continue;
      }
      edges.push_back({ edge.A, edge.B });
      for (const int apex : edge.Apexes)
      {
        if (apex > std::max(edge.A, edge.B))
        {
          triangles.push_back({ edge.A, edge.B, apex });
        }
      }
    }
    const int tile = scene->AddMesh(shrunk.Mesh, nullptr, caption.c_str());
    scene->SetTileOpacity(tile, 0.12);
    scene->SetCloseUp(tile, hind);
    scene->AddActor(tile, Net(shrunk.Positions, triangles, edges));
  };
  add(std::to_string(shrunk.Plain.NumberOfTriangles()) + " triangles");
  std::vector<double> moments = { 0.98, 0.8 };
  collapser.Run(
    [&](double fraction)
    {
      if (!moments.empty() && fraction >= moments.back())
      {
        moments.pop_back();
        add(std::to_string(collapser.GetComplex().NumberOfTriangles()) + " triangles");
      }
      return true;
    });
  add("no triangle");
  return Drawn(scene);
}

Picture DrawNodeRegions(const std::string& meshes)
{
  vtkNew<vtkMSPSkeleton> filter;
  filter->SetInputData(ReadMesh(meshes, "camel"));
  filter->SetNodeSpacing(0.035);
  filter->Update();
  const Data skeleton = Output(filter, 0);
  const Data mesh = Output(filter, 1);
  vtkDataArray* nodes = mesh->GetPointData()->GetArray("SkeletonNodeId");
  const auto colorOf = [](int node) { return node * 3 % 7; };
  vtkNew<vtkIntArray> regions;
  regions->SetName("SegmentId");
  for (vtkIdType face = 0; face < mesh->GetNumberOfCells(); ++face)
  {
    regions->InsertNextValue(
      colorOf(static_cast<int>(nodes->GetTuple1(mesh->GetCell(face)->GetPointId(0)))));
  }
  mesh->GetCellData()->AddArray(regions);
  const auto scene = Scene(350, 340);
  scene->AddMesh(mesh, nullptr, "the vertices of each node");
  const int inside = scene->AddMesh(Plain(mesh), nullptr, "and the nodes");
  scene->SetTileOpacity(inside, 0.2);
  scene->AddCurves(inside, skeleton, 0.3, 0.3, 0.3, 0.002);
  for (vtkIdType node = 0; node < skeleton->GetNumberOfPoints(); ++node)
  {
    Color color;
    vtkMarrowLabelColors::GetColor(colorOf(static_cast<int>(node)), color.data());
    scene->AddActor(
      inside, Ball(Eigen::Vector3d(skeleton->GetPoint(node)), 0.009 * mesh->GetLength(), color));
  }
  return Drawn(scene);
}

/// One mesh's skeletons with their nodes as balls.
Picture DrawNodes(
  vtkPolyData* mesh, const std::vector<std::pair<std::string, Data>>& skeletons, bool allNodes)
{
  const auto scene = Scene(260, 270);
  scene->SetSurfaceOpacity(0.2);
  for (const auto& [caption, skeleton] : skeletons)
  {
    const int tile = scene->AddMesh(mesh, nullptr, caption.c_str());
    vtkNew<vtkMarrowSkeletonMapper> mapper;
    mapper->SetInputDataObject(skeleton);
    mapper->GetGlyphs()->SetShowRegularNodes(allNodes);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    scene->AddActor(tile, actor);
  }
  return Drawn(scene);
}

Data SkeletonWith(vtkPolyData* mesh, const std::function<void(vtkMSPSkeleton*)>& set)
{
  vtkNew<vtkMSPSkeleton> filter;
  filter->SetInputData(mesh);
  set(filter);
  filter->Update();
  return Output(filter);
}

Picture DrawFinestArea(const std::string& meshes)
{
  const Data mesh = ReadMesh(meshes, "camel");
  std::vector<std::pair<std::string, Data>> skeletons;
  for (const char* area : { "0", "0.004", "0.05" })
  {
    skeletons.emplace_back(std::string("FinestArea ") + area,
      SkeletonWith(mesh, [&](vtkMSPSkeleton* s) { s->SetFinestArea(std::stod(area)); }));
  }
  return DrawNodes(mesh, skeletons, false);
}

Picture DrawNodeSpacing(const std::string&)
{
  const Data mesh = Plain(Creature(vtkCreatureSource::BIPED, 3, 0.5));
  std::vector<std::pair<std::string, Data>> skeletons;
  for (const char* spacing : { "0.012", "0.04", "0.1" })
  {
    skeletons.emplace_back(std::string("NodeSpacing ") + spacing,
      SkeletonWith(mesh, [&](vtkMSPSkeleton* s) { s->SetNodeSpacing(std::stod(spacing)); }));
  }
  return DrawNodes(mesh, skeletons, true);
}

#ifdef MARROW_HAS_SKELETON_CGAL
Picture DrawSkeletonMethods(const std::string& meshes)
{
  const Data mesh = ReadMesh(meshes, "armadillo");
  vtkNew<vtkMarrowMeanCurvatureSkeleton> flow;
  flow->SetInputData(mesh);
  flow->Update();
  const auto scene = Scene(340, 340);
  scene->SetSurfaceOpacity(0.2);
  scene->AddMesh(mesh, SkeletonWith(mesh, [](vtkMSPSkeleton*) {}), "vtkMSPSkeleton");
  scene->AddMesh(mesh, Output(flow), "vtkMarrowMeanCurvatureSkeleton");
  return Drawn(scene);
}

Picture DrawMeanCurvature(const std::string& meshes)
{
  const Data mesh = ReadMesh(meshes, "camel");
  std::vector<std::pair<std::string, Data>> skeletons;
  const auto add = [&](const char* quality, const char* centered)
  {
    vtkNew<vtkMarrowMeanCurvatureSkeleton> flow;
    flow->SetInputData(mesh);
    flow->SetQualitySpeedTradeoff(std::stod(quality));
    flow->SetMediallyCenteredSpeedTradeoff(std::stod(centered));
    flow->Update();
    skeletons.emplace_back(
      std::string("quality ") + quality + ", centered " + centered, Output(flow));
  };
  add("0.1", "0.2");
  add("10", "0.2");
  add("0.1", "10");
  return DrawNodes(mesh, skeletons, false);
}
#endif
}

Drawings SkeletonFigures()
{
  return { { "shrunk-mesh", DrawShrunkMesh }, { "collapse", DrawCollapse },
    { "node-regions", DrawNodeRegions }, { "parameter-finest-area", DrawFinestArea },
    { "parameter-node-spacing", DrawNodeSpacing },
#ifdef MARROW_HAS_SKELETON_CGAL
    { "skeleton-methods", DrawSkeletonMethods }, { "parameter-mean-curvature", DrawMeanCurvature }
#endif
  };
}
}
