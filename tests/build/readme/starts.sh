#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# README's team and `mirocup new` in C++, C and Python are one team: they give the same wheel commands in whole legs, at both ends
# and in two leagues, in more than 10 000 observations. Catches a start that plays otherwise, a skill that C or Python calls with
# other arguments than C++, and a compile line of a page that does not build. Usage: starts.sh ROOT BUILD
set -euo pipefail
root=$(realpath "$1")
build=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# The lines of the pages begin at the root of the sources and at build.
ln -s "$root/plugins" plugins
ln -s "$build" build

for language in c++ c python; do
  build/mirocup new "our $language" --language "$language" >/dev/null
done
grep -q '"our c++"' "our c++/team.cpp" || { echo "starts: a project is not named after its folder" >&2; exit 1; }
mkdir readme
awk '/^```cpp$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$root/README.md" >readme/mine.cpp
sed 1d "our c++/team.cpp" | sed 's/"our c++"/"mine"/' | diff - readme/mine.cpp

cpp=$(grep -m1 '^g++ .* mine\.cpp -o mine\.so$' "$root/README.md")
c=$(tr -s '\n *' ' ' <"$root/plugins/include/mirocup/skills.h" | grep -o 'gcc .* mine.c .* -o mine.so')
eval "${cpp/mine.cpp -o mine.so/readme/mine.cpp -o readme.so}"
eval "$(sed 's/ mine.c / "our c\/team.c" /; s/-o mine.so/-o c.so/' <<<"$c")"
teams=(./readme.so ./c.so)
[[ -e build/mirocup-python-host ]] && teams+=("./our python/team.py")

ticks=0
for leg in "3 --half 90 --seed 1 --yellow striker --blue" "3 --half 90 --seed 2 --blue chaser --yellow" \
  "11 --half 20 --seed 3 --league large --yellow navigator --blue"; do
  expected=
  for team in "${teams[@]}"; do
    # shellcheck disable=SC2086
    build/mirocup match ${leg#* } "$team" --record leg.json >/dev/null
    # The commands of every tick, and how the leg ended.
    now=$(python3 -c 'import json; r = json.load(open("leg.json")); print(r["ticks"], r["replay"]["sha256"], r["state_hash"])')
    : "${expected:=$now}"
    [[ $now == "$expected" ]] || {
      printf 'starts: %s plays another leg than README (%s):\n%s\n%s\n' "$team" "$leg" "$now" "$expected" >&2
      exit 1
    }
  done
  ticks=$((ticks + ${expected%% *}))
done
echo "${#teams[@]} teams, $ticks observations"
[[ $ticks -ge 10000 ]]
