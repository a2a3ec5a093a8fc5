#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes the packages and tries them in a Debian 12 that has nothing else: install, play, check, teams in three languages, a
# league with its units, uninstall. Needs root, mmdebstrap, lintian, dpkg-dev and a mirror of Debian.
# Usage: tests/install/run.sh [--mirror URL] [--packages FOLDER] [--debian TAR]
#   --debian TAR       a Debian that mmdebstrap has made before
#   --packages FOLDER  tries the packages in there, and builds none: those of tests/release/reproducible.sh -o FOLDER
#
# Catches a package that forgets a file or a dependency, one that works only beside the sources or only if it can write below
# /usr, a package that lintian complains of, a unit that systemd does not take, and a removal that takes a league with it.
set -euo pipefail
root=$(realpath "$(dirname "$0")/../..")
mirror=
folder=
archive=
arguments=("$@")
while [[ $# -gt 0 ]]; do
  case $1 in
    --mirror) mirror=$2; shift 2 ;;
    --packages) folder=$(realpath "$2"); shift 2 ;;
    --debian) archive=$(realpath "$2"); shift 2 ;;
    *) echo "usage: $0 [--mirror URL] [--build DIR] [--debian TAR]" >&2; exit 2 ;;
  esac
done
for tool in lintian dpkg-shlibdeps; do
  command -v "$tool" >/dev/null || { echo "$tool is missing: cmake/install_packages.sh cmake/packages-install.txt" >&2; exit 3; }
done
. "$root/tests/support/debian_root.sh"
own_mounts "${arguments[@]}"

step() { echo "== $*"; }

step "packages"
cd "$root"
if [[ -z $folder ]]; then
  folder=$root/build/packages
  cmake --preset packages >/dev/null
  cmake --build --preset packages
  rm -f "$folder"/*.deb
  (cd "$folder" && cpack -G DEB)
fi
packages=("$folder"/*.deb)
[[ ${#packages[@]} -eq 5 ]]

step "lintian"
lintian --allow-root --fail-on error,warning "${packages[@]}"

step "a Debian 12 with nothing else"
make_debian 12 "$archive"
mkdir "$debian/packages"
cp "${packages[@]}" "$debian/packages/"
as_student() { inside_as 1500 sh -ec "cd /home/1500; $*"; }

step "install"
inside apt-get -qq update
inside sh -ec 'DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends install systemd man-db >/var/log/install.log'
inside sh -ec 'DEBIAN_FRONTEND=noninteractive apt-get -qq -y --no-install-recommends install /packages/*.deb openssl >>/var/log/install.log'
[[ $(inside stat -c %U /srv/mirocup) == mirocup ]] || { echo "the units have no user and no folder" >&2; exit 1; }
mount --bind "$debian/usr" "$debian/usr"
mount -o remount,ro,bind "$debian/usr"

step "play, with a tree that nobody can write to"
as_student mirocup match --blue chaser --yellow striker --half 20 --record leg.json
as_student mirocup verify leg.json
as_student mirocup replay leg.json
as_student mirocup drill touch-the-ball striker --tries 2

step "a team in each language"
for language in c++ c python; do
  as_student "mirocup new $language --language $language"
  if [[ $language == python ]]; then
    as_student "./python/test"
  else
    as_student "cd $language; cmake --workflow --preset team"
  fi
done
as_student "mirocup check c/build/team.so && mirocup match --blue python/team.py --yellow c++/build/team.so --half 20"
as_student "PYTHONPATH= python3 -c 'import mirocup.team; print(mirocup.team.__file__)'"

step "a league by its units"
as_student "mirocup league init spring --team alpha=c/build/team.so --team snake=python/team.py --team rock=house:idle --half 5"
as_student "mirocup league start spring && mirocup league publish spring"
as_student 'for record in spring/records/*.json; do mirocup verify "$record"; done'
for unit in mirocup-league@spring.service mirocup-night@spring.service mirocup-night@spring.timer \
  mirocup-health@spring.service mirocup-health@spring.timer; do
  inside systemd-analyze verify "$unit"
done
tests/build/units/check.sh "$debian/usr/lib/systemd/system"

step "the manual and completion"
inside sh -ec 'man -w mirocup mirocup-match mirocup-league-start mirocup-tune'
inside bash -ec '. /usr/share/bash-completion/completions/mirocup
  COMP_WORDS=(mirocup match --league ""); COMP_CWORD=3; _mirocup; [[ "${COMPREPLY[*]}" == *middle* ]]'

step "uninstall"
umount "$debian/usr"
inside sh -ec 'apt-get -qq -y purge mirocup mirocup-dev python3-mirocup mirocup-labs mirocup-doc >/dev/null'
[[ -f $debian/home/1500/spring/journal.jsonl ]]
left=$(find "$debian/usr" "$debian/etc" -name '*mirocup*' -not -path '*/etc/mirocup')  # ports that the host has chosen
[[ -z $left ]] || { echo "left behind: $left" >&2; exit 1; }
echo "all is well"
