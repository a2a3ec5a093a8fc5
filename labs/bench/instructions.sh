#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Instructions of a tick, counted by callgrind: unlike time, they do not depend on the load of the machine.
# Usage: labs/bench/instructions.sh [BUILD [SCENE...]]; prints thousands a tick, a row for each engine and point.
set -euo pipefail
build=$(realpath "${1:-build}")
scenes=("${@:2}")
[[ ${#scenes[@]} -gt 0 ]] || scenes=(quiet game game_5 game_11 jam scrum)
command -v valgrind >/dev/null || { echo "instructions.sh: valgrind is not installed" >&2; exit 3; }
counts=$(mktemp)
trap 'rm -f "$counts"' EXIT

# count ENGINE POINT SCENE
count() {
  local ticks instructions
  ticks=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect='mirocup::bench::play_timed*' \
    --log-file="$counts" "$build/mirocup-bench" --scene "$3" --engine "$1" --point "$2" | tail -n 1)
  instructions=$(sed -n 's/.*Collected : //p' "$counts")
  awk "BEGIN { printf \"%11.1f\", $instructions / $ticks / 1000 }"
}

printf '%-30s' "thousand instructions a tick"
printf '%11s' "${scenes[@]}"
echo
while IFS=: read -r engine point; do
  "$build/mirocup-bench" --scene pinch --engine "$engine" --point "$point" >/dev/null 2>&1 || continue  # not built in
  printf '%-30s' "$engine, $point"
  for scene in "${scenes[@]}"; do
    count "$engine" "$point" "$scene"
  done
  echo
done <<'POINTS'
mirocup:coarse
mirocup:standard
Box2D, all bullets:1 ms
Box2D, all bullets:4 ms
Box2D, ball bullet:1 ms
Chipmunk:1 ms
Chipmunk:4 ms
ODE:1 ms
MuJoCo:1 ms
POINTS
