#!/bin/bash
# cppcheck over all C++ sources. It reads no header of VTK or GoogleTest: the macros that stand where it
# expects a statement or a function are given to it here.
set -euo pipefail
cd "$(dirname "$0")/../.."

include=$(find Filters Rendering Wrapping Testing -name Private -type d -printf '-I%p ')
# shellcheck disable=SC2086
git ls-files '*.cxx' | cppcheck --file-list=- --quiet --error-exitcode=1 -j "$(nproc)" \
  --enable=warning,performance,portability --std=c++17 --language=c++ \
  --suppressions-list=.ci/checks/cppcheck-suppressions.txt $include \
  '-DTEST(a,b)=void a##_##b()' '-DTEST_F(a,b)=void a##_##b()' '-DTEST_P(a,b)=void a##_##b()' \
  '-DVTK_SIZEHINT(size)=' '-DvtkErrorMacro(text)=(void)0' '-DvtkWarningMacro(text)=(void)0'
