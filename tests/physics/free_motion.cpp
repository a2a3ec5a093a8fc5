// SPDX-License-Identifier: MIT
//
// One body alone, and the ball between two walls.
#include "tests/physics/bars.hpp"
#include "tests/physics/scene.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::scenes {

using namespace test_support;

namespace {

double distance_of(const BallState& ball, const ExactBall& exact) {
  return static_cast<double>(std::hypot(ball.position.x() - exact.x, ball.position.y() - exact.y));
}

void advance_in_ticks(World& world, double duration, double length) {
  const int ticks = static_cast<int>(std::ceil(duration / length));
  for (int i = 0; i < ticks; ++i) {
    const double begin = duration * i / ticks;
    world.advance({}, duration * (i + 1) / ticks - begin);
  }
}

// Ball to and fro between the side walls: the exact way from bounce to bounce.
ExactBall bounce_exactly(const Parameters& p, double half_width, ExactBall ball, Real duration) {
  const Real turns_at = static_cast<Real>(half_width) - p.ball_radius;
  while (duration > 0) {
    const Real speed = std::hypot(ball.vx, ball.vy);
    if (speed == 0) break;
    const Real wall = ball.vy > 0 ? turns_at : -turns_at;
    const Real until = ball.vy == 0
                           ? 2 * duration
                           : time_to_roll(p, speed, (wall - ball.y) / (ball.vy / speed), duration);
    if (until >= duration) return roll_exactly(p, ball, duration);
    ball = roll_exactly(p, ball, until);
    ball.y = wall;
    ball.vy *= -static_cast<Real>(p.restitution.ball_wall);
    duration -= until;
  }
  return ball;
}

// The largest error of a robot's pose after `ticks` random commands.
double error_alone(const Parameters& parameters, std::uint64_t seed, int ticks) {
  Random random(seed);
  Start start;
  start.parameters = parameters;
  start.robots.push_back({{0.0, 0.0}, random_heading(random), {}});
  const auto world = world_of(start);
  ExactRobot exact = exactly(start.robots[0]);
  double worst = 0.0;
  for (int i = 0; i < ticks; ++i) {
    const WheelCommand command = random_wheels(random, 80.0, start.parameters);
    world->advance({&command, 1}, tick);
    exact = drive_exactly(start.parameters, exact, command, tick);
    worst = std::max(worst, difference(world->robot(0), rounded(exact)));
  }
  return worst;
}

}  // namespace

Bars free_ball(Size size) {
  Random random(1);
  double worst = 0.0;
  for (int i = 0; i < cases(size, 500, 100000); ++i) {
    Start start;
    const double speed = random_logarithmic(random, 0.01, 10.0);
    const Vec2 velocity = speed * random_heading(random).forward();
    start.ball.push_back({random_in(random, 0.7, 0.6), velocity});
    const auto world = world_of(start);
    advance_in_ticks(*world, 2.0, random_logarithmic(random, 1e-3, 2.0));
    const ExactBall exact = roll_exactly(start.parameters, exactly(start.ball[0]), 2.0L);
    worst = std::max(worst, distance_of(world->ball(), exact));
  }
  return {{"ball alone, 2 s, ticks 1 ms to 2 s", "position error, m", worst, 1e-12}};
}

Bars bounce_trains(Size size) {
  Random random(2);
  const field::Field field = field::make_field(RobotLeague::small);
  double worst = 0.0;
  for (int i = 0; i < cases(size, 200, 20000); ++i) {
    Start start;
    start.field = &field;
    start.parameters.restitution.ball_wall = random.uniform(0.3, 1.0);
    const double along = random.uniform(-0.2, 0.2);
    const double across = (random.coin() ? 1.0 : -1.0) * random_logarithmic(random, 0.2, 10.0);
    start.ball.push_back({random_in(random, 0.2, 0.6), {along, across}});
    const auto world = world_of(start);
    advance_in_ticks(*world, 2.0, random_logarithmic(random, 1e-3, 2.0));
    const ExactBall exact =
        bounce_exactly(start.parameters, field.half_width, exactly(start.ball[0]), 2.0L);
    worst = std::max(worst, distance_of(world->ball(), exact));
  }
  return {{"wall-bounce trains, 2 s, ticks 1 ms to 2 s", "position error, m", worst, 1e-12}};
}

namespace {

void add_alone(const std::string& scene, Parameters p, Size size, Bars& bars) {
  constexpr int ticks = 303;  // 10 s
  double infinite = 0.0;
  double finite = 0.0;
  for (int seed = 1; seed <= cases(size, 1, 20); ++seed) {
    p.grip = simulator::infinite_grip;
    infinite = std::max(infinite, error_alone(p, seed, ticks));
    p.grip = 0.8;
    finite = std::max(finite, error_alone(p, seed, ticks));
  }
  bars.push_back({scene, "infinite grip: pose error, m and rad", infinite, 1e-10});
  bars.push_back({scene, "finite grip: pose error, m and rad", finite, 1e-8});
}

}  // namespace

Bars robot_alone(Size size) {
  Bars bars;
  add_alone("robot alone, random wheels, 10 s", {}, size, bars);
  return bars;
}

Bars motors_alone(Size size) {
  Bars bars;
  for (const Motors& motors : other_motors) {
    add_alone(std::string(motors.name) + ", alone, 10 s", with(motors), size, bars);
  }
  return bars;
}

}  // namespace mirocup::scenes
