// SPDX-License-Identifier: BSD-3-Clause
#include "WorkingBodies.h"

#include "SurfaceBridge.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkWorkingSurface.h>

#include <algorithm>
#include <map>
#include <utility>

namespace marrow
{
namespace
{
vtkSmartPointer<vtkPolyData> ExtractTriangles(
  const TriangleMesh& mesh, const std::vector<int>& triangles)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  std::vector<vtkIdType> pointOfVertex(mesh.Points.size(), -1);
  for (int t : triangles)
  {
    cells->InsertNextCell(3);
    for (int corner : mesh.Triangles[t])
    {
      if (pointOfVertex[corner] < 0)
      {
        pointOfVertex[corner] = points->InsertNextPoint(mesh.Points[corner].data());
      }
      cells->InsertCellPoint(pointOfVertex[corner]);
    }
  }
  part->SetPoints(points);
  part->SetPolys(cells);
  return part;
}
}

std::string MakeWorkingBodies(vtkPolyData* input, WorkingBodies& bodies, const Progress& progress)
{
  bodies = WorkingBodies();
  vtkNew<vtkWorkingSurface> defaults; // which stand in its header alone
  WorkingSurfaceParameters parameters;
  parameters.MaximumFaces = defaults->GetMaximumFaces();
  SurfaceOfPolyData faces = ToPolygonMesh(input);
  const std::string error = ComputeWorkingSurface(faces.Mesh, parameters, progress, bodies.Surface);
  if (!error.empty() || !Report(progress, 1.0))
  {
    return error;
  }
  bodies.CellOfPolygon = std::move(faces.CellOfPolygon);
  bodies.NumberOfCells = static_cast<int>(input->GetNumberOfCells());
  bodies.TrianglesOfBody.resize(bodies.Surface.NumberOfBodies);
  for (int t = 0; t < bodies.Surface.Mesh.NumberOfTriangles(); ++t)
  {
    bodies.TrianglesOfBody[bodies.Surface.BodyOfTriangle[t]].push_back(t);
  }
  const bool isTriangles = faces.NumberOfOtherCells == 0 && input->GetNumberOfStrips() == 0;
  for (const std::vector<int>& triangles : bodies.TrianglesOfBody)
  {
    bodies.Meshes.push_back(
      bodies.Surface.IsInput && isTriangles && bodies.Surface.NumberOfBodies == 1
        ? vtkSmartPointer<vtkPolyData>(input)
        : ExtractTriangles(bodies.Surface.Mesh, triangles));
  }
  return {};
}

std::vector<std::vector<int>> LabelsOfBodies(
  const WorkingBodies& bodies, const std::vector<int>& labelOfCell)
{
  const WorkingSurface& surface = bodies.Surface;
  std::vector<std::map<int, double>> areas(surface.Mesh.Triangles.size());
  for (int t = 0; t < surface.Full.NumberOfTriangles(); ++t)
  {
    const int polygon = surface.CellOfFullTriangle[t];
    if (polygon >= 0)
    {
      areas[surface.TriangleOfFullTriangle[t]][labelOfCell[bodies.CellOfPolygon[polygon]]] +=
        surface.Full.Area(t);
    }
  }
  std::vector<int> labels(surface.Mesh.Triangles.size(), labelOfCell[bodies.CellOfPolygon[0]]);
  std::vector<char> isKnown(labels.size(), 0);
  std::vector<int> front;
  for (std::size_t t = 0; t < labels.size(); ++t)
  {
    if (!areas[t].empty())
    {
      labels[t] = std::max_element(areas[t].begin(), areas[t].end(),
        [](const auto& a, const auto& b) {
          return a.second < b.second;
        })->first;
      isKnown[t] = 1;
      front.push_back(static_cast<int>(t));
    }
  }
  // Where a hole was filled or the surface wrapped, no cell may lie nearest: from the neighbours inwards.
  for (std::size_t i = 0; i < front.size(); ++i)
  {
    for (int h = 3 * front[i]; h < 3 * front[i] + 3; ++h)
    {
      const int opposite = surface.Mesh.Opposite[h];
      const int neighbor = opposite < 0 ? -1 : TriangleMesh::TriangleOf(opposite);
      if (neighbor >= 0 && !isKnown[neighbor])
      {
        isKnown[neighbor] = 1;
        labels[neighbor] = labels[front[i]];
        front.push_back(neighbor);
      }
    }
  }
  std::vector<std::vector<int>> ofBodies;
  for (const std::vector<int>& triangles : bodies.TrianglesOfBody)
  {
    std::vector<int> ofBody;
    for (int t : triangles)
    {
      ofBody.push_back(labels[t]);
    }
    ofBodies.push_back(std::move(ofBody));
  }
  return ofBodies;
}
}
