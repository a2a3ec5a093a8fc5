#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Tests the module for browsers in node. Usage: tests/programs/browser/run.sh BUILD_FOLDER NAME, for NAME.test.js.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
MIROCUP_BUILD=$(cd "$1" && pwd) node --no-warnings --test "$here/$2.test.js"
