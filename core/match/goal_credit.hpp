// SPDX-License-Identifier: MIT
//
// The credit of a goal: its scorer, the team-mate who passed the ball, and how the goal came about.
//
// A parry that does not keep the ball out is not an own goal. So a touch of a defender counts only
// if it changed the outcome: the simulator lets the ball roll on alone from where it was before
// that touch, and if it crosses the line all the same, the goal is the attacker's. Own goals count
// like any other goal.
#pragma once

#include "core/base/names.hpp"
#include "core/field/team.hpp"
#include "core/match/snapshot.hpp"
#include "core/simulator/world.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace mirocup::match {

// A robot that touched the ball.
struct Touch {
  Team team = Team::blue;
  int robot = 0;

  bool operator==(const Touch&) const = default;
};

// How a goal came about. A goal belongs to the last restart if the taker's team (at a free ball,
// either team) scores before an opponent has touched the ball. It is a rebound if a defender saved
// a ball that would have gone in and the scorer touched the ball less than rebound_s later.
enum class GoalKind {
  open_play,
  kick_off,
  goal_kick,
  penalty,
  free_kick,
  free_ball,
  shoot_out,  // reserved: an attempt of a shoot-out is not a goal
  rebound,
};

inline constexpr double rebound_s = 1.0;

struct GoalCredit {
  std::optional<Touch>
      scorer;  // of an own goal, the defender; nothing if no robot touched the ball
  std::optional<Touch> assist;  // the team-mate who touched the ball before the scorer, if no
                                // opponent did in between
  bool own_goal = false;
  GoalKind kind = GoalKind::open_play;

  bool operator==(const GoalCredit&) const = default;
};

// The contacts of robots with the ball since the last restart.
class BallContacts {
 public:
  // A robot that touches the ball in consecutive ticks has one contact.
  struct Contact {
    Touch who;
    std::uint32_t first = 0;      // tick
    std::uint32_t last = 0;       // tick
    simulator::BallState before;  // the ball at the start of tick `first`
  };

  void forget() { count_ = 0; }

  // Adds a touch in a tick. `before` is the ball at the start of the tick.
  void add(std::uint32_t tick, const Touch& who, const simulator::BallState& before);

  // The contacts, newest first. Only the newest `capacity` are kept.
  std::span<const Contact> all() const { return {contacts_.data(), count_}; }

 private:
  static constexpr std::size_t capacity = 32;
  std::array<Contact, capacity> contacts_;
  std::size_t count_ = 0;
};

// The facts of a goal.
struct Goal {
  Team scoring = Team::blue;                          // the team for which it counts
  End end = End::left;                                // of the goal
  referee::Restart restart = referee::Restart::none;  // the last restart
  Team taker = Team::blue;                            // of that restart
  double control_period = 0.0;                        // s
};

// Returns whose goal it is. `parameters` are those that move the ball in this leg.
GoalCredit credit_of(const Goal& goal, const BallContacts& contacts, const field::Field& field,
                     const simulator::Parameters& parameters);

// Returns true if the ball, rolling on alone among walls and posts, goes into the goal at `end`.
bool would_go_in(const simulator::BallState& ball, End end, const field::Field& field,
                 const simulator::Parameters& parameters, double control_period);

}  // namespace mirocup::match

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 8> enum_names<match::GoalKind>{
    "open_play", "kick_off",  "goal_kick", "penalty",
    "free_kick", "free_ball", "shoot_out", "rebound"};

}  // namespace mirocup
