#!/bin/bash
# Plants one fault after the other in a throw-away copy of the sources and sees that the check that is there
# for it fails and says what is wrong: a check that passes whatever it is given helps nobody. The faults of
# the checks that need no build are always tried, the others, in a build of the copy, with
#   .ci/checks/planted-faults.sh --build
set -euo pipefail
cd "$(dirname "$0")/../.."

copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
git ls-files -z | xargs -0 cp --parents -t "$copy"
cd "$copy"
# The checks ask git which files there are.
git init --quiet
git add --all
missed=0

# expect CHECK MESSAGE COMMAND...: the command fails and prints MESSAGE, a regular expression. The fault has
# been planted before, and is taken back.
expect() {
  local check=$1 message=$2 output
  shift 2
  if git diff --quiet; then
    echo "MISSED  $check: the fault was not planted, what it changes is written otherwise now" >&2
    missed=1
  elif output=$("$@" 2>&1); then
    echo "MISSED  $check: passes" >&2
    missed=1
  elif ! grep -qE "$message" <<<"$output"; then
    echo "MISSED  $check: fails, but for another reason:" >&2
    tail -n 20 <<<"$output" >&2
    missed=1
  else
    echo "seen    $check: $(grep -m 1 -E "$message" <<<"$output")"
  fi
  git checkout --quiet .
}

# append FILE LINE...: at the end of the file.
append() {
  printf '%s\n' "${@:2}" >>"$1"
}

formatted() {
  git ls-files '*.h' '*.cxx' | xargs clang-format --dry-run --Werror
}

echo '#include <vtkPolyData.h>' >>Filters/Surface/Private/HoleFilling.cxx
expect "layers, VTK in an algorithm" "HoleFilling.cxx:.*vtkPolyData" .ci/check-layers.sh
echo '#include <Eigen/Core>' >>Filters/Skeleton/vtkMSPSkeleton.h
expect "layers, a backend in a public header" "Eigen/Core" .ci/check-layers.sh
echo '#include "TriangleMesh.h"' >>Filters/Skeleton/vtkMSPSkeleton.h
expect "layers, a private header in a public one" "TriangleMesh.h" .ci/check-layers.sh
append Filters/IO/FileContent.cxx '#if VTK_MAJOR_VERSION > 9' '#endif'
expect "layers, VTK's version outside of its header" "FileContent.cxx:.*VTK_MAJOR" .ci/check-layers.sh
append Filters/Core/Private/Constants.h 'int  twoSpaces( );'
expect "clang-format" "Constants.h:.*clang-format" formatted
# The letters are apart so that codespell passes here.
append README.md "Is re""cieved."
expect "codespell" "re""cieved ==> received" codespell
append Filters/Core/Private/SkeletonFrame.cxx 'double Bare(double x) { return 0.37 * x; }'
expect "numbers, one without a name" "SkeletonFrame.cxx:.*0.37 has no name" .ci/checks/numbers.py
append Filters/Core/Private/SkeletonFrame.cxx '' 'constexpr double WithoutReason = 0.37;'
expect "numbers, one without a reason" "WithoutReason has no reason" .ci/checks/numbers.py
append Filters/Core/Private/SkeletonFrame.cxx 'int PastTheEnd() { int row[2] = { 0, 1 }; return row[2]; }'
expect "cppcheck" "SkeletonFrame.cxx:.*out of bounds" .ci/checks/cppcheck.sh

if [ "${1:-}" != --build ]; then
  exit $missed
fi

# run PRESET TARGET [ARGUMENTS]: builds a test program in the copy and starts it.
run() {
  local folder=build-$1
  if [ "$1" = release ]; then
    folder=build
  fi
  cmake --preset "$1" >/dev/null && cmake --build "$folder" --target "$2" >/dev/null &&
    "$folder/bin/$2" "${@:3}"
}
# ctest by name, in the copy's build.
tests() {
  cmake --build build >/dev/null && ctest --test-dir build --output-on-failure --tests-regex "$1"
}

cmake --preset release -DCMAKE_COMPILE_WARNING_AS_ERROR=ON >/dev/null
echo 'static int NobodyCalls() { return 1; }' >>Filters/Core/Private/SkeletonFrame.cxx
expect "warnings" "error: .*NobodyCalls.*defined but not used" \
  ninja -C build Filters/Core/CMakeFiles/Core.dir/Private/SkeletonFrame.cxx.o
# Without the option the compiler cache has all that the clone compiled.
cmake --preset release -DCMAKE_COMPILE_WARNING_AS_ERROR=OFF >/dev/null
cmake --build build --target Core >/dev/null
echo 'int snake_case() { return 1; }' >>Filters/Core/Private/SkeletonFrame.cxx
expect "clang-tidy" "error: invalid case style for function 'snake_case'" \
  .ci/checks/tidy.py Filters/Core/Private/SkeletonFrame.cxx

sed -i 's|this->Area(t) / 3.0|this->Area(t) / 2.0|' Filters/Core/Private/TriangleMesh.cxx
expect "unit tests" "FAILED.*TriangleMesh" run release TestCore
sed -i 's|\(numberOfPoints = .*Points.size())\);|\1 + 1000000;|' Filters/IO/Private/ObjFile.cxx
expect "fuzz corpus" "FAILED.*Corpus" run release TestIO --gtest_filter='Corpus.*'

sed -i 's|  return areas;|  areas.data()[areas.size()] = 0.0; return areas;|' Filters/Core/Private/TriangleMesh.cxx
expect "address sanitizer" "AddressSanitizer: heap-buffer-overflow" run sanitize TestCore
sed -i '/^void TriangleMesh::BuildConnectivity/,/^}/s|^{|{ int most = 2147483647; most += this->NumberOfTriangles(); this->Opposite.reserve(most < 0);|' \
  Filters/Core/Private/TriangleMesh.cxx
expect "undefined behaviour sanitizer" "runtime error: signed integer overflow" run sanitize TestCore
sed -i 's|    { body(|    { static int calls = 0; ++calls; body(|' Filters/Core/Private/ParallelFor.cxx
VTK_SMP_BACKEND_IN_USE=STDThread VTK_SMP_MAX_THREADS=4 TSAN_OPTIONS=halt_on_error=1 \
  expect "thread sanitizer" "WARNING: ThreadSanitizer: data race" run sanitize-thread TestMeasures
# All tests are gone but those of one folder.
sed -i 's/--label-exclude ".*"/--label-regex "^Core$"/' .ci/checks/coverage.sh
expect "coverage" "coverage: the tests run .* at least" .ci/checks/coverage.sh

cmake --build build >/dev/null
sed -i '0,/-> Array:/s//-> int:/' Wrapping/Python/marrow/_arrays.py
expect "mypy" "error: Incompatible return value" tests '^Python.types$'
sed -i '0,/ \* @sa /s// * @nosuchcommand @sa /' Filters/Transfer/vtkSegmentationTransfer.h
expect "doxygen" "Found unknown command" tests '^Documentation.Api$'
# The target's vertices are carried the wrong way along the source.
sed -i 's/mesh.Points\[v\] + transform.col(3)/mesh.Points[v] - transform.col(3)/' \
  Filters/DenseCorrespondence/Private/DenseMap.cxx
expect "accuracy gate" "pairs are below their thresholds" tests '^(Data.meshes|Accuracy.segments|Accuracy.camel)$'
exit $missed
