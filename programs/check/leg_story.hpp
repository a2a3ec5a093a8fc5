// SPDX-License-Identifier: MIT
//
// The story of a trial leg for the author of the entry: the score, and the behaviour of the robots.
#pragma once

#include "core/match/leg.hpp"

#include <array>
#include <string>
#include <vector>

namespace mirocup::app {

// The habits of a team that may be mistakes. play_notes.cpp has a row for each but `touch`.
enum class Habit { own_goal, wall, own_end, away, standing, turning, backwards, far, touch };

struct HabitCount {
  double sum = 0.0;                  // LegStory::of() says of what
  std::vector<std::uint32_t> begun;  // the ticks in which the first three times began
  std::uint32_t last = 0;            // the last tick

  void add(std::uint32_t tick, double amount);
};

// Speeds of wheels that a match changes, because they are not finite or too large.
struct BadSpeeds {
  int count = 0;
  int robot = 0;  // of the first, which is for the left or the right wheel
  bool is_left = false;
  std::uint32_t tick = 0;
};

// The things that a team may have the wrong way round. If the team plays well with one of them
// swapped, that one is its mistake.
enum class Swap { none, ends, wheels, directions };

struct LegStory {
  Team team = Team::blue;      // the colour of the entry
  std::string opponent{};      // a house team
  std::array<int, 2> score{};  // goals for the entry, and against it
  double minutes = 0.0;        // simulated time
  int play_ticks = 0;          // ticks in which the ball was in play
  std::array<HabitCount, 9> habits{};
  double fastest_wheel = 0.0;  // the fastest command of the entry, rad/s
  std::array<unsigned, 2>
      told_wheels{};  // bit i: a command turned the left, right wheel of robot i
  std::array<BadSpeeds, 2> bad_speeds{};  // not finite; too large

  const HabitCount& count(Habit habit) const { return habits[static_cast<std::size_t>(habit)]; }
  // Returns the own goals a minute; for own_end, the part towards the own end of the speeds along x
  // that its touches gave the ball; for others, the part of play_ticks, as a mean over the robots.
  double of(Habit habit) const;
  int lead() const { return score[0] - score[1]; }  // in goals
};

// A team in a leg, watched tick by tick.
class WatchedTeam final : public match::Controller {
 public:
  WatchedTeam(match::Controller& team, const match::Leg& leg, Team colour, Swap swap)
      : controller_(team), leg_(leg), team_(colour), swap_(swap) {}

  void post(const match::Observation& observation) override;
  match::Answer collect() override;

  // To be called after each tick.
  void look();

  LegStory story() const;

 private:
  void note_speed(int robot, bool is_left, double speed);
  void look_at_robots();
  void see(Habit habit, double amount) {
    story_.habits[static_cast<std::size_t>(habit)].add(leg_.tick(), amount);
  }

  match::Controller& controller_;
  const match::Leg& leg_;
  Team team_;
  Swap swap_;
  double ball_speed_ = 0.0;                      // along x before the tick, m/s
  std::array<int, max_robots_per_team> held_{};  // ticks for which something has held each robot
  LegStory story_;
};

// Returns "3 : 5 against striker as blue, 1 own goal; its robots stood in 10 % of play, ...".
std::string text_of(const LegStory& story);

}  // namespace mirocup::app
