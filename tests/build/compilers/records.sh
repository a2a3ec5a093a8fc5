#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Bit for bit, with legs of real teams: records of the release build, under each preset of the rules, the conditions and the pitch, must be
# reproduced by core as other compilers, other levels and arm64 build it. Takes some minutes, so it is a command of its own.
# Usage: records.sh BUILD [RECORD...]; without records it plays sixteen. arm64 is left out where check_arm64.sh cannot run.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

records=("$@")
if [[ ${#records[@]} -eq 0 ]]; then
  "$here/sixteen_legs.sh" "$build" "$folder"
  records=("$folder"/*.json)
fi
flat=()
for record in "${records[@]}"; do
  flat+=("$folder/$(basename "$record" .json).flat")
  "$build/flatten" "$record" "${flat[-1]}"
done
"$here/check.sh" "$build" "${flat[@]}"
for kind in "g++ -O0" "g++ -O3" "clang++ -O0"; do
  # shellcheck disable=SC2086
  "$here/check.sh" --compile $kind "${flat[@]}"
done
"$here/check_arm64.sh" "${flat[@]}" || { code=$?; [[ $code -eq 3 ]] || exit "$code"; }
