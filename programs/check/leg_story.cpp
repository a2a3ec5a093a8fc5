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
// The robot nearest to the ball leaves it, m/s, or is far from it, m.
constexpr double leaving_speed = 0.1;
constexpr double far_from_ball = 0.3;
// A habit that was not seen for this many ticks begins anew.
constexpr std::uint32_t pause = 150;
constexpr std::size_t told_ticks = 3;
// Own goals of a shorter leg are counted as if it had this length.
constexpr double shortest_leg = 5.0;  // minutes

// The scene as it looks from the other end.
match::Observation turned(match::Observation scene) {
  scene.ball = -scene.ball;
  scene.ball_velocity = -scene.ball_velocity;
  for (auto* robots : {&scene.own, &scene.opponent}) {
    for (match::ObservedRobot& robot : *robots) robot = match::team_frame(End::right, robot);
  }
  return scene;
}

}  // namespace

void HabitCount::add(std::uint32_t tick, double amount) {
  sum += amount;
  if (begun.size() < told_ticks && (begun.empty() || tick > last + pause)) begun.push_back(tick);
  last = tick;
}

double LegStory::of(Habit habit) const {
  const double all = habit == Habit::own_goal  ? std::max(minutes, shortest_leg)
                     : habit == Habit::own_end ? count(Habit::touch).sum
                                               : static_cast<double>(play_ticks);
  return all > 0.0 ? count(habit).sum / all : 0.0;
}

void WatchedTeam::post(const match::Observation& observation) {
  controller_.post(swap_ == Swap::ends ? turned(observation) : observation);
}

match::Answer WatchedTeam::collect() {
  match::Answer answer = controller_.collect();
  auto* const command = std::get_if<match::Command>(&answer);
  if (command == nullptr) return answer;
  for (int i = 0; i < leg_.field().robots_per_team; ++i) {
    auto& wheels = command->wheels[i];
    note_speed(i, true, wheels.left);
    note_speed(i, false, wheels.right);
    if (swap_ == Swap::wheels) std::swap(wheels.left, wheels.right);
    if (swap_ == Swap::directions) wheels = {-wheels.left, -wheels.right};
  }
  if (swap_ == Swap::ends) command->placement.reset();
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
  const double ahead = leg_.end_of(team_) == End::left ? 1.0 : -1.0;
  const double given = ahead * leg_.ball().velocity.x() - ball_speed_;
  ball_speed_ += given;
  if (leg_.state() != match::State::PLAY) return;
  ++story_.play_ticks;
  look_at_robots();
  const auto touch = leg_.last_touch();
  if (!touch || touch->team != team_) return;
  see(Habit::touch, std::abs(given));
  if (given < 0.0) see(Habit::own_end, -given);
}

void WatchedTeam::look_at_robots() {
  const int robots = leg_.field().robots_per_team;
  double nearest = 1e9;
  bool is_leaving = false;
  for (int i = 0; i < robots; ++i) {
    const auto robot = leg_.robot(team_, i);
    const auto wheels = leg_.answers()[index_of(team_)].speeds(i);
    const double told =
        0.5 * leg_.setup().parameters.wheel_radius * std::abs(wheels.left + wheels.right);
    const bool is_held = told > least_push && 4.0 * std::abs(robot.twist.forward) < told;
    held_[i] = is_held ? held_[i] + 1 : 0;
    if (held_[i] > ticks_to_turn_round) {
      see(Habit::wall, 1.0 / robots);
    } else if (std::hypot(robot.twist.forward, robot.twist.left) < least_speed) {
      see(std::abs(robot.twist.omega) < least_turn ? Habit::standing : Habit::turning,
          1.0 / robots);
    } else if (robot.twist.forward < -least_speed) {
      see(Habit::backwards, 1.0 / robots);
    }
    const Vec2 to_ball = leg_.ball().position - robot.position;
    if (to_ball.norm() >= nearest) continue;
    nearest = to_ball.norm();
    is_leaving = robot.velocity().dot(to_ball) < -leaving_speed * nearest;
  }
  if (is_leaving) see(Habit::away, 1.0);
  if (nearest > far_from_ball) see(Habit::far, 1.0);
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
      story.habits[static_cast<std::size_t>(Habit::own_goal)].add(logged.tick, 1.0);
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
      own_goals.c_str(), 100.0 * story.of(Habit::standing), 100.0 * story.of(Habit::turning),
      100.0 * story.of(Habit::backwards));
}

}  // namespace mirocup::app
