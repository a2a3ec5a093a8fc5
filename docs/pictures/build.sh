#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Draws the pictures of this folder again from their sources. Needs Debian's graphviz and python3.
set -euo pipefail
cd "$(dirname "$0")"
for source in *.dot; do
  dot -Tsvg "$source" >"${source%.dot}.svg"
done
python3 tick.py >tick.svg
