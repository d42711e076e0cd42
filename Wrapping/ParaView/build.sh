#!/bin/bash
# Builds the plugin in build-paraview/ against the ParaView that get-paraview.sh put into a folder:
#   Wrapping/ParaView/build.sh FOLDER [arguments for cmake]
set -euo pipefail
cd "$(dirname "$0")/../.."

folder=$(realpath "$1")
shift
libraries=lib/$(gcc -print-multiarch)
cmake --preset paraview "-DParaView_DIR=$folder/usr/$libraries/cmake/paraview-5.11" \
  "-DCMAKE_INSTALL_PREFIX=$folder/usr" "-DCMAKE_INSTALL_LIBDIR=$libraries" "$@"
cmake --build build-paraview
