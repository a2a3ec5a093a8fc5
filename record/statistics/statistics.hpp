// SPDX-License-Identifier: MIT
//
// The statistics of football: plain numbers of one leg. docs/statistics.md defines each number,
// counter.hpp counts.
//
// Times are in seconds, lengths in metres. The place of a touch, shot or pass is in the frame of
// the team that made it, which attacks +x. A shoot-out does not count.
#pragma once

#include "core/base/vec2.hpp"
#include "core/match/leg.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace mirocup::statistics {

using match::ByTeam;

// The kind of a goal, from the view of the team for which it counts: match::GoalKind, or an own
// goal of the opponents. Attempts of a shoot-out are not goals.
enum class GoalOrigin {
  open_play,
  kick_off,
  goal_kick,
  penalty,
  free_kick,
  free_ball,
  rebound,
  own_goal,
};

// A third of the field along its length, from the view of a team.
enum class Third { own, middle, opponent };

// How a team lost the ball to the opponents while play was on.
enum class LossKind {
  interception,  // the ball was on its way, and an opponent was the next to touch it
  save,          // an interception of a ball on its way into the goal
  tackle,        // an opponent took it from the team's robots
};

}  // namespace mirocup::statistics

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 8> enum_names<statistics::GoalOrigin>{
    "open_play", "kick_off",  "goal_kick", "penalty",
    "free_kick", "free_ball", "rebound",   "own_goal"};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<statistics::Third>{"own", "middle",
                                                                               "opponent"};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<statistics::LossKind>{"interception",
                                                                                  "save", "tackle"};

}  // namespace mirocup

namespace mirocup::statistics {

// One number for each enumerator of E: [static_cast<std::size_t>(e)].
template <class E>
using PerName = std::array<int, enum_names<E>.size()>;

template <class E>
constexpr std::size_t at(E e) {
  return static_cast<std::size_t>(e);
}

struct TeamStatistics {
  PerName<GoalOrigin> goals{};
  int shots = 0;
  int shots_on_goal = 0;
  int saves = 0;
  int passes = 0;
  int interceptions = 0;
  PerName<Third> losses{};  // losses of the ball, by the third in which the team touched it last
  int duels_won = 0;
  PerName<referee::Law> fouls{};
  double possession_s = 0.0;
  double opponent_half_s = 0.0;  // time of play with the ball in the opponents' half
  double distance_m = 0.0;       // sum of the ways that the team's robots drove in play

  int all_goals() const;
  int all_losses() const;
  int all_fouls() const;

  TeamStatistics& operator+=(const TeamStatistics& other);
  bool operator==(const TeamStatistics&) const = default;
};

// The loss of the ball that came before a goal.
struct Loss {
  std::uint32_t tick = 0;  // the tick in which an opponent got the ball
  LossKind kind = LossKind::tackle;
  Vec2 place{0.0, 0.0};  // where the losing team touched the ball last
  Third third = Third::own;
};

// A goal, and the events before it.
struct Goal {
  std::uint32_t tick = 0;
  Team team = Team::blue;  // the team for which the goal counts
  GoalOrigin origin = GoalOrigin::open_play;
  std::optional<match::Touch> scorer;
  referee::Restart restart = referee::Restart::none;  // the last restart before the goal
  referee::Law restart_law = referee::Law::toss;      // the law that gave this restart
  Team taker = Team::blue;                            // the team that took this restart
  double since_restart = 0.0;                         // s of play
  // The last loss of the ball by the conceding team since the restart; empty if there is none.
  std::optional<Loss> loss;
};

// A counted shot and its outcome.
struct ShotMark {
  std::uint32_t tick = 0;  // the tick in which the shot began
  Team team = Team::blue;
  Vec2 place{0.0, 0.0};  // where the team touched the ball last before the shot
  bool on_goal = false;
  bool is_goal = false;

  bool operator==(const ShotMark&) const = default;
};

// A counted pass.
struct PassMark {
  std::uint32_t tick = 0;  // the tick in which the mate touched the ball
  Team team = Team::blue;
  Vec2 from{0.0, 0.0};
  Vec2 to{0.0, 0.0};

  bool operator==(const PassMark&) const = default;
};

struct Foul {
  std::uint32_t tick = 0;
  Team team = Team::blue;  // the team that offended
  referee::Law law = referee::Law::push;
  referee::Restart restart = referee::Restart::none;  // the restart for the opponents
};

struct LegStatistics {
  ByTeam<TeamStatistics> teams;
  double play_s = 0.0;
  double dead_ball_s = 0.0;  // time from each decision to the next whistle
  int stoppages = 0;         // restarts, without those that open a half
  int duels = 0;             // also duels that no team won
  std::vector<Goal> goals;   // in the order of their ticks
  std::vector<Foul> fouls;   // in the order of their ticks
  std::vector<ShotMark> shots;
  std::vector<PassMark> passes;
};

// Returns the share of `one` in `one + other`; nothing if both are 0.
std::optional<double> share(double one, double other);

}  // namespace mirocup::statistics
