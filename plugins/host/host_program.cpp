// SPDX-License-Identifier: MIT
#include "plugins/host/host_program.hpp"

#include "plugins/host/launch.hpp"
#include "system/locations.hpp"

#include <dlfcn.h>
#include <filesystem>
#include <utility>

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

tl::expected<Plugin, match::Fault> load_python(const std::string& path, const std::string& module,
                                               const mirocup_setup& setup) {
  const auto no_load = [](std::string why) {
    return tl::unexpected(match::Fault{match::FaultCode::no_load, std::move(why)});
  };
  void* library = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return no_load(std::string("Python is not here: ") + dlerror());
  const auto load =
      reinterpret_cast<decltype(&mirocup_python_load)>(dlsym(library, "mirocup_python_load"));
  if (load == nullptr) return no_load(module + " is of another version");
  PythonLoaded loaded{};
  load(path.c_str(), &setup, &loaded);
  if (loaded.team == nullptr)
    return tl::unexpected(
        match::Fault{match::FaultCode::no_load, loaded.why, loaded.cause, loaded.line});
  return Plugin::adopt(*loaded.strategy, loaded.team);
}

}  // namespace mirocup::plugins
