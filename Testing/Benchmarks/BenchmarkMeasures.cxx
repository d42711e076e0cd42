// SPDX-License-Identifier: BSD-3-Clause
#include "AverageGeodesicDistance.h"
#include "BenchmarkMesh.h"
#include "MinimumSlicePerimeter.h"
#include "vtkMSPField.h"

#include <vtkNew.h>

using namespace marrow;

namespace
{
void MSP(benchmark::State& state)
{
  const TriangleMesh mesh = bench::PlainMesh(static_cast<int>(state.range(0)));
  SliceField field;
  for (auto _ : state)
  {
    ComputeMinimumSlicePerimeter(mesh, 12, field);
  }
  state.counters["faces"] = mesh.NumberOfTriangles();
}

void AGDSampled(benchmark::State& state)
{
  const TriangleMesh mesh = bench::PlainMesh(static_cast<int>(state.range(0)));
  std::vector<double> values;
  for (auto _ : state)
  {
    ComputeAverageGeodesicDistance(mesh, 64, values);
  }
  state.counters["faces"] = mesh.NumberOfTriangles();
}

void AGDAllPairs(benchmark::State& state)
{
  const TriangleMesh mesh = bench::PlainMesh(static_cast<int>(state.range(0)));
  std::vector<double> values;
  for (auto _ : state)
  {
    ComputeAverageGeodesicDistance(mesh, 0, values);
  }
  state.counters["faces"] = mesh.NumberOfTriangles();
}

void MSPFieldFilter(benchmark::State& state)
{
  const auto mesh = bench::Mesh(static_cast<int>(state.range(0)));
  vtkNew<vtkMSPField> filter;
  filter->SetInputData(mesh);
  for (auto _ : state)
  {
    filter->Modified();
    filter->Update();
  }
  state.counters["faces"] = static_cast<double>(mesh->GetNumberOfPolys());
}
}

BENCHMARK(MSP)->Apply(bench::Sizes);
BENCHMARK(AGDSampled)->Apply(bench::Sizes);
BENCHMARK(AGDAllPairs)->Arg(5000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(MSPFieldFilter)->Apply(bench::Sizes);
