#!/bin/bash
# The commands of the pages, in a clean Debian 12 that has nothing of what this machine has. By hand, as
# root, with network; it takes an hour, most of it in Testing/run.sh and .ci/run:
#   Testing/CleanRoot/run.sh [PAGE...]
# Every page gets a root and a clone of its own. Of a page's ```sh blocks those lines are run that begin
# with a program of the project or with cmake, ctest or export; the `marrow` commands of the pages are run by
# the test Documentation.Commands.
set -euo pipefail
cd "$(dirname "$0")/../.."

pages=("$@")
if [ ${#pages[@]} -eq 0 ]; then
  pages=(Documentation/quick-start.md Documentation/contributing.md
    Testing/Benchmarks/Segmentation/README.md README.md)
fi
.ci/install-packages.sh debootstrap git
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
debootstrap --variant=minbase bookworm "$work/base" http://deb.debian.org/debian

failed=()
for page in "${pages[@]}"; do
  root=$work/root
  rm -rf "$root"
  cp --archive "$work/base" "$root"
  cp --dereference /etc/resolv.conf "$root/etc/resolv.conf"
  mkdir "$root/marrow"
  git archive HEAD | tar --extract --directory "$root/marrow"
  {
    echo "set -euxo pipefail; cd /marrow"
    awk '/^```sh$/ { shell = 1; next } /^```/ { shell = 0 } shell' "$page" |
      sed 's/ *#.*//' | grep -E '^(Examples/|Testing/|Wrapping/|\.ci/|cmake |ctest |export )' || true
  } >"$root/commands.sh"
  if ! unshare --mount --pid --fork --mount-proc="$root/proc" \
    chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
    bash /commands.sh; then
    failed+=("$page")
  fi
done
if [ ${#failed[@]} -gt 0 ]; then
  echo "Commands failed in: ${failed[*]}" >&2
  exit 1
fi
echo "The commands of these pages run in a clean root: ${pages[*]}"
