// SPDX-License-Identifier: MIT
//
// One tick of a leg for the counter: plain data, so that a test can write a tick by hand. All
// values are in the field's frame, in m and m/s.
#pragma once

#include "record/statistics/statistics.hpp"

#include <span>

namespace mirocup::statistics {

struct PlayTick {
  std::uint32_t tick = 0;
  bool is_play = true;  // play was on in the tick; otherwise only `decisions` matters
  bool goes_on = true;  // play is on after the tick
  referee::Phase phase = referee::Phase::FIRST_HALF;
  Team left = Team::blue;               // the team that defends the left end
  Vec2 ball{0.0, 0.0};                  // at the end of the tick
  Vec2 ball_velocity{0.0, 0.0};         // at the end of the tick; meaningless unless goes_on
  ByTeam<referee::RobotSet> touched{};  // the robots that touched the ball
  ByTeam<double> driven{};              // the distance that all robots of a team drove, m
  std::span<const match::LoggedDecision> decisions;  // of this tick, in their order
};

// Turns the ticks of a leg into PlayTicks.
class LegWatcher {
 public:
  // To be made before the first tick of the leg.
  explicit LegWatcher(const match::Leg& leg);

  // To be called after each tick. The result points into the leg.
  PlayTick see(const match::Leg& leg);

 private:
  match::Snapshot before_;
  std::size_t decisions_ = 0;  // number of decisions already passed on
};

}  // namespace mirocup::statistics
