#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The units of systemd give a league no more than it needs: `systemd-analyze security` says less than 4 of 10. Catches a line that
# is lost or that systemd does not know, and two leagues on one port. Usage: check.sh [FOLDER of the units]
set -euo pipefail
cd "$(dirname "$0")/../../.."
folder=${1:-tournaments/units}
command -v systemd-analyze >/dev/null || { echo "SKIPPED: systemd-analyze is not here (package systemd)"; exit 77; }
for unit in "$folder"/mirocup-*@.service; do
  said=$(systemd-analyze security --offline=true "$unit" 2>&1)
  level=$(sed -n 's/.*Overall exposure level.*: \([0-9.]*\) .*/\1/p' <<<"$said")
  echo "${unit##*/}: $level"
  # With its comments systemd-analyze says what it did not understand: names of calls, keys, values.
  if grep -E 'mirocup-.*@.*:[0-9]+: ' <<<"$said"; then exit 1; fi
  awk -v level="$level" 'BEGIN { exit !(level != "" && level < 4.0) }' || { echo "$unit: $level, not below 4" >&2; exit 1; }
  grep -Eq '^(OnFailure=mirocup-failed@%i.service|ExecStart=/etc/mirocup/failed %i)$' "$unit" ||
    { echo "$unit: nobody is told if it fails" >&2; exit 1; }
  grep -q '^StateDirectory=mirocup$' "$unit" || { echo "$unit: no StateDirectory" >&2; exit 1; }
done
grep -q -- '--at ${AT}' "$folder/mirocup-league@.service" && grep -q '^EnvironmentFile=-/etc/mirocup/%i' "$folder/mirocup-league@.service" ||
  { echo "all leagues have one port" >&2; exit 1; }
