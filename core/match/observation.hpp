// SPDX-License-Identifier: MIT
//
// The observation of a team at the start of a tick: the state of all bodies, exact or as a camera
// sees it, in the team's own frame, in which it attacks +x. Metres, radians counter-clockwise, m/s,
// rad/s.
#pragma once

#include "core/match/snapshot.hpp"
#include "core/simulator/model/parameters.hpp"

#include <array>
#include <cstdint>

namespace mirocup::match {

struct Observation {
  std::uint32_t tick = 0;
  double time = 0.0;   // simulated time since the start of the leg, s
  double clock = 0.0;  // of the current phase, s
  State state = State::READY;
  referee::Phase phase = referee::Phase::FIRST_HALF;
  referee::Restart restart = referee::Restart::none;  // the last restart
  bool own_restart = false;                           // the observing team takes this restart
  bool placing = false;  // the team may ask for a placement in its answer
  int own_score = 0;
  int opponent_score = 0;
  int robots = 0;  // of each team
  // The referee's pending counts, from which a team can tell that a call is near.
  double stalemate_s = 0.0;
  double advantage_s = 0.0;
  referee::TeamCounts own_counts;
  referee::TeamCounts opponent_counts;
  Vec2 ball{0.0, 0.0};
  Vec2 ball_velocity{0.0, 0.0};
  int ball_age = 0;  // ticks since a camera saw the ball like this; 0 without a camera
  std::array<ObservedRobot, max_robots_per_team> own;
  std::array<ObservedRobot, max_robots_per_team> opponent;
};

// Returns the snapshot as a team observes it. `robots` is the number of robots of each team, at
// most max_robots_per_team.
Observation observe(const Snapshot& scene, Team team, int robots);

// The facts of a leg, which a team receives once, before the first observation. The pointers are
// valid while the leg exists.
struct Briefing {
  const field::Field* field = nullptr;
  const simulator::Parameters* parameters = nullptr;
  const referee::Rules* rules = nullptr;
  double control_period = 0.0;  // s
  Team team = Team::blue;
  std::uint64_t seed = 0;  // for the team's own random numbers; different for the two teams
};

}  // namespace mirocup::match
