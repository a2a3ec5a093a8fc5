#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Fails on what .clang-tidy lists. Usage: tidy.sh [BUILD [FOLDER...]]; by default of all sources, which takes a while:
# the test asks for core and plugins only, whose sources don't include the large libraries. Most of the time goes into
# the headers of Eigen and the standard library, again for each source: of a build that compiles several sources at once
# (all but the preset clang) it reads the same groups.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build}
shift || true
[[ $# -gt 0 ]] || set -- core plugins server tournaments
sources=$(find "${@/#/$build/}" -path '*/Unity/*_cxx.cxx' 2>/dev/null | sort)
at_once=1
if [[ -z $sources ]]; then
  sources=$(find "$@" -name '*.cpp' -not -path '*/template/*' | sort)
  at_once=4
fi
# A group includes sources, which only a group may: layering/check.sh. The commands may be g++'s, which knows warnings
# that clang does not.
xargs --max-args="$at_once" --max-procs="$(nproc)" <<<"$sources" \
  clang-tidy -p "$build" --quiet --checks=-bugprone-suspicious-include --warnings-as-errors='*' \
    --extra-arg=-Wno-unknown-warning-option 2>/dev/null
