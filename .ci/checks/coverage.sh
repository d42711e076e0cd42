#!/bin/bash
# Which lines the C++ tests run: the total, and the files that are run least, into the log. Fails where the
# total is below FLOOR percent, two below what is reached: less means that tests are gone, or that code came
# without any.
set -euo pipefail
cd "$(dirname "$0")/../.."
FLOOR=95

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
summary=$(lcov --summary build-coverage/coverage.info)
echo "$summary"
echo "The files with the smallest share of lines that a test runs:"
lcov --list build-coverage/coverage.info --list-full-path |
  grep -oE '^\S+\.(cxx|h) *\|[ 0-9.]+%' | sort -t '|' -k 2 -n | head -n 15
lines=$(grep -oP 'lines\.+: \K[0-9.]+' <<<"$summary")
if awk "BEGIN { exit !($lines < $FLOOR) }"; then
  echo "coverage: the tests run $lines % of the lines; at least $FLOOR % are asked" >&2
  exit 1
fi
