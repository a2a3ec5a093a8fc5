// SPDX-License-Identifier: MIT
//
// The subcommands of `mirocup league`.
#pragma once

#include "core/base/error.hpp"

#include <CLI/CLI.hpp>

#include <functional>

namespace mirocup::league {

// Runs a subcommand; the value is the exit code of an answer (yes or no).
using Run = std::function<Result<int>()>;

// Making, playing and showing a league.
void add_init(CLI::App& app, Run& run);
void add_start(CLI::App& app, Run& run);
void add_stop(CLI::App& app, Run& run);
void add_status(CLI::App& app, Run& run);
void add_publish(CLI::App& app, Run& run);
void add_export(CLI::App& app, Run& run);
void add_credentials(CLI::App& app, Run& run);

// Showing it while it is played.
void add_serve(CLI::App& app, Run& run);

// Playing on other machines: plan, run-shard.
void add_shards(CLI::App& app, Run& run);

// Entries.
void add_submit(CLI::App& app, Run& run);
void add_compare(CLI::App& app, Run& run);

// What a person decides: award, rule, void, withdraw, pause, resume.
void add_rulings(CLI::App& app, Run& run);

}  // namespace mirocup::league
