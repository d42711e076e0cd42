#!/bin/bash
# Marrow in ParaView, from a fresh clone on Debian 12 (as root or with sudo):
#   Wrapping/ParaView/install.sh [FOLDER]
# Gets Debian's ParaView 5.11 into FOLDER (default: install-paraview), builds the plugin and installs
# it there, so that this ParaView loads it by itself. Then draws a picture through it: the segments of
# a camel, carried to a cow. May be called again after an update of the clone.
set -euo pipefail
cd "$(dirname "$0")/../.."

folder=$(realpath --canonicalize-missing "${1:-install-paraview}")
.ci/install-packages.sh
Wrapping/ParaView/get-paraview.sh "$folder"
Wrapping/ParaView/build.sh "$folder" -DMARROW_BUILD_TESTING=OFF
cmake --install build-paraview --component plugin
plugins=$folder/usr/lib/$(gcc -print-multiarch)/paraview-5.11/plugins
# Where this ParaView's programs look for plugins to load at their start.
ln --symbolic --force --no-dereference --relative "$plugins/Marrow" "$folder/usr/bin/plugins"

meshes=build-paraview/meshes
picture=$folder/camel-to-cow.png
Examples/get-meshes.sh "$meshes"
Examples/Segments/cut-segments.py "$meshes/camel.off" Examples/Segments/camel.txt "$meshes/camel.seg"
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$folder/usr/bin/pvpython" \
  Examples/ParaView/transfer.py "$meshes/camel.off" "$meshes/camel.seg" "$meshes/cow.off" "$picture"

echo
echo "The picture:        $picture"
echo "The plugin:         $plugins/Marrow/Marrow.so"
echo "ParaView with it:   $folder/usr/bin/paraview"
echo "Another ParaView 5.11 of Debian 12 loads it when started so:"
echo "  PV_PLUGIN_PATH=$plugins/Marrow paraview"
