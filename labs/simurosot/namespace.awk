# SPDX-License-Identifier: MIT
#
# Prints the namespace in which a header defines a structure, as A::B; nothing if it is in none. Usage:
# awk -v structure=Field -f namespace.awk HEADER
{ sub(/\/\/.*/, ""); text = text $0 " " }
END {
  gsub(/\/\*[^*]*\*+([^\/*][^*]*\*+)*\//, " ", text)
  while (match(text, /[A-Za-z_][A-Za-z_0-9]*|::|[^ \t\r]/)) {
    word = substr(text, RSTART, RLENGTH)
    text = substr(text, RSTART + RLENGTH)
    # struct Field {, struct Field : Base {, typedef struct {...} Field;
    if (last == structure && (word == "{" || word == ":") || before == "}" && last == structure && word == ";") {
      found = ""
      for (level = 1; level <= depth; ++level) {
        if (opened[level] != "") found = found (found == "" ? "" : "::") opened[level]
      }
      print found
      exit
    }
    if (word == "namespace") {
      is_name = 1
      name = ""
    } else if (word == "{") {
      opened[++depth] = is_name ? name : ""
      is_name = 0
    } else if (word == "}") {
      --depth
    } else if (word == ";" || word == "=") {
      is_name = 0
    } else if (is_name) {
      name = name word
    }
    before = last
    last = word
  }
}
