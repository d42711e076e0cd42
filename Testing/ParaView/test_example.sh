#!/bin/bash
# The example of a transfer runs on real meshes, and its picture shows something.
set -euo pipefail
source_folder=$MARROW_SOURCE
meshes=$MARROW_TEST_OUTPUT/../meshes
picture=$MARROW_TEST_OUTPUT/example.png
rm -f "$picture"
"$source_folder/Examples/get-meshes.sh" "$meshes"
"$source_folder/Examples/Segments/cut-segments.py" "$meshes/camel.off" \
  "$source_folder/Examples/Segments/camel.txt" "$meshes/camel.seg"
PV_PLUGIN_PATH=$(dirname "$MARROW_PLUGIN") "$PARAVIEW_PROGRAMS/pvpython" \
  "$source_folder/Examples/ParaView/transfer.py" \
  "$meshes/camel.off" "$meshes/camel.seg" "$meshes/cow.off" "$picture"
colours=$(identify -format %k "$picture")
echo "The picture has $colours colours."
[ "$colours" -gt 1000 ]
