#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Fails on a line of a source that has more than 100 columns; clang-format leaves comments as they are. Usage: columns.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
export LC_ALL=C.UTF-8  # characters, not bytes
if find core system plugins idl record web server tournaments programs browser labs tests examples \
  -path labs/simurosot/samples -prune -o -type f \( -name '*.[hc]pp' -o -name '*.[hc]' -o -name '*.idl' \) -print |
  sort | xargs grep -nE '^.{101,}$' /dev/null; then
  echo "these lines have more than 100 columns" >&2
  exit 1
fi
