#!/bin/sh
# SPDX-License-Identifier: MIT
#
# The image `host`: takes entries for the league in /league and shows its pages, at port 8080 or at $AT. At NIGHT (02:00, in the time of TZ) of each
# day it plays a night and looks at the league's health; what these say is in the container's log. Options are those of
# `mirocup league serve`.
set -eu
league=/league
[ -f $league/league.json ] || mirocup league init $league --format nightly

nights() {
  while sleep $((($(date -d "${NIGHT:-02:00}" +%s) - $(date +%s) + 86399) % 86400 + 1)); do
    nice mirocup league nightly $league || echo "the night ended with $?" >&2
    mirocup league health $league || echo "the league needs a person: see above" >&2
  done
}

nights &
exec mirocup league serve $league --hand-in --at "${AT:-0.0.0.0:8080}" "$@"
