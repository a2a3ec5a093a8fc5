#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The time of a class league: house teams with changed numbers play a double round robin of legs of two minutes.
# Usage: class_league.sh BUILD [TEAMS]; 30 teams play 870 legs, 8 play 56. Prints time on the clock, processor time of a leg, and
# its parts: start and end (a leg of almost no play), play in this process (--trusted), and what the sandbox adds.
set -euo pipefail
build=$(realpath "$1")
teams=${2:-30}
source=$(realpath "$(dirname "$0")/../..")
base=$(mktemp -d)
trap 'rm -rf "$base"' EXIT

# Makes every number below 1 in a house team's source some percent larger or smaller.
variant() {
  awk -v by="$2" '{ while (match($0, /[^0-9.]0\.[0-9]+/)) {
      printf "%s%.4f", substr($0, 1, RSTART), by * substr($0, RSTART + 1, RLENGTH - 1)
      $0 = substr($0, RSTART + RLENGTH) } print }' "$source/plugins/house/$1.cpp"
}
list=()
houses=(striker chaser keeper)
for i in $(seq "$teams"); do
  variant "${houses[i % 3]}" "$(awk -v i="$i" 'BEGIN { print 0.85 + 0.01 * i }')" >"$base/t$i.cpp"
  g++ -std=c++20 -O2 -fPIC -shared -I"$source/plugins/include" "$base/t$i.cpp" -o "$base/t$i.so"
  list+=(--team "t$i=$base/t$i.so")
done
"$build/mirocup" league init "$base/l" --half 60 --seed 1 "${list[@]}"

# cpu WORDS...: user and system time of a command, in seconds.
cpu() {
  local TIMEFORMAT='%U %S'
  { time "$@" >/dev/null 2>&1; } 2>&1 | awk '{ printf "%.3f", $1 + $2 }'
}
begin=$(date +%s.%N)
all=$(cpu "$build/mirocup" league start "$base/l")
end=$(date +%s.%N)
legs=$(grep -c '"kind":"leg"' "$base/l/journal.jsonl")
awk -v legs="$legs" -v all="$all" -v clock="$(echo "$end $begin" | awk '{ print $1 - $2 }')" 'BEGIN {
  printf "%d legs: %.1f s on the clock, %.1f s of processors, %.3f s a leg with its page\n", legs, clock, all, all / legs
  printf "870 legs on two processors that do nothing else: %.0f s\n", 870 * all / legs / 2 }'

# mean of ten legs: WORDS...
mean() {
  local sum=0
  for seed in $(seq 10); do
    sum=$(echo "$sum $(cpu "$build/mirocup" match --blue "$base/t1.so" --yellow "$base/t2.so" --seed "$seed" --record "$base/r.json" "$@")" |
      awk '{ print $1 + $2 }')
  done
  echo "$sum" | awk '{ printf "%.3f", $1 / 10 }'
}
echo "a leg: $(mean --half 60) s; of almost no play: $(mean --half 0.1) s; --trusted: $(mean --half 60 --trusted) s;" \
  "its page: $(cpu "$build/mirocup" replay "$base/r.json" --no-times -o "$base/r.html") s"
