#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Runs the tests of the web pages in Debian's Chromium. Usage: tests/programs/web/run.sh BUILD_FOLDER [NAME...], for NAME.test.js;
# all without a name. The driver is installed into BUILD_FOLDER/web on the first run.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
shift

modules=$build/web
mkdir -p "$modules"
exec {lock}>"$modules/lock"  # tests may run at the same time
flock "$lock"
cp "$here/package.json" "$here/package-lock.json" "$modules/"
cmp -s "$here/package-lock.json" "$modules/installed" ||
  { npm ci --prefix "$modules" --no-audit --no-fund >&2 && cp "$here/package-lock.json" "$modules/installed"; }
exec {lock}>&-
files=("$here"/*.test.js)
[[ $# -eq 0 ]] || { files=("${@/#/$here/}") && files=("${files[@]/%/.test.js}"); }
MIROCUP_BUILD=$build MIROCUP_WEB_MODULES=$modules node --test "${files[@]}"
