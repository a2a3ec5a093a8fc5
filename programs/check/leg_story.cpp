// SPDX-License-Identifier: MIT
#include "programs/check/leg_story.hpp"

#include "system/text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mirocup::app {

namespace {

// A slower robot stands, or turns in place: m/s, rad/s.
constexpr double least_speed = 0.03;
constexpr double least_turn = 0.5;
// A robot pushes if it is told to drive faster, m/s, and something keeps it from driving a quarter
// as fast for more ticks than it takes to turn round.
constexpr double least_push = 0.2;
constexpr int ticks_to_turn_round = 15;
// A robot that is nearer to the ball, or to the own goal, is near, m.
constexpr double near = 0.3;
// A habit that was not seen for this many ticks begins anew.
constexpr std::uint32_t pause = 150;
constexpr std::size_t told_ticks = 3;
// Own goals of a shorter leg are counted as if it had this length.
constexpr double shortest_leg = 5.0;  // minutes
constexpr int few_goals = 5;          // fewer open goals may be chance

}  // namespace

void HabitCount::add(std::uint32_t tick, double amount) {
  sum += amount;
  if (begun.size() < told_ticks && (begun.empty() || tick > last + pause)) begun.push_back(tick);
  last = tick;
}

double LegStory::of(Habit habit) const {
  const double all = is_counted(habit)           ? std::max(minutes, shortest_leg)
                     : habit == Habit::open_goal ? std::max(score[1], few_goals)
                                                 : std::max(play_ticks, 1);
  return count(habit).sum / all;
}

void WatchedTeam::post(const match::Observation& observation) {
  if (observation.opponent_score > goals_against_ && !has_keeper_) see(Habit::open_goal, 1.0);
  goals_against_ = observation.opponent_score;
  match::Observation shown = observation;
  if (trick_.show) trick_.show(shown);
  controller_.post(shown);
}

match::Answer WatchedTeam::collect() {
  match::Answer answer = controller_.collect();
  auto* const command = std::get_if<match::Command>(&answer);
  if (command == nullptr) return answer;
  for (int i = 0; i < leg_.field().robots_per_team; ++i) {
    auto& wheels = command->wheels[i];
    note_speed(i, true, wheels.left);
    note_speed(i, false, wheels.right);
    if (trick_.drive) trick_.drive(wheels);
  }
  if (trick_.show) command->placement.reset();
  return answer;
}

void WatchedTeam::note_speed(int robot, bool is_left, double speed) {
  story_.told_wheels[is_left ? 0 : 1] |= (speed != 0.0 ? 1U : 0U) << static_cast<unsigned>(robot);
  const double limit = leg_.setup().parameters.wheel_speed_limit;
  if (std::isfinite(speed))
    story_.fastest_wheel = std::max(story_.fastest_wheel, std::min(std::abs(speed), limit));
  if (std::abs(speed) <= limit) return;
  BadSpeeds& bad = story_.bad_speeds[std::isfinite(speed) ? 1 : 0];
  if (bad.count++ == 0) bad = {1, robot, is_left, leg_.tick()};
}

void WatchedTeam::look() {
  if (leg_.state() != match::State::PLAY) return;
  ++story_.play_ticks;
  const int robots = leg_.field().robots_per_team;
  const double end = leg_.end_of(team_) == End::left ? -1.0 : 1.0;
  const Vec2 own_goal(end * leg_.field().half_length, 0.0);
  double to_ball = 1e9, to_goal = 1e9;
  for (int i = 0; i < robots; ++i) {
    const auto robot = leg_.robot(team_, i);
    const auto wheels = leg_.answers()[index_of(team_)].speeds(i);
    const double told =
        0.5 * leg_.setup().parameters.wheel_radius * std::abs(wheels.left + wheels.right);
    const bool is_held = told > least_push && 4.0 * std::abs(robot.twist.forward) < told;
    held_[i] = is_held ? held_[i] + 1 : 0;
    if (held_[i] > ticks_to_turn_round) {
      // The sum is that of the robot that has pushed most.
      see(Habit::wall, ++pushes_[i] > story_.count(Habit::wall).sum ? 1.0 : 0.0);
    } else if (std::hypot(robot.twist.forward, robot.twist.left) < least_speed) {
      see(std::abs(robot.twist.omega) < least_turn ? Habit::stand : Habit::turn, 1.0 / robots);
    } else if (robot.twist.forward < -least_speed) {
      see(Habit::backwards, 1.0 / robots);
    }
    to_ball = std::min(to_ball, (leg_.ball().position - robot.position).norm());
    to_goal = std::min(to_goal, (own_goal - robot.position).norm());
  }
  has_keeper_ = to_goal < near;
  if (to_ball > near) see(Habit::far, 1.0);
}

LegStory WatchedTeam::story() const {
  LegStory story = story_;
  story.team = team_;
  story.minutes = leg_.tick() * leg_.setup().control_period / 60.0;
  const auto score = leg_.snapshot().score;
  story.score = {score[index_of(team_)], score[1 - index_of(team_)]};
  for (const match::LoggedDecision& logged : leg_.decisions()) {
    const auto& credit = logged.credit;
    if (credit && credit->own_goal && credit->scorer && credit->scorer->team == team_)
      story.count(Habit::own_goal).add(logged.tick, 1.0);
    if (logged.decision.verdict == referee::Verdict::KICK_OFF_VIOLATION && logged.team == team_)
      story.count(Habit::kick_off).add(logged.tick, 1.0);
  }
  return story;
}

std::string text_of(const LegStory& story) {
  const int own = static_cast<int>(story.count(Habit::own_goal).sum);
  const std::string own_goals =
      own == 0 ? "" : system::formatted(", %d own goal%s", own, own == 1 ? "" : "s");
  return system::formatted(
      "%d : %d against %.40s as %s%s; its robots stood in %.0f %% of play, turned in "
      "place in %.0f %%, drove backwards in %.0f %%",
      story.score[0], story.score[1], story.opponent.c_str(), to_string(story.team).data(),
      own_goals.c_str(), 100.0 * story.of(Habit::stand), 100.0 * story.of(Habit::turn),
      100.0 * story.of(Habit::backwards));
}

}  // namespace mirocup::app
