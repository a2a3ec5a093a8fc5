#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Feeds inputs of libFuzzer to the readers of records and replays. Usage: tests/security/fuzz/run.sh [SECONDS] (for each
# reader, 600 by default). Builds into build/fuzz (build/mirocup plays the seeds). Stops at the first input that crashes a
# reader, and keeps the input there.
set -euo pipefail
cd "$(dirname "$0")/../../.."
seconds=${1:-600}

cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --target record_fuzz replay_fuzz
cmake --preset release >/dev/null
cmake --build --preset release --target play
seeds=build/fuzz/seeds
mkdir -p "$seeds" build/fuzz/corpus/{record,replay}
build/mirocup match --blue idle --yellow idle --half 1 --record "$seeds/leg.json"
cp "$seeds/leg.json" build/fuzz/corpus/record/
{ printf '\0'; cat "$seeds/leg.replay.zst"; } >build/fuzz/corpus/replay/leg
# The uncompressed content of the zstd frame after the first line; the harness compresses it again.
{ printf '\4'; tail -n +2 "$seeds/leg.replay.zst" | zstd -dcq; } >build/fuzz/corpus/replay/unpacked
for reader in record replay; do
  build/fuzz/${reader}_fuzz -max_total_time="$seconds" -max_len=65536 -artifact_prefix=build/fuzz/ \
    -print_final_stats=1 "build/fuzz/corpus/$reader"
done
