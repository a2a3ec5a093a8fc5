#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# docs/first-goal.md: each step is built as it is printed, in C++ and in Python, both play the leg that the page prints, and the
# last team beats striker as the page says. Usage: first_goal.sh ROOT BUILD
set -euo pipefail
root=$(realpath "$1")
build=$(realpath "$2")
headers="-I'$root'/plugins"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
page=$root/docs/first-goal.md
cd "$folder"

# The blocks of a language as files 1.END, 2.END …
blocks() {
  awk -v start="^\`\`\`$1\$" -v end="$2" '$0 ~ start { inside = 1; ++n; next } /^```$/ { inside = 0 } inside { print > (n "." end) }' "$page"
}
blocks cpp cpp
blocks python py
build_line=$(grep -m1 -o '^g++ .* first\.cpp -o first\.so' "$page")
match=$(grep -m1 -o '^build/mirocup match --blue ./first.so .* --seed 1' "$page")
mapfile -t results < <(grep -oP '^\*\*You see\*\* `\Kfirst \(blue\) [^`]*' "$page")
[[ ${#results[@]} -eq 8 && -f 8.cpp && -f 8.py && ! -f 9.py ]] || {
  echo "first_goal: eight steps with a leg each are expected" >&2
  exit 1
}
# The steps 2 to 7 show functions without the lines around them, and a comment in place of a function of an earlier step.
for language in cpp py; do
  for step in {7..2}; do
    {
      sed '/decide(/,$d' "1.$language"
      while IFS= read -r line; do
        if [[ $line =~ ([a-z]+)\(\)\ as\ in\ step\ ([2-6])$ ]]; then
          awk -v name=" ${BASH_REMATCH[1]}[(]" '/^$/ { inside = 0 } $0 ~ name && /[{:]$/ { inside = 1 } inside' \
            "${BASH_REMATCH[2]}.$language"
        else
          echo "$line"
        fi
      done <"$step.$language"
      [[ $language == py ]] || printf '};\n\nMIROCUP_EXPORT_TEAM(First, "first")\n'
    } >whole
    mv whole "$step.$language"
  done
done
for step in {1..8}; do
  cp "$step.cpp" first.cpp
  cp "$step.py" first.py
  eval "${build_line/-Iplugins/$headers} -Wall -Wextra -Werror"
  for team in ./first.so ./first.py; do
    opponent=$(grep -oP '\w+(?= \(yellow\))' <<<"${results[step - 1]}")
    command=${match/.\/first.so/$team}
    command=${command/--yellow idle/--yellow $opponent}
    played=$("$build/mirocup" ${command#build/mirocup } | tail -1)
    [[ $played == "${results[step - 1]}" ]] || {
      echo "first_goal: step $step, $team: \"$played\", and the page says \"${results[step - 1]}\"" >&2
      exit 1
    }
  done
done
won=0
for seed in {1..10}; do
  score=$("$build/mirocup" match --blue ./first.so --yellow striker --half 120 --seed "$seed" | grep -oE '[0-9]+ : [0-9]+')
  [[ ${score% : *} -le ${score#* : } ]] || won=$((won + 1))
done
[[ $won -eq 9 ]] || { echo "first_goal: the last team beats striker in $won of ten legs, and the page says nine" >&2; exit 1; }
