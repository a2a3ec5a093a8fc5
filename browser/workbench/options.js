// SPDX-License-Identifier: MIT
//
// How teams are compiled in a page: as in a league (plugins/host/project/compiler_command.hpp), with as much stack and memory as a team
// has there.
export const compiling = ['-std=c++20', '-O2', '-DNDEBUG', '-ffp-contract=off', '-fno-exceptions', '-ftemplate-depth=900', '-Woverloaded-virtual',
  '-fno-color-diagnostics', '-ferror-limit=20', '-Iinclude'];
export const linking = ['-mexec-model=reactor', '-Wl,-z,stack-size=8388608', '-Wl,--stack-first', '-Wl,--strip-all', '-Wl,--max-memory=1073741824'];
