#!/bin/bash
# Puts the meshes of Debian's package libcgal-demo into a folder:
#   Examples/get-meshes.sh FOLDER
# Takes them from the installed package if it is there; else downloads it without installing it,
# which also works where the machine leaves out /usr/share/doc.
set -euo pipefail

folder=$1
as_root=$([ "$(id -u)" -eq 0 ] && echo env || echo sudo)
if [ -e "$folder/camel.off" ]; then
  exit 0
fi
mkdir -p "$folder"
archive=/usr/share/doc/libcgal-dev/data.tar.gz
if [ ! -e "$archive" ]; then
  package=$(mktemp -d)
  trap 'rm -rf "$package"' EXIT
  # apt fetches as the user _apt, who must be able to write here.
  chmod 777 "$package"
  cd "$package"
  if ! apt-get download libcgal-demo; then
    # The lists of packages are missing or old, as in a fresh container.
    "$as_root" apt-get update
    apt-get download libcgal-demo
  fi
  dpkg --extract libcgal-demo_*.deb content
  cd - >/dev/null
  archive=$package/content$archive
fi
tar --extract --gzip --file "$archive" --directory "$folder" --strip-components=2 data/meshes
