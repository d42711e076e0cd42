# What the scripts of this folder share: clean roots of Debian 12, or of $suite, for `source`. They need root
# and network.
.ci/install-packages.sh debootstrap
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
debootstrap --variant=minbase "${suite:-bookworm}" "$work/base" http://deb.debian.org/debian
# These roots are thrown away, so dpkg need not wait for the disk.
echo force-unsafe-io >"$work/base/etc/dpkg/dpkg.cfg.d/force-unsafe-io"

# Makes $work/root, instead of the one before.
fresh_root()
{
  root=$work/root
  rm -rf "$root"
  cp --archive "$work/base" "$root"
  cp --dereference /etc/resolv.conf "$root/etc/resolv.conf"
}

# in_root SCRIPT: runs a bash script of the root, as root there, with nothing of this machine's environment.
in_root()
{
  unshare --mount --pid --fork --mount-proc="$root/proc" \
    chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 bash "$1"
}
