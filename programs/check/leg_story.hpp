// SPDX-License-Identifier: MIT
//
// The story of a trial leg for the author of the entry: the score, and the behaviour of the robots.
#pragma once

#include "core/match/leg.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

namespace mirocup::app {

// The habits of a team that may be mistakes, as shares of play. play_notes.cpp has a row for each.
// How a robot drives is the mean over all robots but robot 0, which keeps the goal.
enum class Habit {
  wall,       // the robot that pushed most pushes against a wall
  stand,      // robots stand
  turn,       // robots turn in place
  backwards,  // robots drive backwards
  far,        // no robot is near the ball
  open_goal,  // of the ticks with the ball far from the own goal: no robot is near the own goal
  own_goal,   // a number, of all goals against the team
  kick_off    // a number of fouls, of all own kick-offs
};

struct HabitCount {
  double sum = 0.0, all = 0.0;
  std::uint32_t first = 0;  // the first tick

  void add(std::uint32_t tick, double amount) {
    if (sum == 0.0) first = tick;
    sum += amount;
    all += 1.0;
  }
};

// Speeds of wheels that a match changes, because they are not finite or too large.
struct BadSpeeds {
  int count = 0;
  std::string first{};  // "the left wheel of robot 1 in tick 20"
};

struct LegStory {
  Team team = Team::blue;            // the colour of the entry
  std::string opponent = "striker";  // a house team
  std::array<int, 2> score{};        // goals for the entry, and against it
  double minutes = 0.0;              // simulated time
  std::array<HabitCount, 8> habits{};
  // How often in play each robot was told to turn its left wheel, its right wheel, and one fast.
  std::array<std::array<int, 3>, max_robots_per_team> turned{};
  std::array<BadSpeeds, 2> bad_speeds{};  // not finite; too large
  int moved_placements = 0;               // requested places that were not legal

  const HabitCount& count(Habit habit) const { return habits[static_cast<std::size_t>(habit)]; }
  HabitCount& count(Habit habit) { return habits[static_cast<std::size_t>(habit)]; }
  double of(Habit habit) const { return count(habit).sum / std::max(count(habit).all, 1.0); }
  static bool is_counted(Habit habit) { return habit >= Habit::own_goal; }
  int lead() const { return score[0] - score[1]; }  // in goals
};

// A team in a leg, watched tick by tick. `show` changes what the team sees.
class WatchedTeam final : public match::Controller {
 public:
  using Show = std::function<void(match::Observation&)>;
  WatchedTeam(match::Controller& team, const match::Leg& leg, Team colour, const Show& show)
      : controller_(team), leg_(leg), team_(colour), show_(show) {}

  void post(const match::Observation& observation) override;
  match::Answer collect() override;

  // To be called after each tick.
  void look();

  LegStory story() const;

 private:
  void see(Habit habit, double amount) { story_.count(habit).add(leg_.tick(), amount); }

  match::Controller& controller_;
  const match::Leg& leg_;
  Team team_;
  const Show& show_;
  // Ticks for which something has held each robot now, and for which it has pushed in all.
  std::array<int, max_robots_per_team> held_{}, pushes_{};
  LegStory story_;
};

// Returns "3 : 5 against striker as blue, 1 own goal; its robots stood in 10 % of play, ...".
std::string text_of(const LegStory& story);

}  // namespace mirocup::app
