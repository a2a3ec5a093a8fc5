// SPDX-License-Identifier: MIT
#include "labs/pitch/windows.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mirocup::pitch {

namespace {

// A body is an outlier if it is seen this far from the median of its neighbours in time, m. A robot
// at 3 m/s moves by a third of it between two pictures of a slow camera.
constexpr double max_jump = 0.15;
constexpr int neighbours = 3;  // on each side

// A body that is seen farther away than this allows was put there by hand.
constexpr double max_body_speed = 6.0;  // m/s
constexpr double hand_move = 0.05;      // m
constexpr double longest_pause = 5.0;   // usual periods between two pictures

// Commands are looked up this long before they are used, s.
constexpr double least_step = 1e-9;

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Footage::Footage(const CameraLog& recording)
    : field_(field::make_field(recording.league)), period_(recording.usual_period()) {
  const int robots = 2 * recording.robots;
  const std::size_t frames = recording.frames.size();
  sights_.assign(static_cast<std::size_t>(robots) + 1, std::vector<Sight>(frames));
  told_.resize(static_cast<std::size_t>(robots) + 1);
  for (std::size_t f = 0; f < frames; ++f) {
    const Frame& frame = recording.frames[f];
    times_.push_back(frame.t);
    if (frame.ball) sights_.back()[f] = {true, *frame.ball, 0.0};
    for (int body = 0; body < robots; ++body) {
      if (const auto& pose = recording.robot(frame, body)) {
        sights_[body][f] = {true, pose->position, pose->heading};
      }
      const auto& commands = frame.commands[body / recording.robots];
      if (commands.empty()) continue;
      const simulator::WheelSpeeds wheels = commands[body % recording.robots];
      auto& told = told_[body];
      const bool is_new = told.empty() || told.back().wheels.left != wheels.left ||
                          told.back().wheels.right != wheels.right;
      if (is_new) told.push_back({frame.t, wheels});
    }
  }
  for (int body = 0; body <= robots; ++body) leave_out_outliers(body);
  find_breaks();
}

void Footage::find_breaks() {
  breaks_.assign(times_.size(), 0);
  std::vector<int> latest(sights_.size(), -1);  // frame in which the body was seen last
  for (int f = 0; f < frames(); ++f) {
    if (f > 0) breaks_[f] = breaks_[f - 1];
    if (f > 0 && times_[f] - times_[f - 1] > longest_pause * period_) ++breaks_[f];
    for (int body = 0; body < bodies(); ++body) {
      if (!sights_[body][f].is_seen) continue;
      const int before = latest[body];
      latest[body] = f;
      if (before < 0) continue;
      const double moved = (sights_[body][f].position - sights_[body][before].position).norm();
      if (moved > max_body_speed * (times_[f] - times_[before]) + hand_move) ++breaks_[f];
    }
  }
}

bool Footage::is_broken(int first, int last) const {
  return breaks_[last] != breaks_[first];
}

double Footage::position_noise() const {
  std::vector<double> differences;
  for (const auto& sights : sights_) {
    for (std::size_t f = 0; f + 3 < sights.size(); ++f) {
      if (!sights[f].is_seen || !sights[f + 1].is_seen || !sights[f + 2].is_seen ||
          !sights[f + 3].is_seen)
        continue;
      const Vec2 d = sights[f + 3].position - 3.0 * sights[f + 2].position +
                     3.0 * sights[f + 1].position - sights[f].position;
      differences.push_back(std::abs(d.x()));
      differences.push_back(std::abs(d.y()));
    }
  }
  return differences.size() < 20 ? 0.0 : 1.4826 * median_of(differences) / std::sqrt(20.0);
}

void Footage::leave_out_outliers(int body) {
  std::vector<Sight>& sights = sights_[body];
  std::vector<char> is_outlier(sights.size(), 0);
  std::vector<double> x, y;
  for (int f = 0; f < frames(); ++f) {
    if (!sights[f].is_seen) continue;
    x.clear();
    y.clear();
    for (int n = std::max(0, f - neighbours); n <= std::min(frames() - 1, f + neighbours); ++n) {
      if (n == f || !sights[n].is_seen) continue;
      x.push_back(sights[n].position.x());
      y.push_back(sights[n].position.y());
    }
    if (x.size() < 2) continue;
    const Vec2 usual{median_of(x), median_of(y)};
    if ((sights[f].position - usual).norm() > max_jump) is_outlier[f] = 1;
  }
  double before = 0.0;
  for (int f = 0; f < frames(); ++f) {
    Sight& s = sights[f];
    if (is_outlier[f] != 0) s.is_seen = false;
    if (!s.is_seen) continue;
    s.heading = before + std::remainder(s.heading - before, 2.0 * std::numbers::pi);
    before = s.heading;
  }
}

std::optional<Footage::FittedState> Footage::state_at(int body, int frame, int count,
                                                      int degree) const {
  const int wanted = std::abs(count);
  const int step = count < 0 ? -1 : 1;
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d b = Eigen::Matrix3d::Zero();
  if (degree == 1) a(2, 2) = 1.0;  // no curvature
  const auto powers_at = [&](int f) {
    const double t = times_[f] - times_[frame];
    return Eigen::Vector3d{1.0, t, degree == 1 ? 0.0 : t * t};
  };
  std::vector<int> used;
  double reference = 0.0;
  for (int i = 0; i < wanted; ++i) {
    const int f = frame + step * i;
    if (f < 0 || f >= frames()) break;
    const Sight& s = sights_[body][f];
    if (!s.is_seen) continue;
    if (used.empty()) reference = s.heading;
    used.push_back(f);
    const Eigen::Vector3d powers = powers_at(f);
    const double heading = std::remainder(s.heading - reference, 2.0 * std::numbers::pi);
    a += powers * powers.transpose();
    b += powers * Eigen::RowVector3d{s.position.x(), s.position.y(), heading};
  }
  const int seen = static_cast<int>(used.size());
  if (seen < degree + 2 || 2 * seen < wanted) return std::nullopt;
  const Eigen::Matrix3d inverse = a.inverse();
  const Eigen::Matrix3d fit = inverse * b;
  FittedState fitted;
  fitted.position = inverse(0, 0);
  fitted.both = inverse(0, 1);
  fitted.velocity = inverse(1, 1);
  double square = 0.0;
  for (const int f : used) {
    const Eigen::Vector3d at = fit.transpose() * powers_at(f);
    square += (sights_[body][f].position - Vec2{at.x(), at.y()}).squaredNorm();
  }
  fitted.misfit = std::sqrt(square / (2.0 * (seen - degree - 1)));
  simulator::BodyState& state = fitted.state;
  state.position = {fit(0, 0), fit(0, 1)};
  const Vec2 velocity{fit(1, 0), fit(1, 1)};
  if (body == ball()) {
    state.twist = {velocity.x(), velocity.y(), 0.0};
    return fitted;
  }
  state.heading = Heading::from_angle(fit(0, 2) + reference);
  const Vec2 own = state.heading.to_body(velocity);
  state.twist = {own.x(), own.y(), fit(1, 2)};
  return fitted;
}

simulator::World& Rerun::world_for(const Window& window) {
  const bool has_ball = window.bodies.back() == footage_.ball();
  const int robots = static_cast<int>(window.bodies.size()) - (has_ball ? 1 : 0);
  auto& world = worlds_[{robots, has_ball}];
  if (!world) {
    world = std::make_unique<simulator::World>(&footage_.field(), guess_.parameters,
                                               simulator::Tolerances{}, robots, has_ball);
  }
  return *world;
}

void Rerun::begin(simulator::World& world, const Window& window,
                  const std::vector<simulator::BodyState>& start) {
  world.clear(guess_.parameters.rolling_resistance);
  for (std::size_t i = 0; i < window.bodies.size(); ++i) {
    if (window.bodies[i] == footage_.ball()) {
      world.set_ball({start[i].position, start[i].velocity()});
    } else {
      world.set_robot(static_cast<int>(i), start[i]);
      const simulator::Parameters& p = guess_.parameters;
      const double mean = start[i].twist.forward / p.wheel_radius;
      const double half = start[i].twist.omega * p.wheel_distance / (2.0 * p.wheel_radius);
      kept_[i] = {mean - half, mean + half};
    }
  }
}

// Plays from one picture to the next, in pieces between the times at which commands take effect.
void Rerun::advance(simulator::World& world, const Window& window, double from, double to) const {
  std::array<simulator::WheelCommand, simulator::max_robots> commands;
  double t = from;
  while (t < to - least_step) {
    double end = to;
    for (int i = 0; i < world.robots(); ++i) {
      const auto& told = footage_.told(window.bodies[i]);
      if (told.empty()) {
        commands[i] = kept_[i];
        continue;
      }
      const double sent = t - guess_.command_delay + least_step;
      const auto next = std::upper_bound(
          told.begin(), told.end(), sent,
          [](double time, const Footage::Told& command) { return time < command.t; });
      commands[i] = next == told.begin() ? simulator::WheelSpeeds{} : std::prev(next)->wheels;
      if (next != told.end()) end = std::min(end, next->t + guess_.command_delay);
    }
    world.advance({commands.data(), static_cast<std::size_t>(world.robots())}, end - t);
    t = end;
  }
}

simulator::BodyState Rerun::state(const simulator::World& world, const Window& window,
                                  std::size_t i) const {
  if (window.bodies[i] != footage_.ball()) return world.robot(static_cast<int>(i));
  const simulator::BallState ball = world.ball();
  return {ball.position, Heading{}, {ball.velocity.x(), ball.velocity.y(), 0.0}};
}

}  // namespace mirocup::pitch
