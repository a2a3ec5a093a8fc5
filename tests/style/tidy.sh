#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Fails on what .clang-tidy lists. Usage: tidy.sh [BUILD [FOLDER...]]; by default of all sources, which takes a while:
# the test asks for core and plugins only, whose sources don't include the large libraries.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build}
shift || true
[[ $# -gt 0 ]] || set -- core plugins server tournaments
# The commands may be g++'s, which knows warnings that clang does not.
find "$@" -name '*.cpp' -not -path '*/template/*' | sort |
  xargs --max-args=4 --max-procs="$(nproc)" \
    clang-tidy -p "$build" --quiet --warnings-as-errors='*' --extra-arg=-Wno-unknown-warning-option 2>/dev/null
