#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# A league in mid-term whose host installs the next release: with a fix of the same minor version its nights go on, its records verify
# and its pages are made; the next minor version refuses a night and says which version to keep. Usage: upgrade.sh BUILD
# Builds the last commit twice under other version numbers: minutes.
# Catches a program that takes a fix for another game, or another minor version for the same.
set -euo pipefail
root=$(realpath "$(dirname "$0")/../..")
old=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
league=$folder/spring

# version N: builds mirocup as if it had this number.
git clone -q "$root" new
version() {
  sed -i "s/^project(mirocup VERSION [0-9.]*/project(mirocup VERSION $1/" new/CMakeLists.txt
  (cd new && cmake --preset play >/dev/null && cmake --build build --target play >build.log 2>&1) || { tail -n 50 new/build.log; exit 1; }
  new/build/mirocup --version | grep -F "$1"
}
IFS=. read -r major minor patch < <("$old/mirocup" --version | grep -oE '[0-9]+\.[0-9]+\.[0-9]+')

"$old/mirocup" league init "$league" --format nightly --half 5 --team one=house:chaser --team two=house:striker --team three=house:keeper
"$old/mirocup" league nightly "$league"
legs() { grep -c '"kind":"leg"' "$league/journal.jsonl"; }
before=$(legs)

version "$major.$minor.$((patch + 1))"
new/build/mirocup league nightly "$league" --another
[[ $(legs) -gt $before ]]
new/build/mirocup league verify "$league"
new/build/mirocup league publish "$league"
"$old/mirocup" league verify "$league"

version "$major.$((minor + 1)).0"
before=$(legs)
code=0
said=$(new/build/mirocup league nightly "$league" --another 2>&1) || code=$?
echo "$said"
[[ $code == 2 && $said == *"Continue with mirocup $major.$minor."*"or a fix of it"* && $(legs) == "$before" ]]
new/build/mirocup league verify "$league"
echo "all is well"
