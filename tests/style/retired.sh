#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Fails on an identifier of retired_identifiers.txt in a tracked file: one name for one thing. Usage: retired.sh [LIST]
set -euo pipefail
list=$(realpath "${1:-$(dirname "$0")/retired_identifiers.txt}")
cd "$(dirname "$0")/../.."
names=$(sed 's/#.*//; s/[[:space:]]//g; /^$/d' "$list")
[[ -n $names ]] || exit 0
code=0
git grep -nwFf <(echo "$names") -- core plugins record web server tournaments programs labs tests docs \
  ':!tests/style/retired_identifiers.txt' ':!CHANGELOG.md' || code=$?
case $code in
  0) echo "these names are retired: tests/style/retired_identifiers.txt" >&2; exit 1 ;;
  1) exit 0 ;;
  *) exit "$code" ;;  # the search itself failed
esac
