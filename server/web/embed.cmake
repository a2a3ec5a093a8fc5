# Writes OUTPUT, a C++ source that holds the files of FOLDER named in FILES (separated by '|') for assets.hpp.
# Usage: cmake -DOUTPUT=... -DFOLDER=... -DFILES=... -P embed.cmake
set(text "// Made by embed.cmake.\n#include \"server/web/assets.hpp\"\n\nnamespace mirocup::web {\n\n")
string(APPEND text "std::string_view asset(std::string_view name) {\n")
string(REPLACE "|" ";" files "${FILES}")
foreach(file IN LISTS files)
  file(READ "${FOLDER}/${file}" content)
  string(APPEND text "  if (name == \"${file}\") return R\"asset(${content})asset\";\n")
endforeach()
string(APPEND text "  return {};\n}\n\n}  // namespace mirocup::web\n")
file(WRITE "${OUTPUT}" "${text}")
