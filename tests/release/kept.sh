#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# What was built and written by a former release of this minor version must go on: a library and a team in Python play the same leg,
# bit for bit, their record verifies, and a league continues where it stopped. Usage: kept.sh BUILD
# Catches a change of strategy.h, of the simulator, or of a file's format that docs/interfaces.md does not allow within 0.1.
# `kept.sh BUILD --make` makes tests/release/kept anew. After the release of 0.1.0 only 0.2 may do this.
set -euo pipefail
kept=$(realpath "$(dirname "$0")")/kept
build=$(realpath "$1")
[[ $(uname -m) == x86_64 ]] || { echo "the kept library is for x86-64"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mirocup() { "$build/mirocup" "$@"; }
play() { mirocup match --blue "$1" --yellow "$2" --conditions camera --half 10 --seed 1 --record "$3"; }
state_hash() { sed -n 's/^ *"state_hash": "\(.*\)".*/\1/p' "$1"; }

if [[ ${2:-} == --make ]]; then
  rm -rf "$kept" && mkdir "$kept"
  strip -o "$kept/team.so" "$build/house/striker.so"
  mirocup new python --language python && cp python/team.py "$kept/"
  play "$kept/team.so" "$kept/team.py" "$kept/leg.json"
  cd "$kept"  # league.json names no folder of this computer
  mirocup league init league --format nightly --half 2 --team library=team.so --team python=team.py --team idle=house:idle
  mirocup league nightly league
  rm -rf league/{site,programs,.lock,.running,.submitting}
  exit
fi

play "$kept/team.so" "$kept/team.py" leg.json
[[ $(state_hash leg.json) == "$(state_hash "$kept/leg.json")" ]] || { echo "the kept library plays another leg"; exit 1; }
mirocup verify "$kept/leg.json"
cp -r "$kept/league" .
mirocup league verify league
mirocup league nightly league --another
mirocup league publish league
[[ $(grep -c '"kind":"leg"' league/journal.jsonl) -gt $(grep -c '"kind":"leg"' "$kept/league/journal.jsonl") ]]
