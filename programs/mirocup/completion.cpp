// SPDX-License-Identifier: MIT
//
// mirocup completion SHELL: prints the script by which a shell completes commands.
#include "programs/mirocup/commands.hpp"
#include "system/command_help.hpp"

#include <iostream>

namespace mirocup::app {

Result<int> run_completion(const CompletionOptions& options) {
  std::cout << system::completion_script(options.shell, "mirocup");
  return exit_yes;
}

}  // namespace mirocup::app
