// SPDX-License-Identifier: MIT
#include "tests/physics/scene.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::scenes {

using namespace test_support;

std::unique_ptr<World> world_of(const Start& s, const simulator::Tolerances& tolerances) {
  auto world = std::make_unique<World>(s.field, s.parameters, tolerances,
                                       static_cast<int>(s.robots.size()), !s.ball.empty());
  for (std::size_t i = 0; i < s.robots.size(); ++i) {
    world->set_robot(static_cast<int>(i), s.robots[i]);
  }
  if (!s.ball.empty()) world->set_ball(s.ball[0]);
  return world;
}

Parameters without_rolling_friction() {
  Parameters p;
  p.rolling_resistance = 0.0;
  p.viscous_friction = 0.0;
  return p;
}

WheelCommand random_wheels(Random& random, double fastest) {
  return WheelSpeeds{random.uniform(-fastest, fastest), random.uniform(-fastest, fastest)};
}

WheelCommand random_wheels(Random& random, double fastest, const Parameters& p) {
  if (p.brake_time_constant > 0.0 && random.below(3) == 0) return WheelSpeeds{0.0, 0.0};
  return random_wheels(random, fastest);
}

Parameters with(const Motors& motors, Parameters p) {
  p.turn_time_constant = motors.turn;
  p.brake_time_constant = motors.brake;
  return p;
}

BodyState robot_at(const Vec2& at, double angle, const simulator::Twist& twist) {
  return {at, Heading::from_angle(angle), twist};
}

Heading random_heading(Random& random) {
  return Heading::from_angle(random.uniform(-pi, pi));
}

Vec2 random_in(Random& random, double half_x, double half_y) {
  const double x = random.uniform(-half_x, half_x);
  return {x, random.uniform(-half_y, half_y)};
}

double random_logarithmic(Random& random, double least, double most) {
  return least * std::exp(random.uniform() * std::log(most / least));
}

namespace {

std::vector<Outline> outlines(const Parameters& p, const std::vector<BodyState>& robots,
                              const std::vector<BallState>& ball) {
  std::vector<Outline> all;
  for (const BodyState& r : robots) {
    all.push_back(square_at(r.position, std::atan2(r.heading.sin, r.heading.cos), p.robot_side));
  }
  for (const BallState& b : ball) all.push_back(circle_at(b.position, p.ball_radius));
  return all;
}

double least_distance(const std::vector<Outline>& bodies, const std::vector<Outline>& solids) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      // Corners farther apart than any two touching bodies could have them: apart.
      const Vec2 between = bodies[i].corners[0] - bodies[j].corners[0];
      if (between.squaredNorm() > 0.25 * 0.25) continue;
      least = std::min(least, test_support::distance(bodies[i], bodies[j]));
    }
    for (const Outline& solid : solids) {
      least = std::min(least, test_support::distance(bodies[i], solid));
    }
  }
  return least;
}

std::vector<BodyState> robots_of(const World& world) {
  std::vector<BodyState> robots;
  for (int i = 0; i < world.robots(); ++i) robots.push_back(world.robot(i));
  return robots;
}

std::vector<BallState> ball_of(const World& world) {
  if (!world.static_world().has_ball) return {};
  return {world.ball()};
}

}  // namespace

bool overlap(const Start& s) {
  const auto solids =
      s.field != nullptr ? test_support::solids_around(*s.field) : std::vector<Outline>{};
  return least_distance(outlines(s.parameters, s.robots, s.ball), solids) < 1e-4;
}

double deepest_overlap(const World& world, const std::vector<Outline>& solids) {
  const auto bodies = outlines(world.parameters(), robots_of(world), ball_of(world));
  return std::max(0.0, -least_distance(bodies, solids));
}

double kinetic_energy(const World& world) {
  const Parameters& p = world.parameters();
  double sum = 0.0;
  for (const BodyState& r : robots_of(world)) {
    const simulator::Twist& v = r.twist;
    sum += 0.5 * p.robot_mass * (v.forward * v.forward + v.left * v.left);
    sum += 0.5 * p.robot_mass * p.robot_side * p.robot_side / 6.0 * v.omega * v.omega;
  }
  for (const BallState& b : ball_of(world)) {
    sum += 0.5 * 1.4 * p.ball_mass * b.velocity.squaredNorm();
  }
  return sum;
}

bool is_finite(const World& world) {
  bool finite = true;
  for (const BodyState& r : robots_of(world)) {
    finite =
        finite && std::isfinite(r.position.x() + r.position.y() + r.heading.cos + r.heading.sin +
                                r.twist.forward + r.twist.left + r.twist.omega);
  }
  for (const BallState& b : ball_of(world)) {
    finite = finite && std::isfinite(b.position.x() + b.position.y()) &&
             std::isfinite(b.velocity.x() + b.velocity.y());
  }
  return finite;
}

double difference(const BodyState& a, const BodyState& b) {
  const double turn = std::hypot(a.heading.cos - b.heading.cos, a.heading.sin - b.heading.sin);
  return std::max((a.position - b.position).norm(), turn);
}

double velocity_difference(const BodyState& a, const BodyState& b) {
  const Vec2 u = a.heading.to_world({a.twist.forward, a.twist.left});
  const Vec2 v = b.heading.to_world({b.twist.forward, b.twist.left});
  return std::max((u - v).norm(), std::abs(a.twist.omega - b.twist.omega));
}

}  // namespace mirocup::scenes
