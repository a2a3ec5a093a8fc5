#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# fast_dds.sh BUILD: idl/mirocup.idl is read as it stands by the compiler of eProsima's Fast DDS, and a client of that (fast_dds.cpp)
# plays a leg in lock-step, in which each tick has its answer, and one in real time. Exit 77 without Debian's packages libfastrtps-dev
# and fastddsgen, which bring Java.
set -euo pipefail
build=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
if ! command -v fastddsgen >/dev/null || [ ! -e /usr/include/fastdds/dds/domain/DomainParticipant.hpp ]; then
  echo "skipped: libfastrtps-dev and fastddsgen are not installed"
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cp "$here/../../idl/mirocup.idl" .
fastddsgen mirocup.idl >generated.log 2>&1 || { cat generated.log; exit 1; }
g++ -std=c++17 -O1 -w -I. "$here/fast_dds.cpp" mirocup.cxx mirocupPubSubTypes.cxx -o client -lfastrtps -lfastcdr

# Plays a leg against keeper and prints its record's numbers. Arguments: options of the match.
play() {
  "$build/mirocup" match --blue dds:fast --yellow keeper --match "fast-$$" --half 5 --record leg.json "$@" >/dev/null &
  local match=$!
  ./client "fast-$$" blue fast
  wait "$match"
  "$build/mirocup" verify leg.json >/dev/null
  python3 - <<'P'
import json
record = json.load(open("leg.json"))
blue = record["network"]["blue"]
print(record["result"]["end"], record["result"]["score"], blue["in_step"], "of", record["ticks"], "ticks in step")
assert record["result"]["end"] == "full_time", record["result"]
P
}
play --speed max | tee lockstep
grep -Eq ' ([0-9]+) of \1 ticks' lockstep
play --speed 2
