#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes the seeds with the programs of BUILD and lets PROGRAM read them. Usage: seeds.sh BUILD PROGRAM
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
"$(dirname "$0")/seeds.py" "$1" "$folder"
"$2" "$folder"
