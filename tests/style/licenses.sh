#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Each source says its license, as Debian's licensecheck reads it. Templates and the samples that stand for old teams say none: they
# are what a student begins with, and what others wrote long ago looks like. Exit 3 without licensecheck.
set -euo pipefail
cd "$(dirname "$0")/../.."
command -v licensecheck >/dev/null || { echo "licensecheck is missing: cmake/install_packages.sh cmake/packages-install.txt" >&2; exit 3; }
unsaid=$(git ls-files -z -- . ':!plugins/template' ':!labs/simurosot/samples' ':!labs/tests/programs/simurosot/idioms' \
  ':!tests/release/kept' ':!*.md' |
  xargs -0 licensecheck --machine | awk -F'\t' '$2 != "MIT License" && !/cmake\/debian\// { print $1 ": " $2 }')
[[ -z $unsaid ]] || { echo "$unsaid" >&2; exit 1; }
