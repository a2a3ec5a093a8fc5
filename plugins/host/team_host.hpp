// SPDX-License-Identifier: MIT
//
// The host of a team: the target of `setup.host` of strategy.h, and the functions of the setup that
// take this pointer.
#pragma once

#include "mirocup/strategy.h"
#include "plugins/host/parameter_table.hpp"
#include "plugins/host/thoughts_page.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace mirocup::plugins {

// The caller owns the targets of the pointers below. `has_told_...` is true once the log has the
// line about the mistake, so that each mistake is logged only once.
struct TeamHost {
  const ParameterTable* table = nullptr;
  AskedRows* asked = nullptr;
  ThoughtsPage* thoughts = nullptr;  // null: the team's shapes are not kept
  // Hashes of the names that the team asked for and the table lacks: the first names, each once.
  std::array<std::size_t, match::max_team_parameters + 1> names{};
  std::size_t different_names = 0;
  bool has_told_name = false;
  bool has_told_parameter = false;
  std::uint32_t shapes = 0;  // number of shapes of this tick, dropped shapes included
  bool has_told_shapes = false;
  bool has_told_heading = false;
  bool has_told_place = false;
  bool has_told_robot = false;
  bool has_told_colour = false;
  bool has_told_number = false;
  std::string last_line = {};  // last line of the log, at most 200 bytes
};

// The most bytes of a name from a library that is still shown; leagues have the same limit.
inline constexpr std::size_t max_own_name = 40;

// The prefix of the host's lines in the team's log; `mirocup check` shows these lines as warnings.
inline constexpr const char* line_of_host = "mirocup: ";

// Sets the host and its functions in the setup. Those that draw put a shape on the page of the
// TeamHost at `host`. A shape is dropped and counted if there is no room for it, if a number is not
// finite, or if a polygon has fewer than 3 or more than max_polygon_corners corners. Logs a line,
// once, about too many shapes in a tick, and a line, once, about an invisible colour, even if no
// shapes are kept.
void give_host(mirocup_setup& setup, TeamHost& host);

// The function `setup.log`: writes a line to standard error, which is the team's log, and keeps it
// in the TeamHost at `host`, which may be null.
void log_line(void* host, const char* text);

// Returns the last line that the team has logged, as ": "the line""; "" if the team has logged no
// line, or if the log of the setup is not log_line().
std::string reason_in_log(const mirocup_setup& setup);

// The function `setup.parameter`: returns the value of a name in the table of the TeamHost at
// `host` and marks the name as asked for; `fallback` if the table or the name is missing. Logs a
// line, once, about a name that no parameter can have, and a line, once, about too many names.
double parameter_of(void* host, const char* name, double fallback);

// Logs a line, once, about a requested heading of more than a full turn, which is probably not in
// radians, and a line, once, about a requested place far outside of every pitch.
void note_units(TeamHost& host, const mirocup_placement& placement, std::int32_t robots);

// Logs a line if the team's own name is not shown, because it is too long or not one line.
void note_own_name(TeamHost& host, const std::string& name);

// Logs a line, once, about commands to robots that the team does not have.
void note_command(TeamHost& host, const mirocup_command& command, std::int32_t robots);

}  // namespace mirocup::plugins
