#!/bin/bash
# The C++ tests of the parallel filters with the thread sanitizer, on four threads. VTK's backend is
# STDThread, whose threads the sanitizer can follow; it sees neither TBB's scheduler nor its locks.
set -euo pipefail
cd "$(dirname "$0")/../.."

cmake --preset sanitize-thread
cmake --build build-sanitize-thread
export VTK_SMP_BACKEND_IN_USE=STDThread VTK_SMP_MAX_THREADS=4
export TSAN_OPTIONS="halt_on_error=1 suppressions=$PWD/.ci/checks/thread-suppressions.txt"
ctest --test-dir build-sanitize-thread --output-on-failure --parallel "$(nproc)" \
  --label-regex "^(Core|Creatures|IO|Surface|Measures|Skeleton|Correspondence|Transfer|Collection|Evaluation)$"
