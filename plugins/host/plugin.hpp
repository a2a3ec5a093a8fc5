// SPDX-License-Identifier: MIT
//
// A team's library, loaded into this process. Errors of the library and exceptions that leave it
// are returned as faults of the team.
#pragma once

#include "core/match/controller.hpp"
#include "mirocup/strategy.h"

#include <tl/expected.hpp>

#include <stdexcept>
#include <string>
#include <utility>

namespace mirocup::plugins {

// Writes a line to standard error, which is the team's log.
void write_line(const char* text);

// An exception of a team in another language, which knows its cause.
struct RaisedError : std::runtime_error {
  RaisedError(const std::string& text, std::string why, int at)
      : std::runtime_error(text), cause(std::move(why)), line(at) {}

  std::string cause;
  int line;  // Fault::line
};

class Plugin {
 public:
  // Loads the library at `path`, checks its version and creates its team. The path must contain a
  // slash, because dlopen() searches the system's folders for a bare name. `setup` must outlive the
  // plugin. From this call on foreign code runs in this process. If create() returns null, the
  // fault has the last line that the team has logged through log_line() (team_host.hpp).
  static tl::expected<Plugin, match::Fault> load(const std::string& path,
                                                 const mirocup_setup& setup);

  // Wraps a team that other code of this process has created with the functions of `strategy`. The
  // plugin does not call destroy() for such a team.
  static Plugin adopt(const mirocup_strategy& strategy, void* team) {
    return Plugin(nullptr, &strategy, team);
  }

  // Returns why load() would refuse the library at `path`, judged by its file, version and
  // functions without creating a team.
  static tl::expected<void, match::Fault> check(const std::string& path);

  Plugin(Plugin&& other) noexcept;
  Plugin& operator=(Plugin&&) = delete;
  ~Plugin();

  // Returns the name that the library gives its team; "" if it gives no name.
  std::string name() const;

  // Calls decide(). An exception that leaves decide() is a crash. The caller's floating-point mode
  // is restored after the call.
  tl::expected<mirocup_command, match::Fault> decide(const mirocup_observation& observation);
  // Like the overload above, but the caller gives the memory for the command, all zeros.
  tl::expected<mirocup_command, match::Fault> decide(const mirocup_observation& observation,
                                                     mirocup_command& command);

  // Calls place() at a restart. If the team has no place(), all bodies stay.
  tl::expected<mirocup_placement, match::Fault> place(const mirocup_observation& observation);

 private:
  Plugin(void* library, const mirocup_strategy* strategy, void* team)
      : library_(library), strategy_(strategy), team_(team) {}

  static tl::expected<Plugin, match::Fault> open(const std::string& path);

  void* library_;
  const mirocup_strategy* strategy_;
  void* team_;
};

}  // namespace mirocup::plugins
