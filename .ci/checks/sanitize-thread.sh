#!/bin/bash
# The thread sanitizer over all parallel filters: the tests that run them on several threads, stop them,
# or watch their progress. VTK's backend is STDThread, whose threads the sanitizer can follow; it sees
# neither TBB's scheduler nor its locks. Nothing of VTK needs to be suppressed that way.
set -euo pipefail
cd "$(dirname "$0")/../.."

cmake --preset sanitize-thread
cmake --build build-sanitize-thread --target \
  TestCore TestSources TestMeasures TestSkeleton TestCorrespondence TestTransfer
export VTK_SMP_BACKEND_IN_USE=STDThread VTK_SMP_MAX_THREADS=4 TSAN_OPTIONS=halt_on_error=1
ctest --test-dir build-sanitize-thread --output-on-failure --parallel "$(nproc)" --no-tests=error \
  --label-regex "^(Core|Sources|Measures|Skeleton|Correspondence|Transfer)$" \
  --tests-regex "Thread|SameBits|Stop|Abort|Progress"
