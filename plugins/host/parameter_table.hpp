// SPDX-License-Identifier: MIT
//
// The parameters of a team in a fixed form that fits into the mailbox.
#pragma once

#include "core/match/team_parameters.hpp"

#include <array>
#include <atomic>
#include <cstdint>

namespace mirocup::plugins {

struct ParameterTable {
  struct Row {
    char name[match::max_parameter_name + 1] = {};  // ends with a zero
    double value = 0.0;
  };

  std::uint32_t count = 0;  // number of used rows
  std::array<Row, match::max_team_parameters> rows{};
};

// Returns the table of the parameters, in the same order. Precondition: problem_with() finds
// nothing wrong with them.
ParameterTable parameter_table(const match::TeamParameters& parameters);

// A bit for each row of a table, from the lowest bit on: 1 if the team asked for the row's name.
using AskedRows = std::atomic<std::uint32_t>;
static_assert(match::max_team_parameters <= 32);

// Returns the given parameters that the team has not asked for.
match::TeamParameters not_asked_for(const match::TeamParameters& parameters, std::uint32_t asked);

}  // namespace mirocup::plugins
