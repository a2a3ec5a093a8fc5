#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Plays a knockout by GNU parallel as in docs/hosting-computers.md and checks that its pages are byte-equal to those of a local run.
# Usage: parallel.sh BUILD; exit 77 if there is no GNU parallel.
set -euo pipefail
build=$(realpath "$1")
if ! parallel --version 2>/dev/null | grep -q '^GNU parallel'; then
  echo "skipped: there is no GNU parallel"
  exit 77
fi
base=$(mktemp -d)
trap 'rm -rf "$base"' EXIT

make() {
  mkdir "$base/$1"
  "$build/mirocup" league init "$base/$1/l" --half 1 --seed 3 --format knockout --team a=house:chaser --team b=house:keeper \
    --team c=house:striker --team d=house:idle --team e=house:chaser >/dev/null
}

make here
"$build/mirocup" league start "$base/here/l" >/dev/null 2>&1

make there
rounds=0
while "$build/mirocup" league plan "$base/there/l" >"$base/plan" 2>/dev/null && [[ -s $base/plan ]]; do
  parallel "'$build/mirocup-league'" run-shard "$base/there/l" {} <"$base/plan"
  rounds=$((rounds + 1))
done
[[ $rounds -ge 3 ]]
records=$(ls -l --time-style=full-iso "$base/there/l/records")
"$build/mirocup" league start "$base/there/l" >/dev/null 2>&1
[[ $(ls -l --time-style=full-iso "$base/there/l/records") == "$records" ]] || { echo "a leg was played again" >&2; exit 1; }
diff -r "$base/here/l/site" "$base/there/l/site"
echo "the same pages after $rounds rounds"
