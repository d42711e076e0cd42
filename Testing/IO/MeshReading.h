// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_MeshReading_h
#define marrow_MeshReading_h

#include "ErrorObserver.h"
#include "TemporaryFile.h"
#include "vtkMarrowMeshReader.h"

#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace marrow::test
{
/// A mesh that vtkMarrowMeshReader read, and what it said.
struct Reading
{
  vtkSmartPointer<vtkPolyData> Mesh;
  std::string Messages;

  bool Has(const std::string& part) const { return this->Messages.find(part) != std::string::npos; }
  std::vector<vtkIdType> Cell(vtkIdType id) const
  {
    vtkNew<vtkIdList> ids;
    this->Mesh->GetCellPoints(id, ids);
    return { ids->begin(), ids->end() };
  }
  std::vector<double> Point(const char* name, vtkIdType id) const
  {
    return Tuple(this->Mesh->GetPointData(), name, id);
  }
  std::vector<double> Face(const char* name, vtkIdType id) const
  {
    return Tuple(this->Mesh->GetCellData(), name, id);
  }

private:
  static std::vector<double> Tuple(vtkDataSetAttributes* data, const char* name, vtkIdType id)
  {
    vtkDataArray* array = data->GetArray(name);
    return array ? std::vector<double>(
                     array->GetTuple(id), array->GetTuple(id) + array->GetNumberOfComponents())
                 : std::vector<double>();
  }
};

inline Reading Read(const char* fileName)
{
  vtkNew<vtkMarrowMeshReader> reader;
  const ErrorObserver errors(reader);
  reader->SetFileName(fileName);
  reader->Update();
  return { reader->GetOutput(), errors.Text() };
}

inline Reading ReadText(const std::string& ending, const std::string& text)
{
  return Read(TemporaryFile(ending, text).Name());
}

/// The bytes of a number; the tests run on little-endian machines.
template <typename Number>
std::string LittleEndian(Number number)
{
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(Number));
  return bytes;
}

template <typename Number>
std::string BigEndian(Number number)
{
  std::string bytes = LittleEndian(number);
  std::reverse(bytes.begin(), bytes.end());
  return bytes;
}
}

#endif
