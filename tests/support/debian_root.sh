# SPDX-License-Identifier: MIT
#
# shellcheck shell=bash
# A Debian in a folder that is removed at the end. To be sourced by a script of bash:
#   own_mounts "$@"            first: the script starts itself again, as root, where its mounts end with it
#   make_debian 12|13 [TAR]    then: fills $debian, from a mirror ($mirror, if it is set) or a file that mmdebstrap has made
#   inside COMMAND...          runs a command in it as root
#   inside_as UID COMMAND...   runs a command in it as a user without other rights, whose home is /home/UID
# Exit 3, with a sentence, if this computer cannot make one.

no_root() {
  echo "no root of Debian can be made here: $*" >&2
  exit 3
}

own_mounts() {
  [[ -z ${MIROCUP_DEBIAN:-} ]] || { debian=$MIROCUP_DEBIAN/debian; return 0; }
  [[ $(id -u) -eq 0 ]] || no_root "root is needed"
  unshare --mount true 2>/dev/null || no_root "this system allows no mounts"
  local code=0 folder
  folder=$(mktemp -d)
  # shellcheck disable=SC2064  # the folder of now
  trap "rm -rf --one-file-system '$folder'" EXIT
  trap 'exit 130' INT TERM
  # The programs that are left end with it, and so do the mounts.
  MIROCUP_DEBIAN=$folder unshare --mount --pid --fork --kill-child "$0" "$@" || code=$?
  exit "$code"
}

make_debian() {
  local suite=bookworm archives
  [[ $1 != 13 ]] || suite=trixie
  mkdir "$debian"
  if [[ -n ${2:-} ]]; then
    tar -xf "$2" -C "$debian"
  else
    command -v mmdebstrap >/dev/null || no_root "mmdebstrap is missing: cmake/install_packages.sh cmake/packages-install.txt"
    mmdebstrap --quiet --variant=minbase --include=mount "$suite" "$debian" \
      ${mirror:+"deb $mirror $suite main"} || no_root "mmdebstrap $suite failed"
  fi
  # What apt downloads is kept for the next time.
  archives=${XDG_CACHE_HOME:-$HOME/.cache}/mirocup/debian-$1
  mkdir -p "$archives/partial"
  mount --bind "$debian" "$debian"
  mount --bind "$archives" "$debian/var/cache/apt/archives"
  mount -t proc proc "$debian/proc"
  mount --rbind /sys "$debian/sys"
  mount --rbind /dev "$debian/dev"
  mkdir -p "$debian/dev/shm"
  mount -t tmpfs -o mode=1777 shm "$debian/dev/shm"
  cp /etc/resolv.conf "$debian/etc/"
}

# Not a chroot, in which no program may make a namespace of users: the sandbox would be a weaker one.
# shellcheck disable=SC2016
inside() {
  unshare --mount bash -c 'cd "$0" && pivot_root . mnt && umount -l mnt && cd / &&
    exec env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 "$@"' "$debian" "$@"
}

inside_as() {
  local user=$1
  shift
  mkdir -p "$debian/home/$user"
  chown "$user:$user" "$debian/home/$user"
  inside setpriv --reuid "$user" --regid "$user" --clear-groups env HOME="/home/$user" "$@"
}
