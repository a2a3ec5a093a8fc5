#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Fails unless check.sh fails on a bad tree and prints each line of the tree's complaints.txt. Usage: finds.sh TREE
set -euo pipefail
cd "$(dirname "$0")"
if said=$(./check.sh "$1" 2>&1); then
  echo "$1 passes" >&2
  exit 1
fi
bad=0
while IFS= read -r complaint; do
  grep -qF "$complaint" <<<"$said" || { echo "$1: no complaint of: $complaint" >&2; bad=1; }
done <"$1/complaints.txt"
exit $bad
