#!/bin/sh
# SPDX-License-Identifier: MIT
#
# The image `host`: takes entries for the league in /league and shows its pages, at port 8080 or at $AT. Each day at $NIGHT (02:00, in the
# time of $TZ) it plays a night and then looks at the league's health. The container's log has what these say. Options are those of
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
