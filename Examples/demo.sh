#!/bin/bash
# Marrow's main job, from a fresh clone on Debian 12 (as root or with sudo):
#   Examples/demo.sh           the segments of a camel go to a cow, a bull, an elephant,
#                              a triceratops and a diplodocus
#   Examples/demo.sh figures   those of an armadillo go to Homer, a man and a teddy bear
# Installs packages, builds the marrow command, and writes the labelled meshes, the skeletons and two
# pictures into build/demo/.
set -euo pipefail
cd "$(dirname "$0")/.."

set_name=${1:-animals}
case "$set_name" in
  animals)
    source=camel
    targets=(cow bull elephant triceratops diplodocus)
    view=(--up 0 1 0 --from 1 0 0)
    ;;
  figures)
    source=armadillo
    targets=(homer man bear)
    view=(--up 0 1 0 --from 0 0 -1)
    ;;
  *)
    echo "usage: Examples/demo.sh [animals|figures]" >&2
    exit 2
    ;;
esac

.ci/install-packages.sh
cmake --preset release
cmake --build build --target marrow
marrow=build/bin/marrow

meshes=build/demo/meshes
Examples/get-meshes.sh "$meshes"
results=build/demo/$set_name
mkdir -p "$results"

# The labels of the source are our own: a recipe of planes.
Examples/Segments/cut-segments.py \
  "$meshes/$source.off" "Examples/Segments/$source.txt" "$results/$source.seg"

targets_off=("${targets[@]/#/$meshes/}")
"$marrow" transfer "$meshes/$source.off" "${targets_off[@]/%/.off}" \
  --segments "$results/$source.seg" --skeletons -o "$results"

labelled=("$meshes/$source.off")
skeletons=("$results/${source}_skeleton.vtp")
for target in "${targets[@]}"; do
  labelled+=("$results/$target.vtp")
  skeletons+=("$results/${target}_skeleton.vtp")
done
draw() {
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$marrow" render "${labelled[@]}" \
    --segments "$results/$source.seg" "${view[@]}" "$@"
}
draw -o "$results/segments.png"
draw --skeletons "${skeletons[@]}" -o "$results/skeletons.png"

echo
echo "Labelled meshes and skeletons (.vtp) and the two pictures are in $results:"
ls "$results"
