#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# labs/examples/tuning/mine.cpp is the README's team with numbers to tune: with their defaults both play the same leg, move for move.
# Usage: example.sh ROOT BUILD
set -euo pipefail
root=$(realpath "$1")
build=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

awk '/^```cpp$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$root/README.md" >"$folder/mine.cpp"
line=$(grep -m1 '^g++ .* mine\.cpp -o mine\.so$' "$root/README.md")
headers="-I'$root'/plugins"
tuned="'$root'/labs/examples/tuning/mine.cpp -o tuned.so"
line=${line/-Iplugins/$headers}
cd "$folder"
eval "$line"
eval "${line/mine.cpp -o mine.so/$tuned}"
hash_of() {
  "$build/mirocup" match --blue "$1" --yellow chaser --half 30 --hash | grep -o 'state hash .*'
}
[[ $(hash_of ./mine.so) == "$(hash_of ./tuned.so)" ]] || {
  echo "example: with its defaults, labs/examples/tuning/mine.cpp plays otherwise than README's team" >&2
  exit 1
}
