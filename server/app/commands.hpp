// SPDX-License-Identifier: MIT
//
// The subcommands of `mirocup`: each adds itself to the command line and says what to run.
#pragma once

#include "core/base/error.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace mirocup::app {

// Runs a subcommand; the value is the exit code of an answer (yes or no).
using Run = std::function<Result<int>()>;

// Each sets `run` if its subcommand was chosen.
void add_match(CLI::App& app, Run& run);
void add_check(CLI::App& app, Run& run);
void add_join(CLI::App& app, Run& run);
void add_new(CLI::App& app, Run& run);
void add_scene(CLI::App& app, Run& run);
void add_verify(CLI::App& app, Run& run);
void add_rerun(CLI::App& app, Run& run);
void add_replay(CLI::App& app, Run& run);
void add_referee(CLI::App& app, Run& run);

// `mirocup league ...` is the program mirocup-league, `mirocup bench ...` mirocup-bench: becomes that
// program with the arguments that follow. Does not return if it can be started.
Result<int> run_program(const std::string& name, int argc, char** argv);

}  // namespace mirocup::app
