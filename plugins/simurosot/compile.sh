#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Runs a compiler (its command line is the arguments) and, where it fails, names the two idioms of Visual C++ 6 for which g++ has no
# switch: a loop variable that is used after its loop, and a function or variable without a type.
messages=$(mktemp) || exit 1
trap 'rm -f "$messages"' EXIT
LC_ALL=C "$@" 2>"$messages"
status=$?
cat "$messages" >&2
[ $status -eq 0 ] && exit 0

sed -nE "s/^(.*):([0-9]+):[0-9]+: error: '([A-Za-z_0-9]+)' (was not declared in this scope|does not name a type).*/\1	\2	\3/p" "$messages" |
  while IFS='	' read -r file line name; do
    [ -f "$file" ] || continue
    loop=$(head -n "$line" "$file" | grep -nE "for *\( *(int|long|unsigned|unsigned int|short) +$name\b" | tail -n 1 | cut -d: -f1)
    type=$(head -n "$line" "$file" | sed -nE "s/.*for *\( *((unsigned )?(int|long|short|unsigned)) +$name\b.*/\1/p" | tail -n 1)
    if [ -n "$loop" ]; then
      echo "$file:$line: \"$name\" is the variable of the loop in line $loop and is used after it, which Visual C++ 6 allowed." >&2
      echo "  Cure: write \"$type $name;\" before line $loop, and \"for ($name\" in place of \"for ($type $name\" there." >&2
    elif sed -n "${line}p" "$file" | grep -qE "^ *(static +|const +|extern +)*$name *[(=;]"; then
      echo "$file:$line: \"$name\" has no type, which Visual C++ 6 took for int." >&2
      echo "  Cure: write \"int $name\" there." >&2
    fi
  done
exit $status
