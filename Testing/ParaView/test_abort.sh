#!/bin/bash
# A user's clicks: the button beside the progress bar stops a filter, and Apply runs it again. Has a
# display of its own, where ParaView's window always has the same place and size.
set -euo pipefail
here=$(dirname "$0")
if [ "${1:-}" != inside ]; then
  exec xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$0" inside
fi

picture=$MARROW_TEST_OUTPUT/Abort.png
export WINDOW_DONE=$MARROW_TEST_OUTPUT/abort.done
rm -f "$WINDOW_DONE"
PV_PLUGIN_PATH=$(dirname "$MARROW_PLUGIN") "$PARAVIEW_PROGRAMS/paraview" --dr \
  --script="$here/abort.py" &
paraview=$!
trap 'kill -KILL "$paraview" 2>/dev/null || true' EXIT

# Left, top, width and height of the progress bar and of the buttons above the properties.
bar=(0 722 1152 40)
buttons=(0 394 300 60)

# Prints the middle of what is of that colour there on the screen; nothing if there is nothing.
#   middle_of COLOUR LEFT TOP WIDTH HEIGHT
middle_of()
{
  import -window root png:- | convert png:- -crop "$4x$5+$2+$3" +repage txt:- | tr '(),:' '    ' |
    awk -v colour="$1" -v left="$2" -v top="$3" '
      $1 == "#" { next }
      colour == "red" ? $3 > 180 && $4 < 90 && $5 < 90 : $4 > 200 && $4 > $3 + 30 && $4 > $5 + 30 {
        x += $1; y += $2; n++
      }
      END { if (n > 8) print int(left + x / n), int(top + y / n) }'
}

give_up()
{
  import -window root "$picture"
  echo "$1 The screen: $picture" >&2
  exit 1
}

# Waits until it is there, and clicks at it.
#   click COLOUR LEFT TOP WIDTH HEIGHT
click()
{
  local place
  for _ in $(seq 300); do
    kill -0 "$paraview"
    read -r -a place < <(middle_of "$@") || true
    if [ ${#place[@]} -eq 2 ]; then
      echo "A click at what is $1: ${place[*]}"
      xdotool mousemove "${place[@]}" click 1
      return
    fi
    sleep 0.1
  done
  give_up "Nothing is $1 where it should be."
}

shows_segments()
{
  import -window root "$picture"
  "$PARAVIEW_PROGRAMS/pvpython" "$here/check_window.py" "$picture"
}

for _ in $(seq 240); do
  [ ! -e "$WINDOW_DONE" ] || break
  kill -0 "$paraview"
  sleep 0.5
done
# The filter runs at the first rendering. The button is red while it can be pressed.
click red "${bar[@]}"
for _ in $(seq 30); do
  stopped=$(shows_segments || echo yes)
  [[ $stopped != *yes ]] || break
  sleep 0.5
done
[[ $stopped == *yes ]] || give_up "The filter was not stopped."

# Apply is green as soon as it can be pressed.
click green "${buttons[@]}"
for _ in $(seq 600); do
  kill -0 "$paraview"
  if [ -z "$(middle_of red "${bar[@]}")" ] && shows_segments; then
    exit 0
  fi
  sleep 1
done
give_up "The filter has no result after another Apply."
