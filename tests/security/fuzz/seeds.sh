#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes the seeds and lets the build's readers read them. Usage: seeds.sh BUILD [PROGRAM], by default fuzz_corpus
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
"$(dirname "$0")/seeds.py" "$1" "$folder"
"$1/${2:-fuzz_corpus}" "$folder"
