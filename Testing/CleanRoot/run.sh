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
.ci/install-packages.sh git
source Testing/CleanRoot/roots.sh

failed=()
for page in "${pages[@]}"; do
  fresh_root
  mkdir "$root/marrow"
  git archive HEAD | tar --extract --directory "$root/marrow"
  {
    echo "set -euxo pipefail; cd /marrow"
    awk '/^```sh$/ { shell = 1; next } /^```/ { shell = 0 } shell' "$page" |
      sed 's/ *#.*//' | grep -E '^(Examples/|Testing/|Wrapping/|\.ci/|cmake |ctest |export )' || true
  } >"$root/commands.sh"
  if ! in_root /commands.sh; then
    failed+=("$page")
  fi
done
if [ ${#failed[@]} -gt 0 ]; then
  echo "Commands failed in: ${failed[*]}" >&2
  exit 1
fi
echo "The commands of these pages run in a clean root: ${pages[*]}"
