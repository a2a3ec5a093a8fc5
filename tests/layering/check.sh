#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Dependencies point one way (README.md, "The tree"). Fails on an include, a link or a library call against that order.
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
may plugins/include 'mirocup/(strategy|team)\.h"'
may plugins/house 'mirocup/'
may plugins/abi 'core/|plugins/abi/|mirocup/'
may plugins/host 'core/|plugins/(abi|host)/|mirocup/'
may idl 'idl/'
may server/system 'core/base/|server/system/'
may server/pace 'server/pace/'
may server/record 'core/|server/(system|record)/|server/pace/(absence|durations)\.hpp"'
may server/traces 'core/|server/(system|record|traces)/'
may server/dds 'core/|idl/|server/dds/|server/pace/(absence|durations)\.hpp"|plugins/abi/|mirocup/'
may server/web 'core/|server/(system|record|web)/'
may server/app 'core/|plugins/(abi|host)/|mirocup/|server/'
may tournaments/table 'core/base/|tournaments/table/'
may tournaments/format 'core/|server/(system|record)/|tournaments/(format|table)/'
may tournaments/journal 'core/base/|server/system/|tournaments/journal/'
may tournaments/league 'core/|server/(system|record)/|tournaments/(format|table|journal|league)/'
may tournaments/play 'core/|server/(system|record)/|tournaments/(format|table|journal|league|play)/'
may tournaments/publish 'core/|server/(system|record)/|tournaments/(format|table|journal|league|publish)/'
may tournaments/app 'core/|server/(system|record|web)/|tournaments/'

# only PATTERN ROOM...: the system's or a library's headers that match PATTERN appear in these rooms only.
only() {
  local pattern=$1 line
  shift
  while IFS= read -r line; do
    complain "$line: not in this room"
  done < <(grep -rnE "^#include <($pattern)" core plugins idl server tournaments |
    grep -vE "^($(IFS='|'; echo "$*"))/" || true)
}

only 'dds/|mirocup\.h>' server/dds
only 'nlohmann/' server/record server/traces server/web server/app tournaments
only 'dlfcn\.h' plugins/host
only 'httplib' server/web
only 'CLI/' server/app tournaments/app
only 'openssl/|zstd' server/system server/record
only 'box2d/|chipmunk/|ode/' none  # peers: tests/bench alone
only 'thread>|chrono>|mutex>|fstream>|iostream>|filesystem>|random>|sys/|unistd\.h' plugins server tournaments

while IFS= read -r line; do
  complain "$line: a source is compiled, not included"
done < <(grep -rnE '^#include ["<].*\.(c|cpp)[">]' core plugins idl server tournaments || true)

# Whatever the C library rounds in its own way would change a state hash: core has functions of its own.
while IFS= read -r line; do
  complain "$line: core computes this itself (core/base/math.hpp)"
done < <(grep -rnE 'std::(sin|cos|tan|exp|expm1|log|log1p|pow|hypot|cbrt|asin|acos|atan|atan2|fma|rand)\(' core || true)

# links ROOM REGEX: the room's CMakeLists.txt names no target that matches.
links_not() {
  local room=$1 forbidden=$2 line
  while IFS= read -r line; do
    complain "$room/CMakeLists.txt: $line is a link against the order"
  done < <(grep -nE "mirocup::($forbidden)" "$room/CMakeLists.txt" || true)
}
links_not core 'plugins|strategy|idl|record|dds|league'
links_not plugins 'idl|record|dds|league'
links_not idl 'core|plugins|record|dds|league'
links_not server 'league'
links_not tournaments 'plugins|dds|idl'

exit $bad
