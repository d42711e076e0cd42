// SPDX-License-Identifier: BSD-3-Clause
// Writes the meshes that ratios.py transfers between:
//   WriteBenchmarkMeshes FOLDER
// source.off with source.seg and target.off of 20,000 faces, large.off of 1,000,000.
#include <vtkCreatureSource.h>
#include <vtkMarrowMeshWriter.h>
#include <vtkMarrowSegmentWriter.h>
#include <vtkNew.h>

#include <string>

namespace
{
bool WriteMesh(vtkCreatureSource* creature, const std::string& fileName)
{
  vtkNew<vtkMarrowMeshWriter> writer;
  writer->SetInputConnection(creature->GetOutputPort());
  writer->SetFileName(fileName.c_str());
  return writer->Write() == 1;
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    return 2;
  }
  const std::string folder = std::string(argv[1]) + "/";
  vtkNew<vtkCreatureSource> creature;
  creature->SetShapeToQuadruped();
  creature->SetResolution(20000);
  vtkNew<vtkMarrowSegmentWriter> segments;
  segments->SetInputConnection(creature->GetOutputPort());
  segments->SetFileName((folder + "source.seg").c_str());
  if (!WriteMesh(creature, folder + "source.off") || segments->Write() != 1)
  {
    return 1;
  }
  creature->SetSeed(2);
  creature->SetPose(0.5);
  creature->SetProportion(0.5);
  if (!WriteMesh(creature, folder + "target.off"))
  {
    return 1;
  }
  creature->SetResolution(1000000);
  return WriteMesh(creature, folder + "large.off") ? 0 : 1;
}
