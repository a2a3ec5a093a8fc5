# What every target is compiled with: warnings that fail the build, and the floating-point contract.

add_library(mirocup_options INTERFACE)
target_include_directories(mirocup_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(mirocup_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Werror
  # Not where several sources are compiled at once: a source may use a name that is another one's, too.
  $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>
  # g++ 12 warns of "text" + std::to_string(n) without reason (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # One multiplication and one addition must stay two roundings on every machine, or the state hash
  # of a match would depend on the compiler (core/README.md, "Bit for bit").
  -ffp-contract=off
  # None of these changes a result. Nobody replaces our functions when a program starts, asks errno about a square root, or traps
  # a floating-point exception: calls may be inlined, and branches be turned into selections.
  -fno-semantic-interposition -fno-math-errno -fno-trapping-math)

if(CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64)
  # By itself g++ copies and clears structs of some hundred bytes with `rep movs`, which takes longer to start than a call of
  # memcpy() does all of it: a twentieth of a tick.
  set(sizes unrolled_loop:64:noalign,libcall:-1:noalign)
  target_compile_options(mirocup_options INTERFACE
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-mmemcpy-strategy=${sizes}>
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-mmemset-strategy=${sizes}>)
endif()

# A target with the property MIROCUP_NOT_SANITIZED is built without sanitizers.
if(MIROCUP_SANITIZE)
  set(sanitized $<NOT:$<BOOL:$<TARGET_PROPERTY:MIROCUP_NOT_SANITIZED>>>)
  target_compile_options(mirocup_options INTERFACE
    "$<${sanitized}:-fsanitize=${MIROCUP_SANITIZE};-fno-sanitize-recover=all;-fno-omit-frame-pointer>")
  target_link_options(mirocup_options INTERFACE "$<${sanitized}:-fsanitize=${MIROCUP_SANITIZE}>")
endif()
