// SPDX-License-Identifier: MIT
#include "table.hpp"

#include <algorithm>
#include <cmath>

namespace pitch {

namespace {

constexpr double rolling = 0.98;         // share of its speed that the ball keeps in a tick
constexpr double pixel = 0.001;          // m, resolution of the camera
constexpr double smallest_angle = 0.01;  // rad

double rounded(double value, double step) {
  return step * std::round(value / step);
}

Place seen(const Place& place) {
  return {rounded(place.x, pixel), rounded(place.y, pixel), rounded(place.heading, smallest_angle)};
}

}  // namespace

Table::Table(const mirocup::field::Field& field, const mirocup::simulator::Parameters& robots,
             double period)
    : field_(field), parameters_(robots), period_(period) {
  const double between = 2.0 * field_.half_width / (field_.robots_per_team + 1);
  for (int i = 0; i < field_.robots_per_team; ++i) {
    const double x = -0.5 * field_.half_length;
    const double y = (i + 1) * between - field_.half_width;
    robots_[0][i].place = {x, y, 0.0};
    robots_[1][i].place = {-x, -y, M_PI};
  }
}

void Table::send(int colour, const mirocup::match::Command& command) {
  for (int i = 0; i < field_.robots_per_team; ++i) robots_[colour][i].wheels = command.wheels[i];
}

Picture Table::next_picture() {
  for (auto& team : robots_) {
    for (int i = 0; i < field_.robots_per_team; ++i) {
      drive(team[i]);
      push_ball(team[i]);
    }
  }
  roll_ball();
  Picture picture;
  picture.ball = seen(ball_);
  for (int colour = 0; colour < 2; ++colour) {
    for (int i = 0; i < field_.robots_per_team; ++i) {
      picture.robots[colour][i] = seen(robots_[colour][i].place);
    }
  }
  return picture;
}

void Table::drive(Robot& robot) const {
  const double limit = parameters_.wheel_speed_limit;
  const double left = std::clamp(robot.wheels.left, -limit, limit);
  const double right = std::clamp(robot.wheels.right, -limit, limit);
  const double gain = 1.0 - std::exp(-period_ / parameters_.motor_time_constant);
  robot.forward += gain * (parameters_.speed_reference(left, right) - robot.forward);
  robot.turn += gain * (parameters_.omega_reference(left, right) - robot.turn);
  Place& p = robot.place;
  p.heading = std::remainder(p.heading + robot.turn * period_, 2.0 * M_PI);
  p.x += robot.forward * std::cos(p.heading) * period_;
  p.y += robot.forward * std::sin(p.heading) * period_;
  p = inside(p, parameters_.robot_side / 2.0);
}

void Table::push_ball(const Robot& robot) {
  const double reach = parameters_.robot_side / 2.0 + parameters_.ball_radius;
  const mirocup::Vec2 way{ball_.x - robot.place.x, ball_.y - robot.place.y};
  const double distance = way.norm();
  if (distance >= reach || distance == 0.0) return;
  const mirocup::Vec2 normal = way / distance;
  const mirocup::Vec2 speed =
      robot.forward * mirocup::Vec2{std::cos(robot.place.heading), std::sin(robot.place.heading)};
  ball_.x = robot.place.x + reach * normal.x();
  ball_.y = robot.place.y + reach * normal.y();
  ball_speed_ += std::max(0.0, (speed - ball_speed_).dot(normal)) * normal;
}

void Table::roll_ball() {
  ball_speed_ *= rolling;
  const Place free{ball_.x + period_ * ball_speed_.x(), ball_.y + period_ * ball_speed_.y(), 0.0};
  ball_ = inside(free, parameters_.ball_radius);
  if (ball_.x != free.x) ball_speed_.x() = -ball_speed_.x();
  if (ball_.y != free.y) ball_speed_.y() = -ball_speed_.y();
}

Place Table::inside(Place place, double margin) const {
  place.x = std::clamp(place.x, margin - field_.half_length, field_.half_length - margin);
  place.y = std::clamp(place.y, margin - field_.half_width, field_.half_width - margin);
  return place;
}

}  // namespace pitch
