// SPDX-License-Identifier: MIT
//
// The story of a trial leg for the author of the entry: the score, and the behaviour of the robots.
#pragma once

#include "core/match/leg.hpp"

#include <array>
#include <string>

namespace mirocup::app {

// A share is a part of the time in which the ball was in play, as a mean over the entry's robots.
struct LegStory {
  Team team = Team::blue;        // the colour of the entry
  std::string opponent;          // a house team
  std::array<int, 2> score{};    // goals for the entry, and against it
  int own_goals = 0;             // own goals of the entry
  double standing = 0.0;         // share: stood still
  double turning = 0.0;          // share: turned in place
  double backwards = 0.0;        // share: drove backwards
  double fastest_wheel = 0.0;    // the fastest command of the entry, rad/s
  double towards_own_end = 0.0;  // the part of given_speed towards the own end, 0 to 1
  double given_speed = 0.0;      // sum of the speeds along x that the entry gave the ball, m/s
  unsigned told_left = 0;        // bit i: a command turned the left wheel of robot i
  unsigned told_right = 0;       // bit i: a command turned the right wheel of robot i
};

// Watches the leg of an entry tick by tick.
class LegWatch {
 public:
  LegWatch(const match::Leg& leg, Team team) : leg_(leg), team_(team) {}

  // To be called after each tick.
  void look();

  LegStory story() const;

 private:
  void look_at_robots();
  void look_at_ball();

  const match::Leg& leg_;
  Team team_;
  simulator::BallState ball_before_;
  LegStory sums_;
  double towards_opponent_ = 0.0;  // speed that touches gave the ball, m/s
  double towards_own_ = 0.0;
  std::size_t robot_ticks_ = 0;
};

// Returns "3 : 5 against striker as blue, 1 own goal; its robots stood in 10 % of play, ...".
std::string text_of(const LegStory& story);

}  // namespace mirocup::app
