#!/bin/sh
# SPDX-License-Identifier: MIT
#
# The image `play`: plays the example league in /league, unless it has been played, prints its table, and shows its pages at port 8080.
set -eu
league=/league
[ -f $league/league.json ] || mirocup league init $league --config /usr/local/share/mirocup/league.json
mirocup league start $league
mirocup league publish $league
exec mirocup league serve $league --at 0.0.0.0:8080
