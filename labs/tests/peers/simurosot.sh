#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# simurosot.sh BUILD: each folder in $MIROCUP_PEERS/simurosot, a public team of SimuroSot or Simuro5v5 as it was cloned, is imported,
# built and checked. Prints a line for each. Fails for a team that does not build without a cure being said, and for one that builds
# and is not accepted. A library of others that a team is linked with is no fault of ours.
set -uo pipefail
build=$(realpath "$1")
teams=${MIROCUP_PEERS:-/nowhere}/simurosot
if [ ! -d "$teams" ]; then
  echo "skipped: \$MIROCUP_PEERS has no folder simurosot"
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
bad=0
for team in "$teams"/*/; do
  name=$(basename "$team")
  made=$folder/$name
  log=$folder/$name.log
  if ! "$build/mirocup" new "$made" --from-simurosot "$team" >"$log" 2>&1; then
    result="not imported: $(tail -n 1 "$log")"
  elif (cmake -S "$made" -B "$made/build" -DCMAKE_PREFIX_PATH="$build" && cmake --build "$made/build" -- -k) >"$log" 2>&1; then
    result=$("$build/mirocup" check "$made/build/team.so" --league middle --rules simurosot 2>&1 | tail -n 1)
    [[ $result == *": accepted" ]] || bad=1
  elif grep -q 'undefined reference' "$log"; then
    result="needs a library: $(grep -m 1 -o 'undefined reference to .*' "$log")"
  elif grep -q '^  Cure: ' "$log"; then
    result="needs $(grep -c '^  Cure: ' "$log") cures, which are named"
  else
    result="does not build, and no cure is named"
    bad=1
  fi
  echo "$name: $result"
done
exit $bad
