#!/bin/bash
# Makes the Debian packages, on Debian 12 (as root or with sudo), from a clone:
#   Wrapping/Packages/build.sh [FOLDER]
# They are written to FOLDER (default: build-packages/debian). Two builds: marrow-paraview needs ParaView's VTK.
set -euo pipefail
cd "$(dirname "$0")/../.."

folder=$(realpath --canonicalize-missing "${1:-build-packages/debian}")
.ci/install-packages.sh
mkdir -p "$folder"
cmake --preset packages
cmake --build build-packages
(cd build-packages && cpack -B "$folder")

Wrapping/ParaView/get-paraview.sh install-paraview
Wrapping/ParaView/build.sh install-paraview -DMARROW_BUILD_TESTING=OFF
(cd build-paraview && cpack -B "$folder")
rm -r "$folder/_CPack_Packages"
ls "$folder"
