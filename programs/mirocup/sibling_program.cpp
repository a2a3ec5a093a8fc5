// SPDX-License-Identifier: MIT
#include "programs/mirocup/commands.hpp"
#include "system/child_process.hpp"
#include "system/locations.hpp"

#include <unistd.h>

namespace mirocup::app {

Result<int> become_sibling_program(const std::string& name, int argc, char** argv, int first) {
  std::vector<std::string> arguments{system::sibling_program(name)};
  if (access(arguments[0].c_str(), F_OK) != 0) {
    return fail(
        Errc::unavailable,
        arguments[0] +
            ": this program is not built; cmake --build --preset release builds everything");
  }
  arguments.insert(arguments.end(), argv + first, argv + argc);
  return tl::unexpected(system::become_program(std::move(arguments)));
}

}  // namespace mirocup::app
