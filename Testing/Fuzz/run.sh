#!/bin/bash
# Runs every fuzzer, or those of the named formats, for so many seconds, one after the other:
#   cmake --preset fuzz && cmake --build --preset fuzz && Testing/Fuzz/run.sh 1800 [FORMAT...]
# Several formats at a time: start it several times.
# What is found stays in build-fuzz/corpus (Testing/Fuzz/add-found.sh takes the best of it) and, if it fails, in
# build-fuzz/failures.
set -euo pipefail
cd "$(dirname "$0")/../.."

seconds=${1:?"usage: Testing/Fuzz/run.sh SECONDS [FORMAT...]"}
formats=("${@:2}")
if [ ${#formats[@]} -eq 0 ]; then
  formats=(off ply obj stl seg vtk vtp)
fi
failures=build-fuzz/failures
mkdir -p "$failures"
for format in "${formats[@]}"; do
  found=build-fuzz/corpus/$format
  seeds=build-fuzz/seeds/$format
  mkdir -p "$found" "$seeds"
  find Testing/Data/Corpus -name "*.$format" -exec cp -t "$seeds" {} +
  # VTK's own memory is no concern of ours: no leak check, but a limit.
  ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 \
    "build-fuzz/bin/fuzz-$format" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -max_len=4096 -artifact_prefix="$failures/$format-" -print_final_stats=1 "$found" "$seeds"
done
