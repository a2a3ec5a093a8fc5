# SPDX-License-Identifier: MIT
#
# For ./play and ./check, which source it. `COMMAND 2>&1 | progress NAME` shows how many steps of ninja or tests of ctest are done and
# how many there are: in a terminal as one line that moves, in a log as a line in ten seconds. Whatever else the command prints, such
# as an error of the compiler, is passed on.
progress() {
  local name=$1 line said=-10 moving=
  [[ -t 2 ]] && moving=yes
  while IFS= read -r line; do
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\] || $line =~ ^\ *([0-9]+)/([0-9]+)\ Test.*(\ Passed|\*\*\*) ]]; then
      local done=${BASH_REMATCH[1]} all=${BASH_REMATCH[2]}
      if [[ $moving ]]; then
        local bar
        printf -v bar '%*s' $((30 * done / all)) ''
        printf '\r%s: [%-30s] %d of %d ' "$name" "${bar// /#}" "$done" "$all" >&2
        [[ $done != "$all" ]] || echo >&2
      elif ((SECONDS - said >= 10)) || [[ $done == "$all" ]]; then
        said=$SECONDS
        echo "$name: $done of $all" >&2
      fi
      [[ $line != *'***'* ]] || printf '%s== %s\n' "${moving:+$'\n'}" "$line" >&2
    elif [[ $line =~ ^\ *Start\ +[0-9]+: || $line == 'Test project '* ]]; then
      :
    else
      printf '%s%s\n' "${moving:+$'\r'}" "$line" >&2
    fi
  done
}
