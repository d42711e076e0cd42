#!/bin/bash
# Which lines the C++ tests run: the total, and the files that are run least, into the log.
set -euo pipefail
cd "$(dirname "$0")/../.."

cmake --preset coverage
cmake --build build-coverage
find build-coverage -name '*.gcda' -delete
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
  ctest --test-dir build-coverage --output-on-failure --parallel "$(nproc)" \
  --label-exclude "Accuracy|Documentation|Install"
lcov --quiet --capture --directory build-coverage --base-directory "$PWD" --no-external \
  --output-file build-coverage/all.info
lcov --quiet --extract build-coverage/all.info \
  "$PWD/Filters/*" "$PWD/Rendering/*" "$PWD/Wrapping/*" --output-file build-coverage/coverage.info
lcov --summary build-coverage/coverage.info
echo "The files with the smallest share of lines that a test runs:"
lcov --list build-coverage/coverage.info --list-full-path |
  grep -oE '^\S+\.(cxx|h) *\|[ 0-9.]+%' | sort -t '|' -k 2 -n | head -n 15
