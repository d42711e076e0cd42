// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_TransferTestData_h
#define marrow_TransferTestData_h

#include "ArrayNames.h"
#include "MeshBridge.h"
#include "TestMeshes.h"
#include "vtkSegmentationTransfer.h"

#include <vtkCellData.h>
#include <vtkMSPSkeleton.h>

#include <array>
#include <functional>
#include <map>
#include <tuple>
#include <vector>

/// Creatures made ready for a transfer, and what came of it.
namespace marrow::test
{
using Data = vtkSmartPointer<vtkPolyData>;

inline Data Output(vtkAlgorithm* filter, int port = 0)
{
  auto copy = Data::New();
  copy->ShallowCopy(filter->GetOutputDataObject(port));
  return copy;
}

/// A creature with the arrays of vtkMSPSkeleton and its skeleton.
struct Prepared
{
  Data Mesh;
  Data Skeleton;
};

inline Prepared Prepare(vtkPolyData* mesh)
{
  vtkNew<vtkMSPSkeleton> skeleton;
  skeleton->SetInputData(mesh);
  skeleton->Update();
  return { Output(skeleton, 1), Output(skeleton, 0) };
}

inline const Prepared& Quadruped(int seed, double pose, double proportion, int faces)
{
  static std::map<std::tuple<int, double, double, int>, Prepared> cache;
  auto& entry = cache[{ seed, pose, proportion, faces }];
  if (!entry.Mesh)
  {
    CreatureOptions options;
    options.Seed = seed;
    options.Pose = pose;
    options.Proportion = proportion;
    options.Faces = faces;
    entry = Prepare(MakeCreature(vtkCreatureSource::QUADRUPED, options).Mesh);
  }
  return entry;
}

inline const Prepared& Source()
{
  return Quadruped(1, 0.0, 0.0, 6000);
}

inline void Connect(
  vtkSegmentationTransfer* transfer, const Prepared& source, const Prepared& target)
{
  transfer->SetInputData(0, source.Mesh);
  transfer->SetInputData(1, target.Mesh);
  transfer->SetInputData(2, source.Skeleton);
  transfer->SetInputData(3, target.Skeleton);
}

/// Only the triangles for which `keep` holds.
inline Data Subset(vtkPolyData* input, const std::function<bool(const TriangleMesh&, int)>& keep)
{
  TriangleMesh mesh;
  ToTriangleMesh(input, mesh);
  const std::vector<int> labels = LabelsOf(input);
  TriangleMesh part;
  std::vector<int> partLabels;
  std::map<int, int> newVertex;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    if (!keep(mesh, t))
    {
      continue;
    }
    std::array<int, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      const int v = mesh.Triangles[t][k];
      const auto [entry, isNew] = newVertex.insert({ v, static_cast<int>(part.Points.size()) });
      if (isNew)
      {
        part.Points.push_back(mesh.Points[v]);
      }
      corners[k] = entry->second;
    }
    part.Triangles.push_back(corners);
    partLabels.push_back(labels[t]);
  }
  Data result = ToPolyData(part);
  SetIntArray(result->GetCellData(), names::SegmentId, partLabels);
  return result;
}

inline double Accuracy(vtkPolyData* result, const std::vector<int>& truth)
{
  TriangleMesh mesh;
  ToTriangleMesh(result, mesh);
  const std::vector<int> labels = LabelsOf(result);
  double right = 0.0;
  double total = 0.0;
  for (int t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    const double area = mesh.Area(t);
    right += labels.at(t) == truth[t] ? area : 0.0;
    total += area;
  }
  return right / total;
}

inline double TransferAccuracy(const Prepared& source, const Prepared& target)
{
  vtkNew<vtkSegmentationTransfer> transfer;
  Connect(transfer, source, target);
  transfer->Update();
  return Accuracy(Output(transfer), LabelsOf(target.Mesh));
}
}

#endif
