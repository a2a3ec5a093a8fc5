#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Bit for bit: a golden leg must print the hashes in core/golden_hash.txt, one for each preset of the conditions, and reproduce the
# given flat recordings (records.sh).
# Usage: check.sh FOLDER [FLAT...], with the program FOLDER/golden_leg; check.sh --compile COMPILER LEVEL [FLAT...], which builds core
# by this compiler at this level of optimization. The build in build/ is clang++ -O3.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)

if [[ $1 == --compile ]]; then
  kind="$2 $3"
  folder=$root/build/compilers/$2$3
  cmake -S "$root" -B "$folder" -G Ninja -DMIROCUP_CORE_ONLY=ON -DCMAKE_BUILD_TYPE= \
    -DCMAKE_CXX_COMPILER="$2" -DCMAKE_CXX_FLAGS="$3" >/dev/null
  shift 3
  cmake --build "$folder" --target golden_leg $([[ $# -eq 0 ]] || echo verify_flat) >"$folder/log" || { cat "$folder/log"; exit 1; }
else
  kind="this build"
  folder=$1
  shift
fi

bad=0
while read -r expected conditions; do
  hash=$("$folder/golden_leg" "$conditions")
  if [[ $hash == "$expected" ]]; then
    echo "$kind, $conditions: $hash"
  else
    echo "$kind, $conditions: $hash, but core/golden_hash.txt has $expected" >&2
    bad=1
  fi
done <"$root/core/golden_hash.txt"
[[ $# -eq 0 ]] || "$folder/verify_flat" "$@" || bad=1
exit $bad
