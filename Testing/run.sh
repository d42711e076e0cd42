#!/bin/bash
# Builds Marrow and passes its tests, from a fresh clone on Debian 12 (as root or with sudo):
#   Testing/run.sh [arguments for cmake]
# Installs packages first. The pictures of the tests are drawn in a private X server.
set -euo pipefail
cd "$(dirname "$0")/.."

.ci/install-packages.sh
cmake --preset release "$@"
cmake --build build
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
  ctest --test-dir build --output-on-failure --parallel "$(nproc)"

# The plugin, in a build of its own with ParaView's VTK.
.ci/install-packages.sh imagemagick xdotool
Wrapping/ParaView/get-paraview.sh install-paraview
Wrapping/ParaView/build.sh install-paraview -DMARROW_BUILD_TESTING=ON "$@"
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
  ctest --test-dir build-paraview --output-on-failure --parallel "$(nproc)"
