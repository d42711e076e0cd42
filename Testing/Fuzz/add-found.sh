#!/bin/bash
# Adds to Testing/Data/Corpus/Found the fewest of the files that the fuzzers of all or the named formats found
# (Testing/Fuzz/run.sh) with which the corpus reaches all code that they reached:
#   Testing/Fuzz/add-found.sh [FORMAT...]
set -euo pipefail
cd "$(dirname "$0")/../.."

formats=("$@")
if [ ${#formats[@]} -eq 0 ]; then
  formats=(off ply obj stl seg vtk vtp)
fi
covered=$(mktemp -d)
trap 'rm -rf "$covered"' EXIT
mkdir -p Testing/Data/Corpus/Found
for format in "${formats[@]}"; do
  rm -rf "${covered:?}"/*
  find Testing/Data/Corpus -name "*.$format" -exec cp -t "$covered" {} +
  # Code reached is what counts, not how often: the corpus stays small.
  ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 \
    "build-fuzz/bin/fuzz-$format" -merge=1 -use_counters=0 -timeout=10 -rss_limit_mb=4096 \
    "$covered" "build-fuzz/corpus/$format"
  # The fuzzer's names are hashes without an ending; a few of their letters do.
  find "$covered" -type f ! -name '*.*' -printf '%f\n' | while read -r name; do
    cp "$covered/$name" "Testing/Data/Corpus/Found/${name:0:10}.$format"
  done
done
