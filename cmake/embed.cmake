# Writes OUTPUT, a C++ source that holds the files of FOLDER named in FILES (separated by '|'). It defines the function
# std::string_view NAME(std::string_view), which HEADER declares in NAMESPACE.
# Usage: cmake -DOUTPUT=... -DFOLDER=... -DFILES=... -DNAMESPACE=... -DNAME=... -DHEADER=... -P embed.cmake
set(text "// Made by embed.cmake.\n#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n")
string(APPEND text "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n\n")
string(APPEND text "std::string_view ${NAME}(std::string_view name) {\n")
string(REPLACE "|" ";" files "${FILES}")
foreach(file IN LISTS files)
  file(READ "${FOLDER}/${file}" content)
  string(APPEND text "  if (name == \"${file}\") return R\"asset(${content})asset\";\n")
endforeach()
string(APPEND text "  return {};\n}\n\n}  // namespace ${NAMESPACE}\n")
file(WRITE "${OUTPUT}" "${text}")
