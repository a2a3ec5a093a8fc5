// SPDX-License-Identifier: MIT
//
// A team's library, loaded into this process. What goes wrong here is the team's fault, told as
// one.
#pragma once

#include "core/match/controller.hpp"
#include "mirocup/strategy.h"

#include <tl/expected.hpp>

#include <string>

namespace mirocup::plugins {

// For setup.log where a team's error output is its log.
void write_line(const char* text);

class Plugin {
 public:
  // Loads the library at `path` (with a slash in it), checks its version and creates its team.
  // `setup` outlives the plugin. Foreign code runs from here on.
  static tl::expected<Plugin, match::Fault> load(const std::string& path,
                                                 const mirocup_setup& setup);

  Plugin(Plugin&& other) noexcept;
  Plugin& operator=(Plugin&&) = delete;
  ~Plugin();

  std::string name() const;

  // Calls the team; an exception that leaves it is a crash. The floating-point mode is that of the
  // caller before and after.
  tl::expected<mirocup_command, match::Fault> decide(const mirocup_observation& observation);

  // The same at a restart. A team without place() leaves everything where it is.
  tl::expected<mirocup_placement, match::Fault> place(const mirocup_observation& observation);

 private:
  Plugin(void* library, const mirocup_strategy* strategy, void* team)
      : library_(library), strategy_(strategy), team_(team) {}

  void* library_;
  const mirocup_strategy* strategy_;
  void* team_;
};

}  // namespace mirocup::plugins
