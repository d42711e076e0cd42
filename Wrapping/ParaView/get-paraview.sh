#!/bin/bash
# Puts Debian 12's ParaView 5.11, with what is needed to build plugins for it, into a folder:
#   Wrapping/ParaView/get-paraview.sh FOLDER
# Beside the system and not into it: python3-paraview and the python3-vtk9 of Marrow's other build
# exclude each other. FOLDER/usr/bin/paraview and FOLDER/usr/bin/pvpython run from there.
set -euo pipefail
cd "$(dirname "$0")/../.."

folder=$(realpath --canonicalize-missing "$1")
# What ParaView's own packages would draw in: libraries, and NumPy for its Python. Qt's headers for what
# the plugin does in ParaView's window.
runtime=(
  libavcodec59 libavformat59 libavutil57 libdouble-conversion3 libexpat1 libfreetype6 libgdal32
  libgl2ps1.4 libglew2.2 libhdf5-openmpi-103-1 libjpeg62-turbo liblz4-1 liblzma5 libnetcdf19 libogg0
  libopengl0 libopenmpi3 libpng16-16 libpython3.11 libqt5core5a libqt5gui5 libqt5help5 libqt5network5
  libqt5opengl5 libqt5svg5 libqt5widgets5 libswscale6 libtheora0 libtiff6 libxcursor1 libxml2
  python3-numpy qtbase5-dev)
.ci/install-packages.sh "${runtime[@]}"
if [ -e "$folder/.complete" ]; then
  exit 0
fi

packages=(paraview paraview-dev python3-paraview)
download=$(mktemp -d)
trap 'rm -rf "$download"' EXIT
# apt fetches as the user _apt, who must be able to write here.
chmod 777 "$download"
cd "$download"
if ! apt-get download "${packages[@]}"; then
  # The lists of packages are missing or old, as in a fresh container.
  "$([ "$(id -u)" -eq 0 ] && echo env || echo sudo)" apt-get update
  apt-get download "${packages[@]}"
fi
mkdir -p "$folder"
for package in ./*.deb; do
  dpkg --extract "$package" "$folder"
done
touch "$folder/.complete"
