#!/bin/bash
# The Debian packages, installed, used and removed in a clean Debian 12. By hand, as root, with network; it
# takes some minutes:
#   Testing/CleanRoot/packages.sh
# Whoever uses a package needs no compiler: the first two roots have none.
set -euo pipefail
cd "$(dirname "$0")/../.."

Wrapping/Packages/build.sh
.ci/install-packages.sh
meshes=build-packages/meshes
Examples/get-meshes.sh "$meshes"
Examples/Segments/cut-segments.py "$meshes/camel.off" Examples/Segments/camel.txt "$meshes/camel.seg"
source Testing/CleanRoot/roots.sh

# use WHAT: runs the script of the standard input in a fresh root that has the packages and two meshes.
use()
{
  echo "== $1"
  fresh_root
  mkdir "$root/test"
  cp build-packages/debian/*.deb "$meshes"/{camel.off,camel.seg,cow.off} Examples/ParaView/transfer.py \
    "$root/test"
  cp --recursive Testing/Consumer "$root/test/consumer"
  {
    cat <<'END'
set -euxo pipefail
cd /test
export DEBIAN_FRONTEND=noninteractive
install()
{
  apt-get install --yes --no-install-recommends "$@" >/dev/null
}
# Debian's ParaView draws one in, by matplotlib and scipy.
remove_compiler()
{
  rm --force /usr/bin/{cc,c++,gcc,g++,cpp}*
}
# Nothing may stay behind that has our name.
remove()
{
  apt-get purge --yes "$@" >/dev/null
  [ -z "$(find / -xdev -path /test -prune -o -path /proc -prune -o -iname '*marrow*' -print | tee /dev/stderr)" ]
}
apt-get update >/dev/null
END
    cat
  } >"$root/test/use.sh"
  in_root /test/use.sh
}

use "the command and the Python package" <<'END'
install ./libmarrow_*.deb ./marrow_*.deb ./python3-marrow_*.deb
remove_compiler
marrow --version
marrow transfer camel.off cow.off --segments camel.seg -o cow.seg
python3 -c "import marrow"
python3 - <<'PYTHON'
import marrow
camel = marrow.read("camel.off", segments="camel.seg")
cow = marrow.transfer(camel, marrow.read("cow.off"))
by_command = marrow.read("cow.off", segments="cow.seg")
assert len(set(cow.segments)) > 4 and (cow.segments == by_command.segments).all()
PYTHON
remove marrow python3-marrow libmarrow
END

use "ParaView's plugin" <<'END'
install ./marrow-paraview_*.deb xvfb xauth libgl1-mesa-dri
remove_compiler
plugin=$(dpkg -L marrow-paraview | grep '/Marrow\.so$')
for program in pvpython pvbatch; do
  PV_PLUGIN_PATH=$(dirname "$plugin") xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
    $program transfer.py camel.off camel.seg cow.off $program.png
  [ -s $program.png ]
done
pvpython - <<'PYTHON'
import marrow
camel = marrow.read("camel.off", segments="camel.seg")
assert len(set(marrow.transfer(camel, marrow.read("cow.off")).segments)) > 4
PYTHON
remove marrow-paraview
END

use "a program against libmarrow-dev" <<'END'
install ./libmarrow_*.deb ./libmarrow-dev_*.deb cmake g++ make
cmake -S consumer -B consumer/build
cmake --build consumer/build
consumer/build/consumer
remove libmarrow-dev libmarrow
END
echo "The packages can be installed, used and removed in a clean root."
