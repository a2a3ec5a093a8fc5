#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Bit for bit: the golden leg of this build, and of core built by other compilers and at other levels, must print the
# hashes in core/golden_hash.txt, one for each preset of the conditions, and reproduce the given flat recordings. Usage: check.sh GOLDEN_LEG [FLAT...]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
bad=0

golden_leg=$1
shift

compare() {
  local hash expected conditions
  while read -r expected conditions; do
    hash=$("$2" "$conditions")
    if [[ $hash == "$expected" ]]; then
      echo "$1, $conditions: $hash"
    else
      echo "$1, $conditions: $hash, but core/golden_hash.txt has $expected" >&2
      bad=1
    fi
  done <"$root/core/golden_hash.txt"
}

compare "this build" "$golden_leg"
[[ $# -eq 0 ]] || "$(dirname "$golden_leg")/verify_flat" "$@" || bad=1
for kind in "g++ -O0" "clang++ -O0" "clang++ -O3"; do  # this build is g++ -O3
  read -r compiler level <<<"$kind"
  build=$root/build/compilers/$compiler$level
  cmake -S "$root" -B "$build" -G Ninja -DMIROCUP_CORE_ONLY=ON -DCMAKE_BUILD_TYPE= \
    -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$level" >/dev/null
  cmake --build "$build" --target golden_leg $([[ $# -eq 0 ]] || echo verify_flat) >/dev/null
  compare "$kind" "$build/golden_leg"
  [[ $# -eq 0 ]] || "$build/verify_flat" "$@" || bad=1
done
exit $bad
