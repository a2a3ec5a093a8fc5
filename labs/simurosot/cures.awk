# SPDX-License-Identifier: MIT
#
# Reads the messages of g++ and prints a cure for what Visual C++ took and g++ does not. Each message begins with FILE:LINE:COLUMN.

# Reads the file's lines once, up to the one that is asked for.
function line_of(file, number,    text) {
  while (count[file] < number && (getline text < file) > 0) {
    sub(/\r$/, "", text)
    lines[file, ++count[file]] = text
  }
  return lines[file, number]
}

# The nearest loop before the line whose head declares the name; 0 if there is none.
function loop_of(file, number, name,    i, text) {
  line_of(file, number)
  for (i = number; i > 0; --i) {
    text = lines[file, i]
    if (match(text, "for[ \t]*\\([^;]*[^A-Za-z_0-9.>]" name "[ \t]*[=,;]")) {
      head = substr(text, RSTART, RLENGTH)
      sub(/^for[ \t]*\([ \t]*/, "", head)
      if (head ~ /^[A-Za-z_][A-Za-z_0-9:]*([ \t]+[A-Za-z_]|[ \t]*\*)/) return i
    }
  }
  return 0
}

function type_in(head,    type) {
  type = head
  match(type, /^(unsigned[ \t]+|signed[ \t]+|const[ \t]+|struct[ \t]+)*[A-Za-z_][A-Za-z_0-9:]*[ \t]*\**/)
  type = substr(type, 1, RLENGTH)
  sub(/[ \t]+$/, "", type)
  return type
}

function say(file, line, what, cure) {
  if (said[file, line, what]++) return
  printf "%s:%d: %s\n  Cure: %s\n", file, line, what, cure
}

# Parts of the message: where it is, and the name that it quotes first.
function take_apart(    rest) {
  match($0, /:[0-9]+:[0-9]+: /)
  file = substr($0, 1, RSTART - 1)
  rest = substr($0, RSTART + 1)
  number = rest + 0
  sub(/^[0-9]+:[0-9]+: [a-z ]*: /, "", rest)
  message = rest
  name = ""
  if (match(message, /'[^']*'/)) name = substr(message, RSTART + 1, RLENGTH - 2)
}

/: (fatal error|error): / { take_apart(); is_error = 1 }

/error: '[A-Za-z_0-9]+' was not declared in this scope/ || /error: '[A-Za-z_0-9]+' does not name a type/ {
  text = line_of(file, number)
  loop = loop_of(file, number, name)
  if (name ~ /^_*asm$/ || text ~ /(^|[^A-Za-z_0-9])_+asm([^A-Za-z_0-9]|$)/) next
  if (text ~ "^[ \t]*(static[ \t]+|const[ \t]+|extern[ \t]+|register[ \t]+|inline[ \t]+)*" name "[ \t]*[(=;,[]" && $0 ~ /name a type/) {
    say(file, number, "\"" name "\" has no type, which Visual C++ 6 took for int.", "write \"int " name "\" there.")
    has_no_type[name] = 1
  } else if (loop > 0) {
    type = type_in(head)
    rest = substr(head, length(type) + 1)
    sub(/^[ \t]+/, "", rest)
    first = rest
    sub(/[^A-Za-z_0-9].*/, "", first)
    others = first == name ? "" : ", " name
    say(file, number, "\"" name "\" is the variable of the loop in line " loop " and is used after it, which Visual C++ 6 allowed.",
        "write \"" type " " first others ";\" before line " loop ", and \"for (" first "\" in place of \"for (" type " " first "\" there.")
  } else if (name ~ /^(cout|cin|cerr|endl|string|vector|map|list|deque|set|queue|stack|pair|ifstream|ofstream|sort)$/) {
    say(file, number, "\"" name "\" is a name of the C++ library.",
        "include its header, and write \"using namespace std;\" after the includes.")
  } else if (!(name in has_no_type) && !is_undeclared[name]++) {
    say(file, number, "\"" name "\" is not declared.",
        "give after PRELUDE in CMakeLists.txt the team's header that declares it or, for a name of Windows, a new header. If the team should " \
        "have it and no file here does, a file of the team is missing.")
  }
}

/error: cannot bind non-const lvalue reference of type/ { reference = name; is_reference = 1; next }
is_reference && /note: +initializing argument/ {
  take_apart()
  type = reference
  sub(/&$/, "", type)
  say(file, number, "a value that nothing else holds is given to \"" reference "\", which Visual C++ allowed.",
      "write \"const " reference "\" in place of \"" reference "\" there, and where that function is declared; if it changes what it is given, \"" \
      type "\".")
  is_reference = 0
}

/error: jump to (label|case label)/ { jumps_at = file ":" number; is_jump = 1; next }
is_jump && /note: +crosses initialization of/ {
  take_apart()
  sub(/^.*[ *&]/, "", name)
  say(file, number, "\"" name "\" gets its value here, and the jump to " jumps_at " passes it by, which Visual C++ allowed.",
      "declare \"" name "\" without a value before the jump, and set it here.")
  is_jump = 0
}

is_error && /error: / {
  text = line_of(file, number)
  if (text ~ /(^|[^A-Za-z_0-9])_+asm([^A-Za-z_0-9]|$)/) {
    say(file, number, "this is assembler of Visual C++.", "write it in C, such as \"sqrt(x)\" for fsqrt.")
  } else if ($0 ~ /fatal error: .*: No such file or directory/) {
    sub(/: No such file.*/, "", message)
    say(file, number, "there is no " message ", neither beside the sources nor for it in mirocup.",
        "copy it to the sources; if it is a part of Windows that the team does not need, take the line out.")
  } else if (message ~ /^#error/) {
    say(file, number, "the sources want a macro that is not set here.",
        "give its name to mirocup_simurosot_team in CMakeLists.txt, such as DEFINITIONS _WIN32.")
  } else if (message ~ /invalid suffix/) {
    say(file, number, "only Visual C++ knows such a suffix of a number.", "write LL in place of i64, and ULL in place of ui64.")
  } else if (message ~ /stray '\\[0-9]+' in program/) {
    say(file, number, "there is a character in the code that is neither a letter nor a sign of C++.",
        "write names in ASCII letters, and save the file as UTF-8.")
  } else if (message ~ /is not a class or namespace|only available with|is a C\+\+ extension|range-based 'for'/) {
    say(file, number, "the sources are in a newer C++.", "write STANDARD gnu++17 in CMakeLists.txt.")
  } else if (message ~ /need 'typename' before/) {
    sub(/^[^']*'typename' before '/, "", message)
    sub(/'.*/, "", message)
    say(file, number, "a type that depends on a template's argument is named without \"typename\".", "write \"typename " message "\" there.")
  }
  is_error = 0
}

/undefined reference to [`']/ {
  sub(/.*undefined reference to [`']/, "")
  sub(/'$/, "")
  if (is_lost[$0]++) next
  if (++lost == 1) first_lost = $0
}

END {
  if (lost > 0) {
    printf "%d %s used that no source in CMakeLists.txt defines, such as \"%s\".\n  Cure: %s\n", lost,
      lost == 1 ? "name is" : "names are", first_lost,
      "give after SOURCES the team's file that defines it; for a library of others, write target_link_libraries(team PRIVATE LIBRARY) at " \
      "the end of CMakeLists.txt. If no file here defines a function that the platform calls, this is no team."
  }
}
