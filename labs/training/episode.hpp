// SPDX-License-Identifier: MIT
//
// The data with which an episode can be played again: its seed, the commands of each tick, and the
// placement requests at restarts. All other data follow from these.
#pragma once

#include "core/match/leg.hpp"
#include "labs/training/config.hpp"
#include "record/match_record.hpp"
#include "system/files.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace mirocup::training {

struct Episode {
  std::uint64_t seed = 1;
  // Left and right wheel of each robot of blue, then of yellow, tick after tick, as
  // match::DrivenCommand has them.
  std::vector<std::int16_t> wheels;
  std::vector<match::LoggedPlacementRequest> requests;  // in the order of the ticks
  std::vector<match::TeamFault> faults;                 // the faults that ended the episode

  std::uint32_t ticks(int robots) const {
    return static_cast<std::uint32_t>(wheels.size() / (4 * static_cast<std::size_t>(robots)));
  }

  // Adds the tick that the leg has played last.
  void add_tick(const match::Leg& leg);

  // Returns the answers to the observation of a tick.
  match::ByTeam<match::Answer> answers(std::uint32_t tick, int robots) const;
};

// Plays the episode again and writes it as a record, with its replay beside it. A truncated or
// unfinished episode becomes a void leg.
Result<void> save_record(const Config& config, const Episode& episode, const std::string& path);

}  // namespace mirocup::training
