// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TestMeshes_h
#define marrow_TestMeshes_h

#include "ArrayNames.h"
#include "MeshBridge.h"
#include "SkeletonBridge.h"
#include "TestShapes.h"
#include "vtkCreatureSource.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <vector>

/// Meshes and skeletons as vtkPolyData. Link Marrow::Creatures and Marrow::Core.
namespace marrow::test
{
inline vtkSmartPointer<vtkPolyData> ToPolyData(const TriangleMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& point : mesh.Points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& triangle : mesh.Triangles)
  {
    polygons->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(polygons);
  return result;
}

struct CreatureOptions
{
  int Seed = 1;
  int Faces = 5000;
  double Pose = 0.0;
  double Proportion = 0.0;
  double Noise = 0.0;
};

/// A labelled surface (SegmentId on cells, SkeletonNodeId on points) and its known skeleton.
struct Creature
{
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkPolyData> Skeleton;
};

/// `shape` is one of vtkCreatureSource::BIPED, QUADRUPED, ...
inline Creature MakeCreature(int shape, const CreatureOptions& options = {})
{
  vtkNew<vtkCreatureSource> source;
  source->SetShape(shape);
  source->SetSeed(options.Seed);
  source->SetResolution(options.Faces);
  source->SetPose(options.Pose);
  source->SetProportion(options.Proportion);
  source->SetNoise(options.Noise);
  source->Update();
  return { source->GetOutput(0), source->GetOutput(1) };
}

/// Per cell its SegmentId.
inline std::vector<int> LabelsOf(vtkPolyData* mesh)
{
  std::vector<int> labels;
  GetArray(
    mesh->GetCellData(), names::SegmentId, static_cast<int>(mesh->GetNumberOfCells()), labels);
  return labels;
}

/// The known skeleton with the point arrays AGD and MSP that it lacks: the means of the mesh's
/// arrays of these names over each node's vertices, and for a node without vertices that of the
/// neighbouring nodes. `mesh` is the creature's mesh after vtkMSPField.
inline vtkSmartPointer<vtkPolyData> WithMeasures(const Creature& creature, vtkPolyData* mesh)
{
  const int numberOfVertices = static_cast<int>(mesh->GetNumberOfPoints());
  const int numberOfNodes = static_cast<int>(creature.Skeleton->GetNumberOfPoints());
  std::vector<int> nodeOfVertex;
  GetArray(mesh->GetPointData(), names::SkeletonNodeId, numberOfVertices, nodeOfVertex);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->DeepCopy(creature.Skeleton);
  for (const char* name : { names::AGD, names::MSP })
  {
    std::vector<double> values;
    GetArray(mesh->GetPointData(), name, numberOfVertices, values);
    std::vector<double> sum(numberOfNodes, 0.0);
    std::vector<int> count(numberOfNodes, 0);
    for (int v = 0; v < numberOfVertices; ++v)
    {
      if (nodeOfVertex[v] >= 0)
      {
        sum[nodeOfVertex[v]] += values[v];
        ++count[nodeOfVertex[v]];
      }
    }
    for (int n = 0; n < numberOfNodes; ++n)
    {
      sum[n] /= std::max(1, count[n]);
    }
    // Spread to nodes without vertices, a ring at a time.
    for (bool changed = true; changed;)
    {
      changed = false;
      for (vtkIdType c = 0; c < result->GetNumberOfCells(); ++c)
      {
        vtkNew<vtkIdList> line;
        result->GetCellPoints(c, line);
        for (vtkIdType i = 0; i < line->GetNumberOfIds(); ++i)
        {
          for (const vtkIdType k : { i - 1, i + 1 })
          {
            const int node = static_cast<int>(line->GetId(i));
            if (count[node] > 0 || k < 0 || k >= line->GetNumberOfIds() ||
              count[line->GetId(k)] == 0)
            {
              continue;
            }
            sum[node] = sum[line->GetId(k)];
            count[node] = 1;
            changed = true;
          }
        }
      }
    }
    SetArray(result->GetPointData(), name, sum);
  }
  return result;
}

/// A mesh with points and cells renumbered; every point and cell array goes along.
struct PermutedPolyData
{
  vtkSmartPointer<vtkPolyData> Mesh;
  std::vector<int> OldPoint; ///< per new point
  std::vector<int> OldCell;  ///< per new cell
};

inline PermutedPolyData Permuted(vtkPolyData* input, unsigned int seed)
{
  TriangleMesh mesh;
  ToTriangleMesh(input, mesh);
  const PermutedMesh permuted = Permuted(mesh, seed);
  PermutedPolyData result{ ToPolyData(permuted.Mesh), permuted.OldVertex, permuted.OldTriangle };
  auto copy = [](vtkDataSetAttributes* from, vtkDataSetAttributes* to, const std::vector<int>& old)
  {
    to->CopyAllOn();
    to->CopyAllocate(from, static_cast<vtkIdType>(old.size()));
    for (std::size_t i = 0; i < old.size(); ++i)
    {
      to->CopyData(from, old[i], static_cast<vtkIdType>(i));
    }
  };
  copy(input->GetPointData(), result.Mesh->GetPointData(), result.OldPoint);
  copy(input->GetCellData(), result.Mesh->GetCellData(), result.OldCell);
  return result;
}

/// A copy with every point moved by `transform` (callable on Eigen::Vector3d), all arrays kept.
template <typename Transform>
vtkSmartPointer<vtkPolyData> Transformed(vtkPolyData* input, Transform&& transform)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->DeepCopy(input);
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    Eigen::Vector3d point;
    result->GetPoint(i, point.data());
    point = transform(point);
    result->GetPoints()->SetPoint(i, point.data());
  }
  return result;
}
}

#endif
