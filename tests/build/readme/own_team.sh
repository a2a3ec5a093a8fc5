#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The README's instructions for a newcomer work as written: its team is built with its one line, beats idle, and the record can
# be verified. Usage: own_team.sh ROOT BUILD
set -euo pipefail
root=$(realpath "$1")
build=$(realpath "$2")
headers="-I'$root'/plugins"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

awk '/^```cpp$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$root/README.md" >"$folder/mine.cpp"
line=$(grep -m1 '^g++ .* mine\.cpp -o mine\.so$' "$root/README.md")
cd "$folder"
eval "${line/-Iplugins/$headers}"
"$build/mirocup" match --blue ./mine.so --yellow idle --half 30 --record leg.json
"$build/mirocup" verify leg.json
grep -q '"winner": "blue"' leg.json
