// SPDX-License-Identifier: MIT
#include "plugins/host/python_module.hpp"

#include <dlfcn.h>
#include <utility>

namespace mirocup::plugins {

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
  if (loaded.team == nullptr) return no_load(loaded.why);
  return Plugin::adopt(*loaded.strategy, loaded.team);
}

}  // namespace mirocup::plugins
