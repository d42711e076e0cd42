// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMesh.h"
#include "MeanCurvatureSkeleton.h"

using namespace marrow;

namespace
{
void PeerMeanCurvatureSkeleton(benchmark::State& state)
{
  const TriangleMesh mesh = bench::PlainMesh(static_cast<int>(state.range(0)));
  std::string error;
  for (auto _ : state)
  {
    Skeleton skeleton;
    error = ComputeMeanCurvatureSkeleton(mesh, {}, skeleton, {});
  }
  if (!error.empty())
  {
    state.SkipWithError(error.c_str());
  }
  state.counters["faces"] = mesh.NumberOfTriangles();
}
}

BENCHMARK(PeerMeanCurvatureSkeleton)->Apply(bench::Sizes)->Arg(200000);
