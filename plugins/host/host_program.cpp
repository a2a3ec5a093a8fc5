// SPDX-License-Identifier: MIT
#include "plugins/host/host_program.hpp"

#include "plugins/host/launch.hpp"
#include "system/locations.hpp"

#include <filesystem>

namespace mirocup::plugins {

namespace {

Result<std::string> part_for_python(const char* name) {
  const std::string path = system::sibling_program(name);
  std::error_code none;
  if (std::filesystem::exists(path, none)) return path;
  return fail(Errc::unavailable, path +
                                     " is missing, so no team in Python can play: install the "
                                     "package python3-mirocup, or libpython3-dev before the build");
}

}  // namespace

Result<std::string> host_program(const SealedEntry& entry, Care care) {
  if (entry.is_python()) return part_for_python(python_host);
  return system::sibling_program(care == Care::watched ? careful_host : library_host);
}

Result<std::string> python_module() {
  return part_for_python("mirocup-python.so");
}

}  // namespace mirocup::plugins
