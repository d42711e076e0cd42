// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMesh.h"

#include "MeshBridge.h"
#include "vtkCreatureSource.h"
#include "vtkMarrowMeshReader.h"

#include <vtkNew.h>
#include <vtkQuadricDecimation.h>

#include <cstdlib>
#include <iostream>
#include <map>

namespace marrow::bench
{
namespace
{
vtkSmartPointer<vtkPolyData> Reduced(const char* fileName, int faces)
{
  vtkNew<vtkMarrowMeshReader> reader;
  reader->SetFileName(fileName);
  reader->Update();
  const double size = static_cast<double>(reader->GetOutput()->GetNumberOfPolys());
  if (size <= faces)
  {
    return reader->GetOutput();
  }
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputConnection(reader->GetOutputPort());
  decimation->SetTargetReduction(1.0 - faces / size);
  decimation->Update();
  return decimation->GetOutput();
}
}

vtkSmartPointer<vtkPolyData> Mesh(int faces)
{
  static std::map<int, vtkSmartPointer<vtkPolyData>> meshes;
  vtkSmartPointer<vtkPolyData>& mesh = meshes[faces];
  if (!mesh)
  {
    if (const char* fileName = std::getenv("MARROW_BENCHMARK_MESH"))
    {
      mesh = Reduced(fileName, faces);
    }
    else
    {
      vtkNew<vtkCreatureSource> creature;
      creature->SetShapeToBiped();
      creature->SetResolution(faces);
      creature->Update();
      mesh = creature->GetOutput();
    }
  }
  return mesh;
}

TriangleMesh PlainMesh(int faces)
{
  TriangleMesh mesh;
  const std::string error = ToTriangleMesh(Mesh(faces), mesh);
  if (!error.empty())
  {
    std::cerr << error << std::endl;
    std::exit(1);
  }
  return mesh;
}
}
