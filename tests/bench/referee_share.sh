#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The referee's share of a tick, in instructions: legs between house teams are played, then verified under valgrind's
# callgrind, where a tick is the match alone. Its tick is observing, simulating, judging, placing and hashing;
# the referee's share is judging, including the work to make a situation of the world. Fails above the bar.
# Usage: referee_share.sh BUILD_FOLDER [HALF_SECONDS]; needs valgrind.
set -euo pipefail
build=$(realpath "$1")
half=${2:-10}
bar=15  # percent of a tick
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Prints the instructions of a function and of all functions that it calls.
instructions() {
  awk -v name="$1" 'index($0, name) { gsub(",", "", $1); print $1; exit }' "$folder/costs"
}

failed=0
for league in small middle large; do
  "$build/mirocup" match --blue striker --yellow chaser --league "$league" --half "$half" \
    --record "$folder/leg.json" > "$folder/played"
  valgrind -q --tool=callgrind --callgrind-out-file="$folder/out" \
    "$build/mirocup" verify "$folder/leg.json" > "$folder/verified"
  callgrind_annotate --inclusive=yes --threshold=100 "$folder/out" > "$folder/costs"
  tick=$(instructions 'mirocup::match::Leg::advance(')
  referee=$(instructions 'mirocup::match::Leg::judge()')
  ticks=$(sed -E 's/.* ([0-9]+) ticks.*/\1/' "$folder/verified")
  awk -v league="$league" -v tick="$tick" -v referee="$referee" -v ticks="$ticks" -v bar="$bar" 'BEGIN {
    share = 100 * referee / tick
    printf "%-6s %7.0f instructions a tick, %6.0f of them the referee: %4.1f %%, %d ticks\n",
           league, tick / ticks, referee / ticks, share, ticks
    exit share > bar
  }' || failed=1
done
exit $failed
