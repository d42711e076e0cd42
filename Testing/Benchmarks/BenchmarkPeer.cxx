// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMesh.h"
#include "PeerSkeleton.h"

using namespace marrow;

namespace
{
void PeerMeanCurvatureSkeleton(benchmark::State& state)
{
  const TriangleMesh mesh = bench::PlainMesh(static_cast<int>(state.range(0)));
  int size = 0;
  for (auto _ : state)
  {
    size = bench::PeerSkeletonSize(mesh);
  }
  if (size == 0)
  {
    state.SkipWithError("CGAL refuses the mesh");
  }
  state.counters["faces"] = mesh.NumberOfTriangles();
}
}

BENCHMARK(PeerMeanCurvatureSkeleton)->Apply(bench::Sizes);
