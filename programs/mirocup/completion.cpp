// SPDX-License-Identifier: MIT
//
// mirocup completion SHELL: prints the script by which a shell completes commands.
#include "programs/mirocup/commands.hpp"

namespace mirocup::app {

namespace {

struct CompletionOptions {
  std::string shell;
};

Result<int> run_completion(const CompletionOptions& options) {
  std::cout << completion_script(options.shell);
  return exit_yes;
}

}  // namespace

void add_completion(system::Commands& commands) {
  const auto [command, o] =
      commands.add(run_completion, "completion", for_shells,
                   "Print the script with which a shell completes commands",
                   {"mirocup completion bash >~/.local/share/bash-completion/completions/mirocup",
                    "mirocup completion fish >~/.config/fish/completions/mirocup.fish"});
  command.option("SHELL", o.shell, "Shell that reads the script")
      .required()
      .one_of({"bash", "zsh", "fish"});
}

}  // namespace mirocup::app
