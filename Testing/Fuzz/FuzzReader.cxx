// SPDX-License-Identifier: BSD-3-Clause
// Reads whatever bytes the fuzzer gives as an XML file of VTK, by VTK's reader. The address and undefined-behaviour
// sanitizers watch; a mesh that comes out must be sound.
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkLogger.h>
#include <vtkMarrowMeshReader.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <unistd.h>

namespace
{
std::string WriteFile(const std::uint8_t* data, std::size_t size)
{
  // In memory: a disk would be the slowest part.
  const std::string name = "/dev/shm/marrow-fuzz-" + std::to_string(getpid()) + ".vtp";
  std::FILE* file = std::fopen(name.c_str(), "wb");
  if (!file || std::fwrite(data, 1, size, file) != size || std::fclose(file) != 0)
  {
    std::abort();
  }
  return name;
}

void Require(bool holds)
{
  if (!holds)
  {
    std::abort();
  }
}

void RequireSizes(vtkDataSetAttributes* data, vtkIdType size)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    Require(data->GetAbstractArray(i)->GetNumberOfTuples() == size);
  }
}

void ReadMesh(const std::string& name)
{
  vtkNew<vtkMarrowMeshReader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  vtkPolyData* mesh = reader->GetOutput();
  Require(mesh->GetNumberOfCells() == mesh->GetNumberOfPolys());
  RequireSizes(mesh->GetPointData(), mesh->GetNumberOfPoints());
  RequireSizes(mesh->GetCellData(), mesh->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetCellPoints(cell, size, ids);
    Require(size >= 3);
    for (vtkIdType k = 0; k < size; ++k)
    {
      Require(ids[k] >= 0 && ids[k] < mesh->GetNumberOfPoints());
    }
  }
}
}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  vtkObject::GlobalWarningDisplayOff();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string name = WriteFile(data, size);
  ReadMesh(name);
  std::remove(name.c_str());
  return 0;
}
