// SPDX-License-Identifier: MIT
//
// Which team gains by a decision, and which one offended.
#pragma once

#include "core/field/team.hpp"
#include "core/referee/decision.hpp"

#include <optional>

namespace mirocup::match {

struct Parties {
  std::optional<Team> gainer;    // the team to which the decision gives something
  std::optional<Team> offender;  // the team that broke the law

  bool operator==(const Parties&) const = default;
};

// `team` is the team that the decision names, `taker` the one that takes the restart.
Parties parties_of(const referee::Decision& decision, std::optional<Team> team, Team taker);

}  // namespace mirocup::match
