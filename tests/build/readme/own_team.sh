#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The README's instructions for a newcomer work as written: its team is built with its one line, beats idle, and the record can
# be verified. examples/tuning/mine.cpp is that team, move for move. Usage: own_team.sh ROOT BUILD
set -euo pipefail
root=$(realpath "$1")
build=$(realpath "$2")
headers="-I'$root'/plugins"
tuned_source="'$root'/examples/tuning/mine.cpp"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

awk '/^```cpp$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$root/README.md" >"$folder/mine.cpp"
line=$(grep -m1 '^g++ .* mine\.cpp -o mine\.so$' "$root/README.md")
cd "$folder"
eval "${line/-Iplugins/$headers}"
"$build/mirocup" match --blue ./mine.so --yellow idle --half 30 --record leg.json
"$build/mirocup" verify leg.json
grep -q '"winner": "blue"' leg.json

tuned=${line/mine.cpp -o mine.so/$tuned_source -o tuned.so}
eval "${tuned/-Iplugins/$headers}"
hash_of() {
  "$build/mirocup" match --blue "$1" --yellow chaser --half 30 --hash | grep -o 'state hash .*'
}
[[ $(hash_of ./mine.so) == "$(hash_of ./tuned.so)" ]] || {
  echo "own_team: with its defaults, examples/tuning/mine.cpp plays otherwise than README's team" >&2
  exit 1
}
