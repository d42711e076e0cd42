#!/bin/bash
# ParaView's window with the plugin loaded and the filter applied, as seen from outside. Has a display
# of its own, so that no other window gets into the picture.
set -euo pipefail
here=$(dirname "$0")
if [ "${1:-}" != inside ]; then
  exec xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$0" inside
fi

picture=$MARROW_TEST_OUTPUT/Window.png
done_file=$MARROW_TEST_OUTPUT/window.done
rm -f "$picture" "$done_file"
export WINDOW_DONE=$done_file
# ParaView loads the plugin by itself from there.
PV_PLUGIN_PATH=$(dirname "$MARROW_PLUGIN") "$PARAVIEW_PROGRAMS/paraview" --dr \
  --script="$here/window.py" &
paraview=$!
trap 'kill -KILL "$paraview" 2>/dev/null || true' EXIT
for _ in $(seq 240); do
  [ ! -e "$done_file" ] || break
  kill -0 "$paraview"
  sleep 0.5
done
[ -e "$done_file" ] || { echo "ParaView's window did not come up." >&2; exit 1; }
sleep 3
import -window root "$picture"
"$PARAVIEW_PROGRAMS/pvpython" "$here/check_window.py" "$picture"
