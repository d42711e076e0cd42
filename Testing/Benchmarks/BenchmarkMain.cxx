// SPDX-License-Identifier: BSD-3-Clause
#include <vtkSMPTools.h>

#include <benchmark/benchmark.h>

#include <cstdlib>

/// Runs on one thread, as the baseline does, or on MARROW_BENCHMARK_THREADS of them.
int main(int argc, char** argv)
{
  const char* threads = std::getenv("MARROW_BENCHMARK_THREADS");
  vtkSMPTools::Initialize(threads ? std::atoi(threads) : 1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    return 1;
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
