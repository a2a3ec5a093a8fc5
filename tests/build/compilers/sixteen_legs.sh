#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Plays sixteen legs over all leagues, rules, conditions and pitches into FOLDER, as records of the release build. Usage:
# sixteen_legs.sh BUILD FOLDER.
set -euo pipefail
build=$1
folder=$2

play() {
  local name=$1 blue=$2 yellow=$3
  shift 3
  "$build/mirocup" match --blue "$blue" --yellow "$yellow" --record "$folder/$name.json" "$@" >/dev/null
}

play small-mirosot striker chaser --half 20 --seed 1
play small-simurosot chaser keeper --rules simurosot --half 10 --seed 2
play small-vsss striker keeper --rules vsss --half 20 --seed 3
play middle-mirosot striker chaser --league middle --half 10 --seed 4
play middle-simurosot keeper striker --league middle --rules simurosot --half 5 --seed 5
play middle-vsss chaser striker --league middle --rules vsss --half 10 --seed 6
play large-mirosot striker chaser --league large --half 4 --seed 7
play large-vsss keeper chaser --league large --rules vsss --half 4 --seed 8
play golden-goal striker idle --stage knockout --half 1 --rule golden_goal_s=60 --seed 9
play shoot-out striker keeper --stage knockout --half 1 --rule golden_goal_s=0 --rule attempt_s=5 --seed 10
play small-exact navigator striker --conditions exact --half 20 --seed 11
play small-camera striker navigator --conditions camera --half 20 --seed 12
play middle-camera navigator chaser --conditions camera --league middle --half 10 --seed 13
play pitch-mirosot striker navigator --pitch mirosot --half 10 --seed 14
play pitch-vsss striker chaser --pitch vsss --rules vsss --half 10 --seed 15
play pitch-simurosot chaser striker --pitch simurosot --rules simurosot --half 10 --seed 16
