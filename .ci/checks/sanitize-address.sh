#!/bin/bash
# The C++ tests with the address and undefined behaviour sanitizers; the standard library's own checks
# (_GLIBCXX_ASSERTIONS) and Eigen's assertions are on. CGAL's skeleton is left out: its one file takes
# three minutes and 3 GB to compile with both.
set -euo pipefail
cd "$(dirname "$0")/../.."

cmake --preset sanitize
cmake --build build-sanitize
# Debian's graphics drivers keep memory until the end.
export ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
  ctest --test-dir build-sanitize --output-on-failure --parallel "$(nproc)" \
  --label-exclude "Accuracy|Documentation|Install"
