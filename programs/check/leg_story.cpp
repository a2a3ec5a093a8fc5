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
// A slower command is slow, rad/s: robots drive 0.4 m/s.
constexpr double fast = 15.0;
// A robot pushes against a wall if it is so near, m, and told to drive faster, m/s, and does not
// drive a quarter as fast for more ticks than it takes to turn round.
constexpr double at_wall = 0.08;
constexpr double least_push = 0.2;
constexpr int ticks_to_turn_round = 15;
// A robot that is nearer to the ball, or to the own goal, is near, and a ball is far from it, m.
constexpr double near = 0.3;
constexpr double far_from_goal = 0.5;

}  // namespace

void WatchedTeam::post(const match::Observation& observation) {
  match::Observation shown = observation;
  if (show_) show_(shown);
  controller_.post(shown);
}

match::Answer WatchedTeam::collect() {
  match::Answer answer = controller_.collect();
  auto* const command = std::get_if<match::Command>(&answer);
  if (command == nullptr) return answer;
  const bool is_play = leg_.state() == match::State::PLAY;
  for (int i = 0; i < leg_.field().robots_per_team; ++i) {
    for (const std::size_t side : {0u, 1u}) {
      const double speed = side == 0 ? command->wheels[i].left : command->wheels[i].right;
      story_.turned[i][side] += is_play && speed != 0.0 ? 1 : 0;
      story_.turned[i][2] += is_play && std::abs(speed) > fast ? 1 : 0;
      if (std::abs(speed) <= leg_.setup().parameters.wheel_speed_limit) continue;
      auto& [count, first] = story_.bad_speeds[std::isfinite(speed) ? 1 : 0];
      if (count++ == 0)
        first = system::formatted("the %s wheel of robot %d in tick %u",
                                  side == 0 ? "left" : "right", i, leg_.tick());
    }
  }
  if (show_) command->placement.reset();
  return answer;
}

void WatchedTeam::look() {
  if (leg_.state() != match::State::PLAY) return;
  const field::Field& field = leg_.field();
  const Vec2 own_goal = team_frame(leg_.end_of(team_), Vec2(-field.half_length, 0.0));
  const Vec2 ball = leg_.ball().position;
  double to_ball = 1e9, to_goal = 1e9;
  double pushes = 0.0, stand = 0.0, turn = 0.0, backwards = 0.0;
  for (int i = 0; i < field.robots_per_team; ++i) {
    const auto robot = leg_.robot(team_, i);
    const auto wheels = leg_.answers()[index_of(team_)].speeds(i);
    const double told =
        0.5 * leg_.setup().parameters.wheel_radius * std::abs(wheels.left + wheels.right);
    const bool is_at_wall = std::abs(robot.position.x()) > field.half_length - at_wall ||
                            std::abs(robot.position.y()) > field.half_width - at_wall;
    const bool is_held =
        is_at_wall && told > least_push && 4.0 * std::abs(robot.twist.forward) < told;
    held_[i] = is_held ? held_[i] + 1 : 0;
    to_goal = std::min(to_goal, (own_goal - robot.position).norm());
    // Only the robot that has pushed most counts.
    if (held_[i] > ticks_to_turn_round && ++pushes_[i] > story_.count(Habit::wall).sum)
      pushes = 1.0;
    if (i == 0) continue;
    to_ball = std::min(to_ball, (ball - robot.position).norm());
    if (held_[i] > ticks_to_turn_round) continue;
    if (std::hypot(robot.twist.forward, robot.twist.left) < least_speed) {
      (std::abs(robot.twist.omega) < least_turn ? stand : turn) +=
          1.0 / (field.robots_per_team - 1);
    } else if (robot.twist.forward < -least_speed) {
      backwards += 1.0 / (field.robots_per_team - 1);
    }
  }
  see(Habit::wall, pushes);
  see(Habit::stand, stand);
  see(Habit::turn, turn);
  see(Habit::backwards, backwards);
  see(Habit::far, to_ball > near ? 1.0 : 0.0);
  if ((ball - own_goal).norm() > far_from_goal) see(Habit::open_goal, to_goal > near ? 1.0 : 0.0);
}

LegStory WatchedTeam::story() const {
  LegStory story = story_;
  story.team = team_;
  story.minutes = leg_.tick() * leg_.setup().control_period / 60.0;
  const auto score = leg_.snapshot().score;
  int kick_offs = 0;
  story.score = {score[index_of(team_)], score[1 - index_of(team_)]};
  for (const match::LoggedDecision& logged : leg_.decisions()) {
    const auto& credit = logged.credit;
    if (credit && credit->own_goal && credit->scorer && credit->scorer->team == team_)
      story.count(Habit::own_goal).add(logged.tick, 1.0);
    if (logged.decision.verdict == referee::Verdict::KICK_OFF_VIOLATION && logged.team == team_)
      story.count(Habit::kick_off).add(logged.tick, 1.0);
    if (logged.decision.restart == referee::Restart::KICK_OFF && logged.taker == team_) ++kick_offs;
    if (logged.decision.verdict == referee::Verdict::PLACEMENT_FIXED && logged.team == team_)
      ++story.moved_placements;
  }
  story.count(Habit::kick_off).all = kick_offs;
  story.count(Habit::own_goal).all = story.score[1];
  return story;
}

std::string text_of(const LegStory& story) {
  const int own = static_cast<int>(story.count(Habit::own_goal).sum);
  const std::string own_goals =
      own == 0 ? "" : system::formatted(", %d own goal%s", own, own == 1 ? "" : "s");
  return system::formatted(
      "%d : %d against %s as %s%s; its robots stood in %.0f %% of play, turned in "
      "place in %.0f %%, drove backwards in %.0f %%",
      story.score[0], story.score[1], story.opponent.c_str(), to_string(story.team).data(),
      own_goals.c_str(), 100.0 * story.of(Habit::stand), 100.0 * story.of(Habit::turn),
      100.0 * story.of(Habit::backwards));
}

}  // namespace mirocup::app
