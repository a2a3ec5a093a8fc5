#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Runs a compiler (its command line is the arguments) and, where it fails, says of what Visual C++ took and g++ does not: file, line
# and what to write there.
messages=$(mktemp) || exit 1
trap 'rm -f "$messages"' EXIT
LC_ALL=C "$@" 2>"$messages"
status=$?
cat "$messages" >&2
[ $status -eq 0 ] || LC_ALL=C awk -f "${0%/*}/cures.awk" "$messages" >&2
exit $status
