#!/bin/bash
# Marrow with the VTK of a newer Debian: compiles it and runs the tests of the filters, the pictures and the
# command. By hand, as root, with network; it takes an hour on two cores:
#   Testing/CleanRoot/newer-vtk.sh [SUITE]
# SUITE is trixie (Debian 13, VTK 9.3; the default) or a later one.
set -euo pipefail
cd "$(dirname "$0")/../.."

.ci/install-packages.sh git
suite=${1:-trixie}
source Testing/CleanRoot/roots.sh
fresh_root
mkdir "$root/marrow"
git archive HEAD | tar --extract --directory "$root/marrow"
cat >"$root/build.sh" <<'END'
set -euxo pipefail
cd /marrow
.ci/install-packages.sh
cmake --preset release -DMARROW_USE_CGAL=OFF -DMARROW_BUILD_EXAMPLES=OFF
cmake --build build
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
  ctest --test-dir build --output-on-failure --parallel "$(nproc)" --label-regex \
  '^(CommandLine|Core|Correspondence|Creatures|Evaluation|IO|Measures|Rendering|Skeleton|Surface|Transfer)$'
END
in_root /build.sh
echo "Marrow compiles and works with the VTK of Debian's $suite."
