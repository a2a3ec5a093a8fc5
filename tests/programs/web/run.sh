#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Runs the tests of the web pages in Debian's Chromium. Usage: tests/programs/web/run.sh BUILD_FOLDER
# The driver is installed into BUILD_FOLDER/web on the first run.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)

modules=$build/web
mkdir -p "$modules"
cp "$here/package.json" "$here/package-lock.json" "$modules/"
[[ -d $modules/node_modules/axe-core && -d $modules/node_modules/playwright-core ]] || npm ci --prefix "$modules" --no-audit --no-fund >&2
MIROCUP_BUILD=$build MIROCUP_WEB_MODULES=$modules node --test "$here"/*.test.js
