#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Fails on a finding of the checks in .clang-tidy. Usage: tidy.sh [--part I/N] [BUILD [FOLDER...]]. By default it reads all sources,
# which takes minutes; with --part every N-th of them. The tests read core and plugins only, whose sources don't include the large
# libraries. Most of the time goes into the headers of Eigen and the standard library, again for each source. In a unity build (all
# presets but clang) it therefore reads the same groups of sources as the compiler.
set -euo pipefail
cd "$(dirname "$0")/../.."
part=1/1
[[ ${1:-} != --part ]] || { part=$2 && shift 2; }
build=${1:-build}
shift || true
[[ $# -gt 0 ]] || set -- core plugins record web server tournaments programs labs
sources=$(find "${@/#/$build/}" -path '*/Unity/*_cxx.cxx' 2>/dev/null | sort)
at_once=1
if [[ -z $sources ]]; then
  sources=$(find "$@" -name '*.cpp' -not -path '*/template/*' | sort)
  at_once=4
fi
sources=$(awk -v i="${part%/*}" -v n="${part#*/}" 'NR % n == i % n' <<<"$sources")
# A group includes sources, which nothing else may: layering/check.sh. The commands may be those of g++, which knows warnings
# that clang does not know.
xargs --delimiter='\n' --max-args="$at_once" --max-procs="$(nproc)" <<<"$sources" \
  clang-tidy -p "$build" --quiet --checks=-bugprone-suspicious-include --warnings-as-errors='*' \
    --extra-arg=-Wno-unknown-warning-option 2>/dev/null
