// SPDX-License-Identifier: MIT
#include "server/app/commands.hpp"
#include "system/child_process.hpp"
#include "system/locations.hpp"

namespace mirocup::app {

Result<int> become_sibling_program(const std::string& name, int argc, char** argv) {
  std::vector<std::string> arguments{system::sibling_program(name)};
  arguments.insert(arguments.end(), argv + 2, argv + argc);
  return tl::unexpected(system::become_program(std::move(arguments)));
}

}  // namespace mirocup::app
