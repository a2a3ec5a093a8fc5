#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Bit for bit on arm64: builds core and the golden leg for aarch64, runs it under qemu and compares with core/golden_hash.txt; the flat
# recordings that are named must be reproduced. Takes some minutes, so it is a command of its own and no test.
# Usage: check_arm64.sh [FLAT...]; exit 3 if a Debian package is missing.
# Installs nothing; needs: g++-aarch64-linux-gnu, qemu-user, and what core is built with anyway.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)

for program in aarch64-linux-gnu-g++ qemu-aarch64; do
  command -v "$program" >/dev/null || {
    echo "$program is missing; Debian packages: g++-aarch64-linux-gnu qemu-user" >&2
    exit 3
  }
done

bad=0
for level in -O0 -O3; do
  build=$root/build/compilers/aarch64$level
  # Only headers of this machine are used: those of Eigen, expected and GoogleTest are the same everywhere.
  cmake -S "$root" -B "$build" -G Ninja -DMIROCUP_CORE_ONLY=ON -DCMAKE_BUILD_TYPE= \
    -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 \
    -DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ \
    -DCMAKE_CXX_FLAGS="$level" >/dev/null
  cmake --build "$build" --target golden_leg verify_flat >/dev/null
  while read -r expected conditions; do
    hash=$(qemu-aarch64 -L /usr/aarch64-linux-gnu "$build/golden_leg" "$conditions" </dev/null)
    if [[ $hash == "$expected" ]]; then
      echo "aarch64 $level, $conditions: $hash"
    else
      echo "aarch64 $level, $conditions: $hash, but core/golden_hash.txt has $expected" >&2
      bad=1
    fi
  done <"$root/core/golden_hash.txt"
  [[ $# -eq 0 ]] || qemu-aarch64 -L /usr/aarch64-linux-gnu "$build/verify_flat" "$@" || bad=1
done
exit $bad
