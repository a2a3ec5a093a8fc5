// SPDX-License-Identifier: MIT
//
// The trace of all bodies that a replay file keeps, so that a playback that diverges can name the
// body.
//
// The trace holds a fingerprint of one byte for each body and tick, of its position, heading and
// velocity. If the fingerprints of record and playback differ, the body's state differs. Every few
// seconds the trace also holds the whole state, which tells where the body was. The hash of a tick
// only tells that some number differs.
#pragma once

#include "core/match/leg.hpp"

#include <array>
#include <string>
#include <vector>

namespace mirocup::replay {

// Ticks between two checkpoints; the first checkpoint is after the first tick.
inline constexpr std::uint32_t checkpoint_ticks = 90;

// The state of all bodies after a tick. Bodies are numbered: blue robots, yellow robots, ball.
struct Checkpoint {
  std::array<simulator::BodyState, simulator::max_robots> robots;
  simulator::BallState ball;
};

// The fingerprint of each body after a tick.
using Fingerprints = std::array<std::uint8_t, simulator::max_bodies>;

struct StateTrace {
  std::vector<Fingerprints> ticks;      // empty, or one for each tick of the leg
  std::vector<Checkpoint> checkpoints;  // of the ticks 0, checkpoint_ticks, ...

  // Adds the tick that the leg has played last. To be called after every tick.
  void add(const match::Leg& leg);
};

// Returns the bodies whose fingerprints after the tick differ; `bodies` is the number of bodies.
std::vector<int> differing_bodies(const StateTrace& a, const StateTrace& b, std::size_t tick,
                                  int bodies);

// Returns "yellow robot 3" or "the ball".
std::string body_name(int body, int robots_per_team);

// Returns a text with the state of one body at the checkpoint, to all digits.
std::string body_text(const Checkpoint& checkpoint, int body, int robots_per_team);

}  // namespace mirocup::replay
