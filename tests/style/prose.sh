#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Fails on a habit of prose.txt in a page or in a comment of a header, and names the line and what to write instead. It also
# fails if a pattern does not find its own example.
set -euo pipefail
list=$(realpath "$(dirname "$0")/prose.txt")
cd "$(dirname "$0")/../.."
code=0
while IFS=$'\t' read -r pattern instead example; do
  [[ $pattern != \#* && -n $pattern ]] || continue
  grep -qP -- "$pattern" <<<"$example" || { echo "prose.txt: $pattern does not find: $example" >&2; exit 2; }
  # Of headers, comments only. The glossary and the laws have words of others.
  found=$(git grep -nP -- "$pattern" -- '*.md' ':!docs/state-hashes.md'
          git grep -nP -- "(//|\*).*($pattern)" -- '*.hpp' '*.h' ':!tests' ':!labs/tests' ':!labs/simurosot/samples') || true
  [[ -z $found ]] || { echo "$found"; echo "  instead: $instead"; code=1; }
done <"$list"
exit "$code"
