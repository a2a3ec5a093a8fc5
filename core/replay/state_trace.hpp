// SPDX-License-Identifier: MIT
//
// What every body did, as far as a replay keeps it: one byte for each body and tick, which says
// whether it was where a playback has it, and the whole state every few seconds, which says where
// it was instead. The hash of a tick only says that something differs.
#pragma once

#include "core/match/leg.hpp"

#include <array>
#include <string>
#include <vector>

namespace mirocup::replay {

// Ticks between two checkpoints; the first is after the first tick.
inline constexpr std::uint32_t checkpoint_ticks = 90;

// Bodies are numbered blue robots, yellow robots, ball.
struct Checkpoint {
  std::array<simulator::BodyState, simulator::max_robots> robots;
  simulator::BallState ball;
};

using Fingerprints = std::array<std::uint8_t, simulator::max_bodies>;

struct StateTrace {
  std::vector<Fingerprints> ticks;      // empty, or one for each tick of the leg
  std::vector<Checkpoint> checkpoints;  // of the ticks 0, checkpoint_ticks, ...

  // Takes down the tick that the match has played last; to be called after each.
  void add(const match::Leg& leg);
};

// The bodies whose fingerprints after the tick differ.
std::vector<int> differing_bodies(const StateTrace& a, const StateTrace& b, std::size_t tick,
                                  int bodies);

// "yellow robot 3", "the ball"
std::string body_name(int body, int robots_per_team);

// Everything that the checkpoint says of a body: where it is and how fast.
std::string body_text(const Checkpoint& checkpoint, int body, int robots_per_team);

}  // namespace mirocup::replay
