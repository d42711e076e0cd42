// SPDX-License-Identifier: BSD-3-Clause
#include "CollectedMeshes.h"

#include "ArrayNames.h"
#include "ContentKey.h"
#include "ParallelFor.h"
#include "SharedProgress.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <utility>

namespace marrow
{
namespace
{
void Add(vtkDataArray* array, ContentKey& key)
{
  if (!array)
  {
    key.Add(nullptr, 0);
    return;
  }
  const vtkIdType size = array->GetNumberOfValues();
  if (array->HasStandardMemoryLayout() && size > 0)
  {
    const int type = array->GetDataType();
    key.Add(&type, sizeof(type));
    key.Add(array->GetVoidPointer(0), static_cast<std::size_t>(size * array->GetDataTypeSize()));
    return;
  }
  const int components = array->GetNumberOfComponents();
  for (vtkIdType i = 0; i < size; ++i)
  {
    const double value = array->GetComponent(i / components, static_cast<int>(i % components));
    key.Add(&value, sizeof(value));
  }
}

/// Of all that AnalyzeSide reads.
std::string KeyOf(vtkPolyData* mesh)
{
  ContentKey key;
  Add(mesh->GetPoints() ? mesh->GetPoints()->GetData() : nullptr, key);
  for (vtkCellArray* cells :
    { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    Add(cells->GetOffsetsArray(), key);
    Add(cells->GetConnectivityArray(), key);
  }
  for (const char* name : { names::AGD, names::MSP, names::MSPCenter, names::MSPNormal,
         names::MSPGradient, names::MSPValid, names::DihedralAngle })
  {
    Add(mesh->GetPointData()->GetArray(name), key);
  }
  return key.Text();
}

std::shared_ptr<const CollectedMesh> Analyze(vtkPolyData* mesh, const Progress& progress)
{
  auto collected = std::make_shared<CollectedMesh>();
  collected->Error = AnalyzeSide(mesh, nullptr, collected->Side, progress);
  if (!Report(progress, 1.0))
  {
    return nullptr;
  }
  if (collected->Error.empty())
  {
    for (const AnalyzedMesh& body : collected->Side.Bodies)
    {
      collected->Shapes.push_back(std::make_unique<CollectionShape>(body));
    }
  }
  return collected;
}
}

bool CollectedMeshes::Collect(const std::vector<vtkPolyData*>& meshes,
  std::vector<std::shared_ptr<const CollectedMesh>>& collected, const Progress& progress)
{
  std::vector<std::string> keys;
  std::map<std::string, std::shared_ptr<const CollectedMesh>> kept;
  std::vector<std::pair<std::string, vtkPolyData*>> unknown;
  for (vtkPolyData* mesh : meshes)
  {
    keys.push_back(KeyOf(mesh));
    if (!kept.count(keys.back()))
    {
      const auto known = this->Known.find(keys.back());
      kept[keys.back()] = known == this->Known.end() ? nullptr : known->second;
      if (known == this->Known.end())
      {
        unknown.emplace_back(keys.back(), mesh);
      }
    }
  }
  std::vector<std::shared_ptr<const CollectedMesh>> made(unknown.size());
  SharedProgress shared(progress);
  ParallelFor(0, static_cast<int>(unknown.size()),
    [&](int first, int last)
    {
      for (int i = first; i < last; ++i)
      {
        bool isStopped = false;
        double done = 0.0;
        made[i] = Analyze(unknown[i].second,
          [&](double fraction)
          {
            isStopped = isStopped || !shared.Add((fraction - done) / unknown.size());
            done = fraction;
            return !isStopped;
          });
      }
    });
  bool isComplete = true;
  for (std::size_t i = 0; i < unknown.size(); ++i)
  {
    isComplete = isComplete && made[i];
    kept[unknown[i].first] = made[i];
    if (!made[i])
    {
      kept.erase(unknown[i].first);
    }
  }
  this->Known = std::move(kept);
  collected.clear();
  for (const std::string& key : keys)
  {
    const auto known = this->Known.find(key);
    collected.push_back(known == this->Known.end() ? nullptr : known->second);
  }
  return isComplete;
}
}
