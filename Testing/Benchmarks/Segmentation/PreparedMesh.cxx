// SPDX-License-Identifier: BSD-3-Clause
#include "PreparedMesh.h"

#include "ArrayNames.h"
#include "BenchmarkData.h"
#include "FilterRun.h"
#include "MeshBridge.h"
#include "SkeletonBridge.h"
#include "vtkMSPField.h"
#include "vtkMSPSkeleton.h"
#include "vtkMarrowMeshReader.h"
#ifdef MARROW_BENCHMARK_CGAL
#include "vtkMarrowMeanCurvatureSkeleton.h"
#endif

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <stdexcept>

namespace marrow::bench
{
namespace
{
void ThrowIf(const std::string& error)
{
  if (!error.empty())
  {
    throw std::runtime_error(error);
  }
}

vtkSmartPointer<vtkPolyDataAlgorithm> NewSkeletonFilter(SkeletonKind kind)
{
#ifdef MARROW_BENCHMARK_CGAL
  if (kind == SkeletonKind::MeanCurvature)
  {
    return vtkSmartPointer<vtkMarrowMeanCurvatureSkeleton>::New();
  }
#endif
  (void)kind;
  return vtkSmartPointer<vtkMSPSkeleton>::New();
}

void ReadFiles(const std::string& folder, PreparedMesh& mesh)
{
  ThrowIf(ToTriangleMesh(mesh.Surface, mesh.Mesh));
  ThrowIf(ToSkeleton(mesh.Skeleton, mesh.PlainSkeleton));
  const std::size_t faces = mesh.Mesh.Triangles.size();
  mesh.Areas = mesh.Mesh.TriangleAreas();
  mesh.Labels = ReadLabels(folder, mesh.Id, faces);
  mesh.Pieces = ReadPieces(folder, mesh.Id, faces);
  mesh.Humans = ReadHumans(folder, mesh.Id, faces);
  mesh.Features = ReadFeatures(folder, mesh.Id);
  for (std::size_t face = 0; face < faces; ++face)
  {
    mesh.LabelOfPiece[mesh.Pieces[face]] = mesh.Labels[face];
  }
  SetIntArray(mesh.Surface->GetCellData(), names::SegmentId, mesh.Pieces);
  if (!GetArray(mesh.Surface->GetPointData(), names::SkeletonNodeId, mesh.Mesh.NumberOfVertices(),
        mesh.NodeOfVertex) ||
    !SetNodeOfVertices(mesh.PlainSkeleton, mesh.NodeOfVertex))
  {
    throw std::runtime_error("The skeleton's node ids do not fit the mesh.");
  }
}
}

bool HasMeanCurvatureSkeleton()
{
#ifdef MARROW_BENCHMARK_CGAL
  return true;
#else
  return false;
#endif
}

PreparedMesh ComputeSkeleton(const std::string& folder, int mesh, SkeletonKind kind)
{
  PreparedMesh prepared;
  prepared.Id = mesh;
  try
  {
    vtkNew<vtkMarrowMeshReader> reader;
    reader->SetFileName(MeshFile(folder, mesh).c_str());
    Run(reader);
    vtkNew<vtkMSPField> field;
    field->SetInputConnection(reader->GetOutputPort());
    prepared.SecondsForField = Run(field);
    const vtkSmartPointer<vtkPolyDataAlgorithm> skeleton = NewSkeletonFilter(kind);
    skeleton->SetInputConnection(field->GetOutputPort());
    prepared.SecondsForSkeleton = Run(skeleton);
    prepared.Skeleton = vtkPolyData::SafeDownCast(skeleton->GetOutputDataObject(0));
    prepared.Surface = vtkPolyData::SafeDownCast(skeleton->GetOutputDataObject(1));
  }
  catch (const std::exception& error)
  {
    prepared.Error = error.what();
  }
  return prepared;
}

void ReadGroundTruth(const std::string& folder, PreparedMesh& mesh)
{
  if (!mesh.Error.empty())
  {
    return;
  }
  try
  {
    ReadFiles(folder, mesh);
  }
  catch (const std::exception& error)
  {
    mesh.Error = error.what();
  }
}

int MajorityOfNodes(
  const PreparedMesh& mesh, const std::vector<int>& nodes, const std::vector<int>& ids)
{
  std::map<int, int> corners;
  for (const int node : nodes)
  {
    for (const int vertex : mesh.PlainSkeleton.Graph[node].Vertices)
    {
      mesh.Mesh.ForEachOutgoing(
        vertex, [&](int h) { ++corners[ids[TriangleMesh::TriangleOf(h)]]; });
    }
  }
  const auto most = std::max_element(corners.begin(), corners.end(),
    [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == corners.end() ? -1 : most->first;
}
}
