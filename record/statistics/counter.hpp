// SPDX-License-Identifier: MIT
//
// Counts the statistics of a leg, tick by tick. docs/statistics.md defines each count; the numbers
// below are the limits that this page names.
//
// A half-turn of the field and an exchange of the colours do not change any count.
#pragma once

#include "core/field/field.hpp"
#include "record/statistics/statistics.hpp"

#include <span>

namespace mirocup::statistics {

// One tick of a leg for the counter: plain data, so that a test can write a tick by hand. All
// values are in the field's frame, in m and m/s.
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

inline constexpr double min_flight_m = 0.15;    // least way of a passed or intercepted ball
inline constexpr double shot_speed = 0.5;       // m/s; a slower ball is not a shot
inline constexpr double shot_distance_m = 1.0;  // greatest distance of a shot to the goal line
// A shot crosses the goal line at most this many half widths of the goal from the goal's middle.
inline constexpr double wide_goals = 2.0;
inline constexpr double shot_pause_s = 0.5;  // a shot ends if its ball is off course for longer
inline constexpr double save_s = 0.5;        // no goal may fall for this time after a save
// A duel is over after this time without a contested tick.
inline constexpr double duel_pause_s = 0.5;

class Counter {
 public:
  // `control_period` is the time of a tick, s.
  Counter(const field::Field& field, double control_period);

  // To be called for each tick in its order.
  void add(const PlayTick& tick);

  // Returns the statistics as if play had ended now. If a duel is undecided, no team wins it.
  LegStatistics statistics() const;

 private:
  // The robots that touched the ball last, all of one team.
  struct Sender {
    Team team;
    referee::RobotSet robots;
  };
  // A ball on its way to the opponents' goal; the whole way counts as one shot.
  struct Shot {
    Team team = Team::blue;
    std::size_t mark = 0;            // index of the shot in LegStatistics::shots
    bool on_goal = false;            // true: the ball was on its way into the goal at some time
    std::uint32_t last = 0;          // last tick with the ball on its way past or into the goal
    std::uint32_t last_on_goal = 0;  // last tick with the ball on its way into the goal
  };
  struct Save {
    Team team;
    std::uint32_t tick;
    std::size_t mark;  // index of the shot in LegStatistics::shots
  };
  struct Restart {
    referee::Restart kind = referee::Restart::none;
    referee::Law law = referee::Law::toss;
    Team taker = Team::blue;
    std::uint32_t play_ticks = 0;  // ticks of play before the restart
  };
  enum class Course { elsewhere, wide, on_goal };

  void count_play(const PlayTick& tick);
  void count_touches(const PlayTick& tick);
  void count_touch(const PlayTick& tick, Team team);
  void count_contest(const PlayTick& tick);
  void count_shot(const PlayTick& tick);
  std::size_t mark_shot(std::uint32_t tick, Team team);
  void end_what_is_over(const PlayTick& tick);
  void count_decisions(const PlayTick& tick);
  void count_goal(const match::LoggedDecision& goal);
  void stop_play(std::optional<Team> scoring);
  void end_duel(std::optional<Team> winner);
  void lose_ball(const PlayTick& tick, Team team, LossKind kind);
  Course course_of(const PlayTick& tick, Team team) const;
  double seconds(std::uint32_t ticks) const { return ticks * control_period_; }

  field::Field field_;
  double control_period_;
  LegStatistics counted_;  // counts so far, without times
  std::uint32_t play_ticks_ = 0;
  std::uint32_t dead_ticks_ = 0;
  ByTeam<std::uint32_t> possession_ticks_{};
  ByTeam<std::uint32_t> opponent_half_ticks_{};

  // Since the last restart:
  Restart restart_;
  std::optional<Team> holder_;    // the team that has the ball
  std::optional<Sender> sender_;  // empty before the first touch, and after a contested tick
  std::uint32_t last_touch_ = 0;  // tick of the last touch
  Vec2 ball_then_{0.0, 0.0};      // place of the ball at the end of that tick
  ByTeam<Vec2> last_place_{Vec2{0.0, 0.0}, Vec2{0.0, 0.0}};  // the ball at each team's last touch
  ByTeam<std::optional<Loss>> last_loss_;
  std::optional<Shot> shot_;
  std::optional<Save> save_;                   // a save that may still fail
  std::optional<std::uint32_t> last_contest_;  // last contested tick; empty if no duel is on
};

// Counts a leg: a LegWatcher and a Counter.
class LegCounter {
 public:
  // To be made before the first tick of the leg.
  explicit LegCounter(const match::Leg& leg);

  // To be called after each tick.
  void add(const match::Leg& leg) { counter_.add(watcher_.see(leg)); }

  LegStatistics statistics() const { return counter_.statistics(); }

 private:
  LegWatcher watcher_;
  Counter counter_;
};

}  // namespace mirocup::statistics
