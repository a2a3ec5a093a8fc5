#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Windows is blind to the case of file names and to blanks around them, and takes \ for /. For each name that the sources of an old team include and that Linux
# would not find, this makes a file of that very name which leads to the one that is meant: the team's own, or a stand-in. One more
# file, which the prefix of all sources includes, gives other names to what the team calls like a function of the C library.
#
# forward.sh FORWARD STAND_IN SKIP ROOT FOLDER...: writes below FORWARD and, for names that begin with "../", below the five folders
# above it, which are for nothing else; looks for the team's files below ROOT, but not in SKIP; FOLDERs
# are those where the compiler looks anyway. Prints those of them that have a header with the name of one of the system's: the compiler
# may look there only for #include "...".
set -eu
forward=$1 stand_in=$2 skip=$3 root=$4
shift 4
files=$(mktemp) || exit 1
trap 'rm -f "$files" "$files.includes" "$files.wanted"' EXIT
system=" assert.h ctype.h errno.h float.h limits.h math.h memory.h malloc.h signal.h stdarg.h stddef.h stdint.h stdio.h stdlib.h string.h time.h \
algorithm cmath cstdio cstdlib cstring ctime deque fstream functional iomanip iostream limits list map numeric queue set sstream stack \
string utility vector "

# True if the system has a header of that name.
is_of_the_system() {
  set -- /usr/include/"$1" /usr/include/c++/*/"$1" /usr/include/*-linux-gnu/"$1"
  [ -f "$1" ] || [ -f "$2" ] || [ -f "$3" ]
}

for folder in "$@"; do
  shift
  is_quoted=
  for file in "$folder"/*; do
    is_of_the_system "${file##*/}" && is_quoted=yes && break
  done
  if [ -n "$is_quoted" ]; then printf '%s\n' "$folder"; else set -- "$@" "$folder"; fi
done

lower() {
  printf %s "$1" | LC_ALL=C tr A-Z a-z
}

find "$root" -maxdepth 6 -path "$skip" -prune -o -type f -print | LC_ALL=C grep -aiE '\.(h|hpp|hh|inl|c|cpp|cc|cxx)$' >"$files" || exit 0
# What a line of the sources includes, as it is written there. The last line of a file may have no end, which awk gives it.
tr '\n' '\0' <"$files" | LC_ALL=C xargs -0 awk 1 | LC_ALL=C tr '\r' '\n' |
  LC_ALL=C sed -nE 's/^[ \t]*#[ \t]*(include|import)[ \t]*(["<][^">]*)[">].*/\2/p' | LC_ALL=C sort -u >"$files.includes"
cut -c 2- "$files.includes" | LC_ALL=C sort -u >"$files.wanted"

# Headers of Microsoft's that one of the stand-ins is enough for.
stand_in_for() {
  case $1 in
  afx*.h | atl*.h) echo "$stand_in/afxwin.h" ;;
  ws2*.h | wsock*.h | mswsock.h) echo "$stand_in/winsock2.h" ;;
  new.h) echo "$stand_in/stdafx.h" ;;
  xutility | xmemory | xlocale | xtree | xhash) echo "$stand_in/xstring" ;;
  win*.h | mm*.h | comm*.h | shell*.h | ole*.h | obj*.h | wtypes.h | tlhelp32.h | psapi.h | share.h | dos.h | values.h | comdef.h | \
    basetsd.h | intrin.h | resource.h) echo "$stand_in/windows.h" ;;
  esac
}

# True if a name leads out of the five folders above FORWARD, before its last part or with it.
leaves() {
  printf %s "$1" | LC_ALL=C awk -F / '
    { for (i = 1; i <= NF; i++) { depth += $i == ".." ? -1 : $i != "" && $i != "."; if (depth < -5) leaves = 1 } }
    END { exit !leaves }'
}

while IFS= read -r wanted; do
  plain=$(printf %s "$wanted" | tr '\\' / | sed 's://*:/:g; s:^ *::; s: *$::')
  name=${plain##*/}
  [ -n "$name" ] || continue
  case /$wanted/ in
  //* | */./ | */../) continue ;;
  */../*) ! leaves "$wanted" || continue ;;
  esac
  found=
  for folder in "$@"; do
    [ ! -f "$folder/$wanted" ] || found=$folder/$wanted
  done
  [ -z "$found" ] || continue
  small=$(lower "$name")
  case $system in
  *" $wanted "*) continue ;;
  esac
  real=
  # In < > a name of Windows' own means Windows' header, and not a file of a library that the team ships.
  case $small in
  stdafx.h | targetver.h) ;;
  *) ! LC_ALL=C grep -qxF "<$wanted" "$files.includes" || [ ! -f "$stand_in/$small" ] || real=$stand_in/$small ;;
  esac
  # Where several files have one name, the one in folders of the same names is meant.
  [ -n "$real" ] || real=$(lower "$plain" | LC_ALL=C awk '
    NR == FNR { name = wanted = $0; sub(/.*\//, "", name); sub(/^(\.*\/)*/, "/", wanted); next }
    { n = tolower($0); end = substr(n, length(n) - length(wanted) + 1); sub(/.*\//, "", n) }
    n == name && (first == "" || (end == wanted && !is_best)) { first = $0; is_best = end == wanted }
    END { print first }' - "$files")
  if [ -z "$real" ]; then
    [ ! -f "$stand_in/$wanted" ] || continue
    [ ! -f "$stand_in/$small" ] || real=$stand_in/$small
    [ -n "$real" ] || real=$(stand_in_for "$small")
  fi
  line="#include \"$real\""
  if [ -z "$real" ]; then
    case $system in
    *" $small "*) [ "$small" != "$wanted" ] || continue ;;
    *) [ "$plain" != "$wanted" ] || continue ;;
    esac
    line="#include <$(lower "$plain")>"
  fi
  case $wanted in
  */*) mkdir -p "$forward/${wanted%/*}" ;;
  esac
  printf '%s\n' "$line" >"$forward/$wanted"
done <"$files.wanted"

# Names of the team's own. The C++ headers that it includes are read before: they, and the team's own macros, may have such names, too.
names=$(tr '\n' '\0' <"$files" | LC_ALL=C xargs -0 awk -f "${0%/*}/own_names.awk")
own=$forward/mirocup_own_names.h
: >"$own"
has_macros=$(tr '\n' '\0' <"$files" | LC_ALL=C xargs -0 grep -laE '^[ 	]*#[ 	]*define[ 	]+[a-z_]+\(' | head -n 1) || true
if [ -n "$names$has_macros" ]; then
  while IFS= read -r wanted; do
    case $system in
    *" $wanted "*) printf '#include <%s>\n' "$wanted" >>"$own" ;;
    esac
  done <"$files.wanted"
fi
printf '%s\n' "$names" | while read -r kind name; do
  case $kind in
  function) printf '#define %s mirocup_own_%s\n' "$name" "$name" >>"$own" ;;
  macro) printf '#undef %s\n' "$name" >>"$own" ;;
  esac
done
