# The options that every target is compiled with: warnings, and the floating-point contract.

option(MIROCUP_WERROR "Warnings fail the build" ${PROJECT_IS_TOP_LEVEL})

add_library(mirocup_options INTERFACE)
target_include_directories(mirocup_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(mirocup_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion
  # Not in a unity build, in which a local variable may have the name of another source's constant. What g++ can still tell
  # there is a local variable that hides another one.
  $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>
  $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>
  # g++ 12 warns of "text" + std::to_string(n) without reason (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # One multiplication and one addition must stay two roundings on every machine, or the state hash
  # of a match would depend on the compiler (core/README.md, "Bit for bit").
  -ffp-contract=off
  # None of these changes a result. No program replaces our functions when it starts, asks errno about a square root, or traps
  # a floating-point exception: calls may be inlined, and branches be turned into selections.
  -fno-semantic-interposition -fno-math-errno -fno-trapping-math)
# g++ begins at 128 MB to look for memory to give back, which takes a fifth of its time. The largest groups of sources need 1.4 GB.
target_compile_options(mirocup_options INTERFACE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:--param=ggc-min-heapsize=1000000>)
if(MIROCUP_WERROR)
  target_compile_options(mirocup_options INTERFACE -Werror)
endif()
# Eigen's packets would use fused multiply-add on some machines: a pitch or a rating would depend on them.
target_compile_definitions(mirocup_options INTERFACE EIGEN_DONT_VECTORIZE)
# A value becomes a number or a text where get<…>() says so. A json that could turn into anything costs a quarter of the time of
# compiling each source that uses one.
target_compile_definitions(mirocup_options INTERFACE JSON_USE_IMPLICIT_CONVERSIONS=0)

if(CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64)
  # By default g++ copies and clears structs of some hundred bytes with `rep movs`. A call of memcpy() takes less time than that
  # instruction needs to start: a twentieth of a tick.
  set(sizes unrolled_loop:64:noalign,libcall:-1:noalign)
  target_compile_options(mirocup_options INTERFACE
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-mmemcpy-strategy=${sizes}>
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-mmemset-strategy=${sizes}>)
endif()

# A target with the property MIROCUP_NOT_SANITIZED is built without sanitizers. One with MIROCUP_LINKS_SANITIZED, a program of unit
# tests, links sanitized libraries, but its own sources are compiled without sanitizers, in half of the time.
if(MIROCUP_SANITIZE)
  set(sanitized_definition MIROCUP_SANITIZED)  # for tests that do less then
  set(plain $<BOOL:$<TARGET_PROPERTY:MIROCUP_NOT_SANITIZED>>)
  set(links $<BOOL:$<TARGET_PROPERTY:MIROCUP_LINKS_SANITIZED>>)
  target_compile_options(mirocup_options INTERFACE
    "$<$<NOT:$<OR:${plain},${links}>>:-fsanitize=${MIROCUP_SANITIZE};-fno-sanitize-recover=all;-fno-omit-frame-pointer>")
  target_link_options(mirocup_options INTERFACE "$<$<NOT:${plain}>:-fsanitize=${MIROCUP_SANITIZE}>")
endif()
find_program(MIROCUP_LLD ld.lld)
if(MIROCUP_LLD AND CMAKE_CXX_COMPILER_ID STREQUAL Clang)  # it links code that is not optimized in a quarter of the time
  target_link_options(mirocup_options INTERFACE -fuse-ld=lld)
endif()

# Code whose speed does not matter is compiled for a short build: g++ needs half of the time without optimization (tests), and a
# third less with a little (precompiled.cmake: everything that a leg hardly goes through).
add_library(mirocup_unoptimized INTERFACE)
target_compile_options(mirocup_unoptimized INTERFACE $<$<CONFIG:Release>:-O0>)
