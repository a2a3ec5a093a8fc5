#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Plays two hundred short legs of every kind and verifies their records: house teams in all leagues, presets and stages,
# every hostile team, teams over DDS, and all endings that a team or a rule can cause. It takes some minutes, so the test
# suite does not run it. Usage: many.sh BUILD [FOLDER]; the records stay in FOLDER, if one is named. Exit code 1 if a record
# does not verify or does not fit the schema.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
if [[ $# -gt 1 ]]; then
  mkdir -p "$2"
  folder=$(cd "$2" && pwd)
else
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
fi
mirocup=$build/mirocup
id=many-$$

# play NAME BLUE YELLOW OPTION...: one leg.
play() {
  local name=$1 blue=$2 yellow=$3
  shift 3
  "$mirocup" match --blue "$blue" --yellow "$yellow" --record "$folder/$name.json" "$@" >"$folder/$name.out" 2>&1 ||
    echo "$name: mirocup match ends with $?: $(tail -1 "$folder/$name.out")" >&2
}

# over_dds NAME BLUE YELLOW OPTION...: one leg, blue over the network.
over_dds() {
  local name=$1 blue=$2 yellow=$3
  shift 3
  "$mirocup" join --match "$id-$name" --team blue --name remote "$build/house/$blue.so" >/dev/null 2>&1 &
  play "$name" dds:remote "$yellow" --match "$id-$name" "$@"
  wait
}

house=(striker chaser keeper idle)
for league in small middle large; do
  for rules in mirosot simurosot vsss; do
    for stage in group knockout; do
      for seed in 1 2 3 4; do
        play "house-$league-$rules-$stage-$seed" "${house[seed % 3]}" "${house[seed % 4]}" --league "$league" \
          --rules "$rules" --stage "$stage" --seed "$seed" --half 4 --rule golden_goal_s=3 --rule attempt_s=2 \
          --rule shoot_out_most_rounds=4
      done
    done
  done
done
for seed in 1 2 3 4 5 6 7 8; do
  play "mercy-$seed" striker idle --seed "$seed" --half 60 --rule mercy_goal_diff=1
  play "golden-goal-$seed" striker idle --seed "$seed" --stage knockout --half 1 --rule golden_goal_s=120
  play "shoot-out-$seed" striker keeper --seed "$seed" --stage knockout --half 1 --rule golden_goal_s=0
  over_dds "dds-$seed" striker chaser --seed "$seed" --half 5
done
play forfeit-none "$build/teams/gives_up.so" chaser --half 5
play forfeit-both "$build/teams/gives_up.so" "$build/teams/gives_up.so" --half 5
for library in "$build"/hostile/*.so; do
  play "hostile-$(basename "$library" .so)" "$library" chaser --half 2
done

shopt -s nullglob
records=("$folder"/*.json)
bad=0
fit=yes
for record in "${records[@]}"; do
  "$mirocup" verify "$record" >"$folder/verify.out" 2>&1 || {
    cat "$folder/verify.out" >&2
    bad=$((bad + 1))
  }
done
grep -ho '"end": "[a-z_]*"' "${records[@]}" | sort | uniq -c
"$here/schema.py" "$here/../../../record/record.schema.json" "${records[@]}" || fit=no
echo "${#records[@]} records, $((${#records[@]} - bad)) verified"
[[ ${#records[@]} -ge 200 && $bad -eq 0 && $fit == yes ]]
