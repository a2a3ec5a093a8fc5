#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Links in Markdown are alive and the index is complete. Fails on
#   a relative link whose file is missing, or whose heading is missing;
#   a page that docs/README.md does not link;
#   a path in backquotes, in docs/changing.md or docs/algorithm.md, that is not in the tree;
#   a function, in the table "Where is it decided" of docs/changing.md, that the file named before it does not have;
#   a program of the tree that a line of code starts and that is not executable.
# Usage: links.sh [ROOT]
set -euo pipefail
cd "${1:-$(dirname "$0")/../../..}"
bad=0

complain() {
  echo "links: $*" >&2
  bad=1
}

pages() {
  find . \( -path ./build -o -path ./leagues -o -name '.*' ! -name . -o -name node_modules \) -prune -o -name '*.md' -print |
    sed 's|^\./||' | sort
}

# The text without code blocks and code spans.
prose() {
  awk '/^ *```/ { inside = !inside; next } !inside' "$1" | sed 's/`[^`]*`//g'
}

# The anchors that a renderer makes of headings: lower case, punctuation gone, spaces to hyphens.
anchors() {
  awk '/^ *```/ { inside = !inside; next } !inside && /^#+ /' "$1" | sed -E 's/^#+ //; s/`//g; s/\[([^]]*)\]\([^)]*\)/\1/g' |
    tr '[:upper:]' '[:lower:]' | sed -E "s/[^[:alnum:] _-]//g; s/ /-/g"
}

while IFS= read -r page; do
  folder=$(dirname "$page")
  while IFS= read -r link; do
    case $link in http://* | https://* | mailto:* | '') continue ;; esac
    file=${link%%#*}
    target=$page
    if [[ -n $file ]]; then
      target=$(realpath -m --relative-to=. "$folder/$file")
      [[ -e $target ]] || { complain "$page: no file $link"; continue; }
    fi
    [[ $link != *'#'* || $target != *.md ]] || anchors "$target" | grep -xF -- "${link#*#}" >/dev/null ||
      complain "$page: no heading for $link"
  done < <(prose "$page" | grep -oE '\]\([^) ]+' | sed 's/^](//' || true)
  [[ $page == docs/README.md ]] || prose docs/README.md | grep -F "]($(realpath -m --relative-to=docs "$page"))" >/dev/null ||
    complain "docs/README.md does not list $page"
done < <(pages)

# Paths on the pages that tell where to start.
for page in docs/changing.md docs/algorithm.md; do
  while IFS= read -r span; do
    [[ -e $span ]] || complain "$page: no file $span"
  done < <(grep -oE '`(core|system|plugins|idl|record|web|server|tournaments|programs|browser|labs|tests|docs|examples|cmake)/[^` {*]+`' "$page" | tr -d '`')
done

# The functions that decide.
file=
functions=0
while IFS= read -r span; do
  case $span in
    */*) file=$span ;;
    *'()') functions=$((functions + 1))
      grep -qE "\b${span%()}\(" "$file" || complain "docs/changing.md: no $span in $file" ;;
    *) complain "docs/changing.md: neither a file nor a function: $span" ;;
  esac
done < <(awk '/^## / { inside = $0 == "## Where is it decided" } inside && /^\|/' docs/changing.md |
  cut -d'|' -f3 | grep -oE '`[^`]+`' | tr -d '`')
[[ $functions -ge 15 ]] || complain "docs/changing.md: the table \"Where is it decided\" names only $functions functions"

# Programs that a reader starts by typing their paths.
while IFS= read -r page; do
  while IFS= read -r file; do
    [[ ! -f $file || -x $file ]] || complain "$page: $file is not executable"
  done < <(awk '/^ *```/ { inside = !inside; next } inside { print $1 }' "$page" | grep / || true)
done < <(pages)

exit $bad
