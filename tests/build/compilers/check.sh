#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Bit for bit: the golden leg of this build, and of core built by other compilers and at other levels, must print the
# hashes in core/golden_hash.txt, one for each preset of the conditions, and reproduce the given flat recordings. Usage: check.sh
# GOLDEN_LEG [FLAT...]. This build is g++ -O3. With recordings (records.sh, which ./check --all runs) clang++ -O0 must, too: ./check
# has clang++ at -O2, as its debug build.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)

# Usage: compare KIND PROGRAM "HASH CONDITIONS"
compare() {
  local expected=${3% *} conditions=${3#* } hash
  hash=$("$2" "$conditions")
  if [[ $hash == "$expected" ]]; then
    echo "$1, $conditions: $hash"
  else
    echo "$1, $conditions: $hash, but core/golden_hash.txt has $expected" >&2
    return 1
  fi
}

# Usage: check KIND FOLDER [FLAT...]
check() {
  local kind=$1 build=$2 expected bad=0
  shift 2
  while read -r expected; do
    compare "$kind" "$build/golden_leg" "$expected" || bad=1
  done <"$root/core/golden_hash.txt"
  [[ $# -eq 0 ]] || "$build/verify_flat" "$@" || bad=1
  return $bad
}

# Usage: build KIND [FLAT...], where KIND is a compiler and a level. Core is one source, so each kind is built by one process.
build() {
  local kind=$1 compiler level
  shift
  read -r compiler level <<<"$kind"
  local build=$root/build/compilers/$compiler$level
  cmake -S "$root" -B "$build" -G Ninja -DMIROCUP_CORE_ONLY=ON -DCMAKE_BUILD_TYPE= \
    -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$level" >/dev/null &&
    { cmake --build "$build" --target golden_leg $([[ $# -eq 0 ]] || echo verify_flat) >"$build/log" || ! cat "$build/log"; } &&
    check "$kind" "$build" "$@"
}

golden_leg=$1
shift
running=()
check "this build" "$(dirname "$golden_leg")" "$@" &
running+=($!)
kinds=("g++ -O0" "clang++ -O3")
[[ $# -eq 0 ]] || kinds+=("clang++ -O0")
for kind in "${kinds[@]}"; do
  build "$kind" "$@" &
  running+=($!)
done
bad=0
for process in "${running[@]}"; do
  wait "$process" || bad=1
done
exit $bad
