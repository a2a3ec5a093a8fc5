#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# A lecturer can follow docs/hosting.md as it is written: the first evening, then from the class list to tokens, a hand-in, a
# night and grades, with the page's own commands, and shorter halves. Fails if a command of the page has changed, or if one does
# not do what the page says; also if the page grows beyond 320 lines of 132 columns. Usage: hosting.sh ROOT BUILD
set -euo pipefail
root=$(realpath "$1")
build=$(realpath "$2")
page=$root/docs/hosting.md
folder=$(mktemp -d)
server=
trap '[[ -z $server ]] || kill "$server"; rm -rf "$folder"' EXIT

complain() {
  echo "hosting: $*" >&2
  exit 1
}

# The code below a heading.
code_of() {
  awk -v heading="$1" '/^```/ { inside = !inside; next } !inside && /^#/ { here = $0 ~ "^#+ " heading "$" } inside && here' "$page"
}

# Runs the commands below a heading of which the lines match a pattern.
follow() {
  local line
  while IFS= read -r line; do
    line=${line/--half 60/--half 4} line=${line/--half 120/--half 4} line=${line/ --drills drills.csv/}
    echo "> $line"
    eval "$line" </dev/null || [[ $? -eq 1 && $line == *status* ]] || complain "this failed: $line"
  done < <(code_of "$1" | grep -E "$2")
}

[[ $(wc -l <"$page") -le 320 ]] || complain "the page has more than 320 lines"
! LC_ALL=C.UTF-8 grep -nE '^.{133,}$' "$page" || complain "a line of the page has more than 132 columns"

PATH=$build:$PATH
cd "$folder"
cp "$build/house/striker.so" lions.so
cp "$build/house/chaser.so" rovers.so
follow 'Your first evening' '^mirocup league (init|submit|start)'
for team in lions rovers striker chaser; do
  grep -q ">$team</a>" evening/site/index.html || complain "the table of the first evening lacks $team"
done

follow 'The league' '^mirocup'
code_of 'The list and the tokens' | grep , | grep -v '^mirocup' >class.csv
echo 'gamma,,,,' >>class.csv  # never hands in
follow 'The list and the tokens' '^mirocup'
[[ $(wc -l <tokens.csv) -eq $(wc -l <class.csv) ]] || complain "there is not one token for each team of the class list"

command=$(code_of 'The server' | grep '^mirocup')
command=${command/0.0.0.0:8443 --tls cert.pem key.pem/0}
$command >address &
server=$!
for ((i = 0; i < 600; ++i)); do
  [[ ! -s address ]] || break
  sleep 0.1
done
for team in alpha,lions.so beta,rovers.so; do
  grep "^${team%,*}," tokens.csv | cut -d, -f3 >token
  mirocup hand-in "$(head -1 address)" --token-file token "${team#*,}"
done

follow 'A night' '^mirocup'
follow 'The end of term' '^mirocup league'
grep '^[12],alpha,' grades.csv | grep -q 'plays.*4711; 4712' || complain "the grades lack alpha, or what the class list says of it"
grep -q ',gamma,.*not in the league' grades.csv || complain "the grades lack gamma, which has not handed in"
