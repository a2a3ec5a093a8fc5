#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Windows is blind to the case of file names and takes \ for /. For each name that the sources of an old team include and that Linux
# would not find, this makes a file of that very name which leads to the one that is meant: the team's own, or a stand-in.
#
# forward.sh FORWARD STAND_IN SKIP ROOT FOLDER...: writes below FORWARD; looks for the team's files below ROOT, but not in SKIP; FOLDERs
# are those where the compiler looks anyway.
set -eu
forward=$1 stand_in=$2 skip=$3 root=$4
shift 4
files=$(mktemp) || exit 1
trap 'rm -f "$files" "$files.wanted"' EXIT
system=" assert.h ctype.h errno.h float.h limits.h math.h memory.h malloc.h signal.h stdarg.h stddef.h stdint.h stdio.h stdlib.h string.h time.h \
algorithm cmath cstdio cstdlib cstring ctime deque fstream iomanip iostream list map queue set sstream stack string utility vector "

lower() {
  printf %s "$1" | LC_ALL=C tr A-Z a-z
}

find "$root" -maxdepth 6 -path "$skip" -prune -o -type f -print | LC_ALL=C grep -aiE '\.(h|hpp|hh|inl|c|cpp|cc|cxx)$' >"$files" || exit 0
# What a line of the sources includes, as it is written there. The last line of a file may have no end, which awk gives it.
tr '\n' '\0' <"$files" | LC_ALL=C xargs -0 awk 1 | LC_ALL=C tr '\r' '\n' |
  LC_ALL=C sed -nE 's/^[ \t]*#[ \t]*(include|import)[ \t]*["<]([^">]*)[">].*/\2/p' | LC_ALL=C sort -u >"$files.wanted"

while IFS= read -r wanted; do
  plain=$(printf %s "$wanted" | tr '\\' / | sed 's://*:/:g')
  name=${plain##*/}
  [ -n "$name" ] || continue
  case /$wanted/ in
  //* | */../*/../*/../*/../*) continue ;;
  esac
  found=
  for folder in "$@"; do
    [ ! -f "$folder/$wanted" ] || found=$folder/$wanted
  done
  [ -z "$found" ] || continue
  small=$(lower "$name")
  real=$(LC_ALL=C awk -v name="$small" '{ n = tolower($0); sub(/.*\//, "", n); if (n == name) { print; exit } }' "$files")
  if [ -z "$real" ]; then
    [ ! -f "$stand_in/$wanted" ] || continue
    [ ! -f "$stand_in/$small" ] || real=$stand_in/$small
  fi
  line="#include \"$real\""
  if [ -z "$real" ]; then
    case $system in
    *" $small "*) [ "$small" != "$wanted" ] || continue ;;
    *) continue ;;
    esac
    line="#include <$small>"
  fi
  case $wanted in
  */*) mkdir -p "$forward/${wanted%/*}" ;;
  esac
  printf '%s\n' "$line" >"$forward/$wanted"
done <"$files.wanted"
