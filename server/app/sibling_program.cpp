// SPDX-License-Identifier: MIT
#include "server/app/commands.hpp"
#include "server/system/locations.hpp"

#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace mirocup::app {

Result<int> run_program(const std::string& name, int argc, char** argv) {
  std::string program = system::sibling_program(name);
  std::vector<char*> arguments{program.data()};
  for (int i = 2; i < argc; ++i) arguments.push_back(argv[i]);
  arguments.push_back(nullptr);
  execv(program.c_str(), arguments.data());
  return fail(Errc::unavailable, program + " cannot be run: " + std::strerror(errno));
}

}  // namespace mirocup::app
