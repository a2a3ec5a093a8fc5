#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Dependencies point in one direction (docs/tree.md). Fails on an include, a link or a library call against it.
# Run from anywhere: tests/layering/check.sh [ROOT]
set -euo pipefail
cd "${1:-$(dirname "$0")/../..}"
bad=0

complain() {
  echo "layering: $*" >&2
  bad=1
}

# may ROOM REGEX: files below ROOM include, of the project's own headers, only those that match REGEX.
may() {
  local room=$1 allowed=$2 line
  while IFS= read -r line; do
    complain "$line is against the order ($room may include $allowed)"
  done < <(grep -rnE '^#include "' "$room" --include='*.hpp' --include='*.cpp' --include='*.h' --include='*.c' |
    grep -vE "#include \"($allowed)" || true)
}

# The rooms of core, each of which may include the ones before it and itself.
may core/base 'core/base/'
may core/field 'core/(base|field)/'
may core/geometry 'core/(base|field|geometry)/'
below='core/(base|field|geometry)/'
simulator=core/simulator
may $simulator/model "$below|$simulator/model/"
may $simulator/trajectory "$below|$simulator/(model|trajectory)/"
may $simulator/solver "$below|$simulator/(model|solver)/"
may $simulator/collision "$below|$simulator/(model|trajectory|solver|collision)/"
may $simulator/impact "$below|$simulator/(model|trajectory|solver|collision|impact)/"
may $simulator/resting_contact "$below|$simulator/(model|trajectory|solver|collision|impact|resting_contact)/"
may $simulator/stepping "$below|$simulator/(model|trajectory|solver|collision|impact|stepping)/"
may $simulator "$below|$simulator/"
may core/referee 'core/(base|field|geometry|referee)/'
may core/match 'core/(base|field|geometry|simulator|referee|match)/'
may core/replay 'core/'
may system 'core/base/|system/'
may plugins/include 'mirocup/(strategy\.hpp|(strategy|team)\.h"|skills/)'
may plugins/predict 'core/(base|field|geometry|simulator)/|core/match/(command|observed_robot)\.hpp|mirocup/predict\.hpp'
may plugins/house 'mirocup/'
may plugins/simurosot 'mirocup/strategy\.h"|(([A-Za-z_0-9]*)\.[hH]")'
may plugins/abi 'core/|plugins/abi/|mirocup/'
may plugins/host 'core/|system/|plugins/(abi|host)/|mirocup/'
may plugins/python 'core/|plugins/(host|python)/|mirocup/'
may idl 'idl/'
may server/pace 'server/pace/'
may server/record 'core/|system/|server/record/|server/pace/(absence|durations)\.hpp"'
may server/statistics 'core/|system/|server/(record|statistics)/'
may server/traces 'core/|system/|server/(record|traces)/'
may server/drills 'core/|system/|server/(record|drills)/'
may server/pitch 'core/|system/|server/(record|pitch)/|server/web/design/'
may server/dds 'core/|system/|idl/|server/dds/|server/pace/(absence|durations)\.hpp"|plugins/abi/|mirocup/'
may server/firasim 'core/|system/|server/firasim/|server/pace/(absence|durations)\.hpp"'
may server/web/design 'system/|server/web/design/'
may server/policy 'core/(base|field)/|server/(record|policy)/|mirocup/strategy\.h"'  # in the source that it writes
may server/web 'core/|system/|server/(record|statistics|web)/'
may server/app 'core/|system/|plugins/(abi|host)/|mirocup/|server/'
may training 'core/|system/|server/record/|plugins/host/|mirocup/training\.h"|training/'
may tournaments/table 'core/base/|tournaments/table/'
may tournaments/format 'core/|system/|server/record/|tournaments/(format|table)/'
may tournaments/journal 'core/base/|system/|server/record/|tournaments/journal/'
may tournaments/league 'core/|system/|server/record/|tournaments/(format|table|journal|league)/'
may tournaments/handin 'core/|system/|server/record/|server/web/request\.hpp"|tournaments/(format|table|journal|league|publish|handin)/'
may tournaments/play 'core/|system/|server/record/|tournaments/(format|table|journal|league|play)/'
may tournaments/tune 'core/base/|system/|server/record/|tournaments/tune/'
may tournaments/publish 'core/|system/|server/(record|statistics|web/design)/|tournaments/(format|table|journal|league|publish)/'
may tournaments/app 'core/|system/|server/(record|statistics|web)/|tournaments/'

# only PATTERN ROOM...: only these rooms include headers of the system or of a library that match PATTERN.
only() {
  local pattern=$1 line
  shift
  while IFS= read -r line; do
    complain "$line: not in this room"
  done < <(grep -rnE "^#include <($pattern)" core system plugins idl server training tournaments |
    grep -vE "^($(IFS='|'; echo "$*"))/" || true)
}

only 'dds/|mirocup\.h>' server/dds
only 'nlohmann/' server/record server/pitch server/statistics server/traces server/drills server/web server/app training tournaments
only 'dlfcn\.h' plugins/host plugins/python training
only 'httplib' server/web
only 'kainjow/' server/web/design
only 'CLI/' server/app system tournaments/app
only 'openssl/' system
only 'zstd' server/record
only 'zip\.h' server/policy
only 'box2d/|chipmunk/|ode/' none  # peers: tests/bench alone
only 'thread>|chrono>|mutex>|fstream>|iostream>|filesystem>|random>|sys/|unistd\.h' system plugins server training tournaments

while IFS= read -r line; do
  complain "$line: a source is compiled, not included"
done < <(grep -rnE '^#include ["<].*\.(c|cpp)[">]' core system plugins idl server training tournaments || true)

# No two folders include each other, directly or through others. A folder in this list counts as one room with its parent:
# the referee calls the laws, which share its tools; the host builds the sandbox, which shares its descriptors.
with_parent='core/referee/laws|plugins/host/sandbox'
while IFS= read -r line; do
  complain "$line: these folders include each other"
done < <(grep -rE '^#include "[^"]*/' core system plugins idl server training tournaments \
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
done < <(grep -rn '^#include "core/referee/laws/law\.hpp"' core system plugins idl server training tournaments 2>/dev/null |
  grep -vE '^core/referee/(laws/[^:]*|[^/:]*\.cpp):' || true)

# The product is built without the tests: it may name them in comments only.
while IFS= read -r line; do
  complain "$line: the product reads nothing from tests/"
done < <(grep -rnE '\btests/' core system plugins idl server training tournaments --include=CMakeLists.txt --include='*.cmake' \
  --include='*.hpp' --include='*.cpp' --include='*.h' --include='*.c' --include='*.idl' --include='*.js' \
  --include='*.sh' 2>/dev/null | grep -vE '^[^:]*:[0-9]+:([^#/]|/[^/])*(//|#).*tests/' || true)

# A function that each C library rounds differently would change a state hash: core has functions of its own.
while IFS= read -r line; do
  complain "$line: core computes this itself (core/base/math.hpp)"
done < <(grep -rnE 'std::(sin|cos|tan|exp|expm1|log|log1p|pow|hypot|cbrt|asin|acos|atan|atan2|fma|rand)\(' core || true)

# links_not ROOM REGEX: the room's CMakeLists.txt names no target that matches.
links_not() {
  local room=$1 forbidden=$2 line
  while IFS= read -r line; do
    complain "$room/CMakeLists.txt: $line is a link against the order"
  done < <(grep -nE "mirocup::($forbidden)" "$room/CMakeLists.txt" || true)
}
links_not core 'system|plugins|strategy|idl|record|dds|league'
links_not system 'plugins|strategy|idl|record|dds|league'
links_not plugins 'idl|record|dds|training|league'
links_not idl 'core|plugins|record|dds|league'
links_not server 'training|league'
links_not training 'dds|idl|web|league'
links_not tournaments 'plugins|dds|idl'

exit $bad
