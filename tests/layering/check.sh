#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Fails on an include, a link or a path against layers.txt (layers.py), and on what else would tie rooms together.
# Run from anywhere: tests/layering/check.sh [ROOT]
set -euo pipefail
here=$(realpath "$(dirname "$0")")
cd "${1:-$here/../..}"
product=(core system plugins idl record web server tournaments programs)
bad=0

complain() {
  echo "layering: $*" >&2
  bad=1
}

"$here/layers.py" "$PWD" || bad=1
"$here/lines.py" "$PWD" || bad=1

while IFS= read -r line; do
  complain "$line: a source is compiled, not included"
done < <(grep -rnE '^#include ["<].*\.(c|cpp)[">]' "${product[@]}" || true)

# No two folders include each other, directly or through others. A folder in this list counts as one room with its parent:
# the referee calls the laws, which share its tools; the host builds the sandbox, which shares its descriptors.
with_parent='core/referee/laws|plugins/host/sandbox'
while IFS= read -r line; do
  complain "$line: these folders include each other"
done < <(grep -rE '^#include "[^"]*/' "${product[@]}" \
  --include='*.hpp' --include='*.cpp' --include='*.h' --include='*.c' 2>/dev/null |
  sed -nE 's|^(.*)/[^/]+:#include "(.*)/[^/]+".*$|\1 \2|p' |
  sed -E "s#\\b($with_parent)\\b#\\1/..#g; s#/[^/ ]+/\\.\\.##g" |
  awk '$1 != $2' | sort -u | { tsort 2>&1 >/dev/null || true; } | grep -v 'contains a loop' |
  sed 's/^tsort: //' | paste -sd ' ' | grep .)

# A room of the simulator can be read in one sitting. A unit is a header and a source of one name.
max_units=16
while IFS= read -r room; do
  units=$(find "$room" -maxdepth 1 -name '*.[hc]pp' | sed 's/\.[hc]pp$//' | sort -u | wc -l)
  [[ $units -le $max_units ]] || complain "$room has $units units, but at most $max_units are allowed"
done < <(find core/simulator -type d 2>/dev/null)

# The interface of a law is for the laws and for the referee, who calls them.
while IFS= read -r line; do
  complain "$line: only laws and sources of core/referee include the interface of a law"
done < <(grep -rn '^#include "core/referee/laws/law\.hpp"' "${product[@]}" 2>/dev/null |
  grep -vE '^core/referee/(laws/[^:]*|[^/:]*\.cpp):' || true)

# What the portal tells teams and visitors comes from a SeenState. Only the staff's desk reads the whole league.
while IFS= read -r line; do
  complain "$line: the portal takes a SeenState (tournaments/publish/snapshot.hpp)"
done < <(grep -rnE '\bLeague(State|Store)\b' tournaments/handin 2>/dev/null | grep -v '^tournaments/handin/staff_desk\.' || true)

# The time of == would tell a stranger how much of a secret is right.
while IFS= read -r line; do
  complain "$line: secrets are compared by system::is_same_secret()"
done < <(grep -rnE '\b(key_|secret|token|cookie|session\.sha256|token\.sha256)\)? *[!=]= *[^ n"]|[!=]= *(key_|trust\.secret|token\.sha256)\b' \
  web tournaments/handin programs/league --include='*.cpp' --include='*.hpp' 2>/dev/null || true)

# The product is built without the tests: it may name them in comments only.
while IFS= read -r line; do
  complain "$line: the product reads nothing from tests/"
done < <(grep -rnE '\btests/' "${product[@]}" --include=CMakeLists.txt --include='*.cmake' \
  --include='*.hpp' --include='*.cpp' --include='*.h' --include='*.c' --include='*.idl' --include='*.js' \
  --include='*.sh' 2>/dev/null | grep -vE '^[^:]*:[0-9]+:([^#/]|/[^/])*(//|#).*tests/' || true)

# A function that each C library rounds differently would change a state hash: core has functions of its own.
while IFS= read -r line; do
  complain "$line: core computes this itself (core/base/math.hpp)"
done < <(grep -rnE 'std::(sin|cos|tan|exp|expm1|log|log1p|pow|hypot|cbrt|asin|acos|atan|atan2|fma|rand)\(' core || true)

exit $bad
