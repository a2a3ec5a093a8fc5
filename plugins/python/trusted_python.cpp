// SPDX-License-Identifier: MIT
//
// mirocup-python.so: the interpreter for `mirocup match --trusted`, loaded when a team needs it, so
// that mirocup itself does not depend on Python.
#include "plugins/host/host_program.hpp"
#include "plugins/python/python_team.hpp"

#include <algorithm>
#include <cstring>
#include <dlfcn.h>
#include <fstream>
#include <iterator>

namespace mirocup::plugins {

extern "C" MIROCUP_PUBLIC void mirocup_python_load(const char* path, const mirocup_setup* setup,
                                                   PythonLoaded* loaded) {
  // Modules of Python that are libraries need the interpreter's symbols and do not name it.
  dlopen(MIROCUP_PYTHON_SONAME, RTLD_NOW | RTLD_GLOBAL | RTLD_NOLOAD);
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto team = python::load_team(text, path, *setup, python::Surrounding::developer);
  *loaded = {};
  if (team) {
    loaded->strategy = team->strategy;
    loaded->team = team->team;
    return;
  }
  team.error().cause.copy(loaded->cause, sizeof loaded->cause - 1);
  loaded->line = team.error().line;
  const std::string& why = team.error().text;
  std::memcpy(loaded->why, why.data(), std::min(why.size(), sizeof loaded->why - 1));
}

}  // namespace mirocup::plugins
