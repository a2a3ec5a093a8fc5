#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Feeds inputs of libFuzzer to the readers of what strangers write. Usage: tests/security/fuzz/run.sh [SECONDS [READER...]]
# (for each reader, 600 by default). Builds into build/fuzz. A reader stops at its first input that crashes it or takes 30 s
# or 2 GB, which is what the sanitizers make of 2 s and 512 MB, and the input is kept in build/fuzz/finds. At the end the release
# build reads all inputs that were kept, with 2 s and 512 MB for each. Exits with 1 after any find.
set -euo pipefail
cd "$(dirname "$0")/../../.."
seconds=${1:-600}
shift || true
all=(archive drill elf firasim http journal league names npz pitch record recording replay scene situation thoughts trace)
# Bytes that an input may have: as many as the reader takes, and 64 KiB of what comes over a network. Files of 256 MiB
# would take all the memory that a reader may use here.
declare -A most=([archive]=32 [drill]=4 [elf]=32 [journal]=32 [league]=4 [names]=32 [npz]=32 [pitch]=4 [record]=32
  [recording]=32 [replay]=32 [scene]=32 [situation]=4 [thoughts]=32 [trace]=32)  # MiB
readers=("$@")
[ ${#readers[@]} -gt 0 ] || readers=("${all[@]}")

cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --target "${readers[@]/%/_fuzz}"
cmake --preset release >/dev/null
cmake --build --preset release --target fuzz_corpus labs_fuzz_corpus mirocup house_idle mirocup-plugin-host
corpus=build/fuzz/corpus
mkdir -p build/fuzz/finds
tests/security/fuzz/seeds.py build "$corpus"
found=0
for reader in "${readers[@]}"; do
  echo "== $reader"
  alone=()
  # A network without other programs, where the system allows it.
  if [ "$reader" = http ] && unshare -rn true 2>/dev/null; then
    alone=(unshare -rn sh -c 'ip link set lo up && exec "$@"' sh)
  fi
  max_len=$(((${most[$reader]:-0} << 20) + 65536))
  "${alone[@]}" "build/fuzz/${reader}_fuzz" -max_total_time="$seconds" -max_len="$max_len" -timeout=30 -rss_limit_mb=2048 \
    -artifact_prefix="build/fuzz/finds/$reader-" -print_final_stats=1 "$corpus/$reader" || found=1
done
for program in fuzz_corpus labs_fuzz_corpus; do
  "build/$program" "$corpus" || found=1
done
exit $found
