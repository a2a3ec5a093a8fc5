#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Runs a compiler (its command line is the arguments) and, where it fails, says of what Visual C++ took and g++ does not: file, line
# and what to write there. With --header FILE in front of the compiler, the source is the adapter, which includes this header: if the
# header does not compile by itself, that is said, and not what follows from it.
header=
if [ "$1" = --header ]; then
  header=$2
  shift 2
fi
messages=$(mktemp) || exit 1
trap 'rm -f "$messages" "$messages.header"' EXIT
LC_ALL=C "$@" 2>"$messages"
status=$?
if [ $status -ne 0 ] && [ -n "$header" ] &&
  ! LC_ALL=C "$@" -fsyntax-only -DMIROCUP_SIMUROSOT_HEADER_ALONE 2>"$messages.header"; then
  cat "$messages.header" >&2
  echo "$header: this header does not compile by itself." >&2
  echo "  Cure: in CMakeLists.txt, give after PRELUDE the header that declares what it needs. If no file here declares that, this is no team." >&2
  exit $status
fi
cat "$messages" >&2
[ $status -eq 0 ] || LC_ALL=C awk -f "${0%/*}/cures.awk" "$messages" >&2
exit $status
