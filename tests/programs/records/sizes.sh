#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Checks the files of a leg of ten minutes: record at most 100 KB, replay 2 MB, page 3 MB. Prints the sizes for a leg of each
# league; exit code 1 if one is larger. Usage: sizes.sh BUILD [LEAGUE...] (all leagues by default)
set -euo pipefail
build=$(cd "$1" && pwd)
shift
leagues=("$@")
[[ ${#leagues[@]} -gt 0 ]] || leagues=(small middle large)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
bad=0

at_most() {
  local size
  size=$(stat --format %s "$2")
  printf '  %-7s %8d bytes of %8d\n' "$1" "$size" "$3"
  [[ $size -le $3 ]] || bad=1
}

for league in "${leagues[@]}"; do
  leg=$folder/$league
  "$build/mirocup" match --blue striker --yellow chaser --league "$league" --half 300 --rule mercy_goal_diff=0 --record "$leg.json"
  "$build/mirocup" replay "$leg.json" -o "$leg.html" >/dev/null
  at_most record "$leg.json" 100000
  at_most replay "$leg.replay.zst" 2000000
  at_most page "$leg.html" 3000000
done
exit $bad
