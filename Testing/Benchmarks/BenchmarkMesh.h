// SPDX-License-Identifier: BSD-3-Clause
#ifndef marrow_BenchmarkMesh_h
#define marrow_BenchmarkMesh_h

#include "TriangleMesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <benchmark/benchmark.h>

namespace marrow::bench
{
/// The sizes at which every stage is measured.
inline void Sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->Arg(5000)->Arg(20000)->Arg(50000)->Unit(benchmark::kMillisecond)->UseRealTime();
}

/// The OFF file that MARROW_BENCHMARK_MESH names, reduced to about `faces` triangles, or a
/// procedural biped of that many. Made once per size.
vtkSmartPointer<vtkPolyData> Mesh(int faces);

/// The same as a plain mesh with its connectivity.
TriangleMesh PlainMesh(int faces);
}

#endif
