# The headers of the large libraries, parsed once for all sources that include them.
#
# mirocup_precompile(TARGET) gives a target these headers and, in a release build by clang++, no optimization: so compiled, a target
# takes less than half of g++'s time. g++ gains less and gets -O1. mirocup_precompile(TARGET PLAYED) is for what each leg or each replay
# page goes through; it gets -O1 from both. core, the programs of a team's process, house teams and prediction are
# compiled without these headers, with all optimization. mirocup_precompile(TARGET TESTS) adds GoogleTest's headers, and expects
# that the target links mirocup_unoptimized. A compiler takes headers only for the level that they were made for.
# The option is off by default if the compiler has a launcher, because ccache does not cache sources that use precompiled headers,
# and in the preset clang, which is there to find missing includes.
if(CMAKE_UNITY_BUILD AND NOT CMAKE_CXX_COMPILER_LAUNCHER AND NOT MIROCUP_CORE_ONLY)
  set(precompile_by_default ON)
else()
  set(precompile_by_default OFF)
endif()
option(MIROCUP_PRECOMPILED_HEADERS "Precompile the headers of the large libraries" ${precompile_by_default})

function(mirocup_add_precompiled name)
  find_package(nlohmann_json REQUIRED)
  find_package(tl-expected REQUIRED)
  add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
  target_link_libraries(${name} PRIVATE
    mirocup_options nlohmann_json::nlohmann_json tl::expected)
  target_precompile_headers(${name} PRIVATE
    <algorithm> <array> <charconv> <chrono> <cmath> <filesystem> <fstream> <functional> <iostream> <map>
    <memory> <nlohmann/json.hpp> <numeric> <optional> <set> <span> <sstream> <string> <string_view> <thread>
    <tl/expected.hpp> <unordered_map> <utility> <variant> <vector>)
endfunction()

set(played $<$<CONFIG:Release>:-O1>)
set(unplayed $<$<CONFIG:Release>:$<IF:$<CXX_COMPILER_ID:Clang>,-O0,-O1>>)
if(MIROCUP_PRECOMPILED_HEADERS)
  foreach(kind played unplayed)
    mirocup_add_precompiled(mirocup_precompiled_${kind})
    target_compile_options(mirocup_precompiled_${kind} PRIVATE ${${kind}})
  endforeach()
  if(MIROCUP_TESTS)
    find_package(GTest REQUIRED)
    mirocup_add_precompiled(mirocup_precompiled_tests)
    target_link_libraries(mirocup_precompiled_tests PRIVATE GTest::gtest mirocup_unoptimized)
    set_target_properties(mirocup_precompiled_tests PROPERTIES MIROCUP_LINKS_SANITIZED ON)
    target_precompile_headers(mirocup_precompiled_tests PRIVATE <gtest/gtest.h>)
  endif()
endif()

function(mirocup_precompile target)
  set(kind unplayed)
  if("TESTS" IN_LIST ARGN)
    set(kind tests)
  elseif("PLAYED" IN_LIST ARGN)
    set(kind played)
  endif()
  target_compile_options(${target} PRIVATE ${${kind}})
  if(NOT MIROCUP_PRECOMPILED_HEADERS)
    return()
  endif()
  # Programs, too, are compiled as libraries are (by default they get -fPIE): one set of headers for both.
  target_compile_options(${target} PRIVATE -fPIC)
  # In a precompiled std::string g++ 12 finds copies of 2^63 bytes that do not exist, as for -Wno-restrict in options.cmake. Builds
  # without precompiled headers keep these warnings.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
    $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread>)
  target_precompile_headers(${target} REUSE_FROM mirocup_precompiled_${kind})
endfunction()

# Gives a program the objects of libraries that are optimized, before its own. Of a template or an inline function that several
# objects have, the first one is linked, and a program whose own objects come first is slow in the libraries, too.
function(mirocup_link_played program)
  foreach(library ${ARGN})
    target_sources(${program} PRIVATE $<TARGET_OBJECTS:${library}>)
  endforeach()
endfunction()
