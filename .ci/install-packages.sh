#!/bin/bash
# Installs what Debian 12 offers of all that Marrow needs; further packages may be named as arguments.
# Does nothing, and needs neither network nor rights, when all of it is there.
set -euo pipefail

packages=(
  # build; VTK's CMake package also looks for what python3-vtk9 and mpi-default-dev bring
  cmake g++ ninja-build ccache
  libvtk9-dev python3-vtk9 mpi-default-dev libeigen3-dev libboost-graph-dev libdlib-dev libcli11-dev nlohmann-json3-dev
  # the Python package
  python3-numpy
  # tests; what cpack makes Debian packages with
  libgtest-dev dpkg-dev file
  # pictures without a display, and the examples' recipes
  xvfb xauth libgl1-mesa-dri python3
  "$@")

missing=()
for package in "${packages[@]}"; do
  if ! dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null |
    grep -q '^installed$'; then
    missing+=("$package")
  fi
done
if [ ${#missing[@]} -eq 0 ]; then
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  as_root=(sudo)
fi
"${as_root[@]}" apt-get update
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install --yes --no-install-recommends "${missing[@]}"
