# SPDX-License-Identifier: MIT
#
# Reads all files of an old team and prints the names that it declares for itself and that the C library here has, too, but
# Microsoft's has not, or has in a header that the prefix of all sources includes: "function round", "macro M_PI". A function is one
# that is declared outside of all braces; if the team also calls it without having declared a function, it means the library's.
BEGIN {
  split("y0 y1 yn j0 j1 jn gamma signgam significand drem scalb round lround rint lrint trunc log2 exp2 cbrt fmin fmax fdim fma " \
        "remainder nearbyint logb ilogb nextafter hypot erf expm1 log1p asinh acosh atanh finite isnan isinf pow10 exp10 sincos " \
        "time clock timezone daylight index rindex basename ffs random srandom initstate setstate select div link read write open " \
        "close pipe dup pause access sleep alarm stat send bind connect accept listen socket signal kill wait getline getw putw " \
        "dprintf remove rename error step truncate sync isblank", words, " ")
  for (i in words) is_function[words[i]] = 1
  split("M_PI M_E M_PI_2 M_PI_4 M_LN2 M_SQRT2 M_1_PI M_2_PI INFINITY NAN HUGE FP_NAN FP_ZERO FP_NORMAL DOMAIN OVERFLOW UNDERFLOW SING", words, " ")
  for (i in words) is_macro[words[i]] = 1
}

FNR == 1 { braces = round_ones = 0; is_comment = 0; before = ""; opened = "" }

# Directives declare nothing.
/^[ \t]*#/ && !is_comment { next }

{
  sub(/\r$/, "")
  gsub(/\\./, "")
  gsub(/"[^"]*"/, "0")
  gsub(/'[^']*'/, "0")
  line = $0
  while (line != "") {
    if (is_comment) {
      at = index(line, "*/")
      if (at == 0) break
      is_comment = 0
      line = substr(line, at + 2)
    } else if (match(line, /^[A-Za-z_][A-Za-z_0-9]*/)) {
      name = substr(line, 1, RLENGTH)
      line = substr(line, RLENGTH + 1)
      after = line
      sub(/^[ \t]*/, "", after)
      after = substr(after, 1, 1)
      is_after_type = before ~ /^[A-Za-z_*&]/ && before !~ /^(return|else|case|goto|throw|new|delete|typedef|struct|class|enum|union)$/
      is_declared = is_after_type || (before == "," && is_declaring)
      if (name in is_macro && is_declared && after ~ /^[=;,[]/) own_macro[name] = 1
      if (name in is_function) {
        is_outside = braces == 0 && round_ones == 0 && is_declared && after ~ /^[=;,[(]?$/
        if (is_outside) declared[name] = 1
        if (is_outside && after == "(") defined[name] = 1
        if (!is_outside && after == "(" && before != "." && before != ">" && !is_after_type) called[name] = 1
      }
      if (name == "namespace" || name == "extern") opened = name
      if (round_ones == 0 && is_after_type) is_declaring = 1
      before = name
    } else {
      c = substr(line, 1, 1)
      if (substr(line, 1, 2) == "//") break
      if (substr(line, 1, 2) == "/*") {
        is_comment = 1
        line = substr(line, 3)
        continue
      }
      line = substr(line, 2)
      if (c == "{") {
        depth_of[++depth] = opened == ""
        braces += opened == ""
        opened = ""
      } else if (c == "}") {
        if (depth > 0) braces -= depth_of[depth--]
      } else if (c == "(") {
        ++round_ones
      } else if (c == ")" && round_ones > 0) {
        --round_ones
      }
      if (c == ";") opened = ""
      if (c == ";" || c == "}" || c == "{") is_declaring = 0
      if (c !~ /[ \t]/) before = c
    }
  }
}

END {
  for (name in declared) if (name in defined || !(name in called)) print "function", name
  for (name in own_macro) print "macro", name
}
