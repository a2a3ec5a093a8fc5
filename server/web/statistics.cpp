// SPDX-License-Identifier: MIT
#include "server/web/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::web {

namespace {

constexpr double cell = 0.1;           // m, about
constexpr double shot_speed = 0.5;     // m/s: slower is no shot
constexpr double shot_distance = 1.0;  // m to the goal line: from further away is no shot

int cells(double length) {
  return static_cast<int>(std::lround(length / cell));
}

// Does the ball roll towards the mouth of the goal at that end?
bool is_shot_at(const field::Field& field, End end, const simulator::BallState& ball) {
  const double out = -attack_sign(end);  // the direction of that end along x
  const double speed = out * ball.velocity.x();
  const double distance = field.half_length - out * ball.position.x();
  if (ball.velocity.norm() < shot_speed || speed <= 0.0) return false;
  if (distance < 0.0 || distance > shot_distance) return false;
  const double y = ball.position.y() + ball.velocity.y() / speed * distance;
  return std::abs(y) < field.goal_half_width;
}

}  // namespace

Statistics::Statistics(const field::Field& field)
    : field_(field),
      columns_(cells(2.0 * field.half_length)),
      rows_(cells(2.0 * field.half_width)),
      heat_(static_cast<std::size_t>(columns_ * rows_)) {}

void Statistics::add(const match::Leg& match) {
  const match::Snapshot scene = match.snapshot();
  const bool plays = before_ && before_->state == match::State::PLAY;
  if (scene.state != match::State::PLAY) {
    holder_.reset();  // after a restart nobody has the ball until it is touched
  }
  if (plays && scene.state == match::State::PLAY) {
    count_distance(scene);
    count_possession(match, match.setup().control_period);
    count_shots(scene);
    count_heat(scene);
  }
  before_ = scene;
}

void Statistics::count_distance(const match::Snapshot& scene) {
  for (const Team team : both_teams) {
    const int t = index_of(team);
    for (int i = 0; i < field_.robots_per_team; ++i) {
      teams_[t].distance[i] +=
          (scene.robots[t][i].position - before_->robots[t][i].position).norm();
    }
  }
}

void Statistics::count_possession(const match::Leg& match, double period) {
  if (const auto touch = match.last_touch()) {
    if (holder_ != touch->team) is_shot_counted_ = false;
    holder_ = touch->team;
  }
  if (holder_) teams_[index_of(*holder_)].possession += period;
}

// A ball that its holder sends at the goal is one shot for as long as it is on its way.
void Statistics::count_shots(const match::Snapshot& scene) {
  if (!holder_) return;
  const End goal = *holder_ == scene.left ? End::right : End::left;
  const bool is_shot = is_shot_at(field_, goal, scene.ball);
  if (is_shot && !is_shot_counted_) ++teams_[index_of(*holder_)].shots;
  is_shot_counted_ = is_shot;
}

void Statistics::count_heat(const match::Snapshot& scene) {
  const Vec2 ball =
      attack_sign(scene.left == Team::blue ? End::left : End::right) * scene.ball.position;
  const auto cell_of = [](double at, double half, int count) {
    return std::clamp(static_cast<int>((at + half) / (2.0 * half) * count), 0, count - 1);
  };
  const int column = cell_of(ball.x(), field_.half_length, columns_);
  const int row = cell_of(-ball.y(), field_.half_width, rows_);
  ++heat_[static_cast<std::size_t>(row * columns_ + column)];
}

}  // namespace mirocup::web
