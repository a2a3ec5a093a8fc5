// SPDX-License-Identifier: MIT
//
// Scenes whose outcome can be said in a sentence.
#include "tests/physics/bars.hpp"
#include "tests/physics/scene.hpp"
#include "tests/support/tiny_world.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::scenes {

namespace {

const WheelCommand lifted{};

Parameters bouncing_with(double e) {
  Parameters p = without_rolling_friction();
  p.restitution = {e, e, e, e};
  return p;
}

Vec2 velocity_of(const World& world, int robot) {
  const BodyState r = world.robot(robot);
  return r.heading.to_world({r.twist.forward, r.twist.left});
}

}  // namespace

// The first runs into a row of equal bodies that touch: all stay but the last, which leaves with
// its speed.
Bars newtons_cradle(Size size) {
  double worst = 0.0;
  double moved = 0.0;
  for (int count = 2; count <= cases(size, 5, 8); ++count) {
    for (const double grip : {0.8, simulator::infinite_grip}) {
      Start s;
      s.parameters = bouncing_with(1.0);
      s.parameters.grip = grip;
      const double side = s.parameters.robot_side;
      s.robots.push_back(robot_at({-0.1 - side, 0.0}, 0.0, {1.0, 0.0, 0.0}));
      for (int i = 0; i + 1 < count; ++i) s.robots.push_back(robot_at({side * i, 0.0}, 0.0));
      const auto world = world_of(s);
      const std::vector<WheelCommand> commands(count, lifted);
      for (int i = 0; i < 6; ++i) world->advance(commands, tick);
      for (int i = 0; i < count; ++i) {
        const Vec2 expected{i + 1 == count ? 1.0 : 0.0, 0.0};
        worst = std::max({worst, (velocity_of(*world, i) - expected).norm(),
                          std::abs(world->robot(i).twist.omega)});
        if (i > 0 && i + 1 < count) {
          moved = std::max(moved, (world->robot(i).position - s.robots[i].position).norm());
        }
      }
    }
  }
  return {{"Newton's cradle", "velocities, m/s and rad/s", worst, 1e-9},
          {"Newton's cradle", "way of those in the middle, m", moved, 1e-9}};
}

// The ball hits two robots at once that are each other's mirror image: so they stay, until they
// touch each other. Mirror images do so corner on corner, where a side has to be chosen.
Bars symmetric_hits(Size size) {
  double worst = 0.0;
  int missed = 0;
  Random random(6);
  for (int i = 0; i < cases(size, 200, 10000); ++i) {
    Start s;
    const double e = random.uniform();
    s.parameters.restitution = {e, e, e, e};
    const double angle = random.uniform(-0.7, 0.7);
    const double y = random.uniform(0.06, 0.075);
    const simulator::Twist twist{random.uniform(-0.3, 0.3), 0.0, random.uniform(-3.0, 3.0)};
    s.robots = {{{0.0, y}, Heading::from_angle(angle), twist},
                {{0.0, -y}, Heading::from_angle(-angle), {twist.forward, 0.0, -twist.omega}}};
    // The mirror image to the bit.
    s.robots[1].heading = {s.robots[0].heading.cos, -s.robots[0].heading.sin};
    s.ball.push_back({{-0.2, 0.0}, {random.uniform(1.0, 5.0), 0.0}});
    if (overlap(s)) continue;
    const auto world = world_of(s);
    const double u = random.uniform(-40.0, 40.0);
    const double v = random.uniform(-40.0, 40.0);
    const std::vector<WheelCommand> commands{WheelSpeeds{u, v}, WheelSpeeds{v, u}};
    bool touched = false;
    for (int k = 0; k < 5; ++k) {
      const simulator::TickEvents& events = world->advance(commands, tick);
      if (events.touched[0][1]) break;
      touched = touched || events.touched[2].any();
      const BodyState a = world->robot(0);
      const BodyState b = world->robot(1);
      worst = std::max(
          {worst, std::abs(world->ball().position.y()), std::abs(a.position.x() - b.position.x()),
           std::abs(a.position.y() + b.position.y()), std::abs(a.heading.sin + b.heading.sin)});
    }
    missed += !touched;
  }
  const std::string scene = "symmetric hits of two robots by the ball";
  return {
      {scene, "from the mirror image after 5 ticks, m", worst, 1e-9},
      {scene, "share that was no hit", missed / static_cast<double>(cases(size, 200, 10000)), 0.5}};
}

// In a tick of a robot at a wall, with a ball between them or not.
constexpr double most_events_of_one = 90.0;

// Two robots that meet exactly corner on corner, free of the ground.
Bars corner_on_corner(Size size) {
  double overlap_of = 0.0;
  double momentum = 0.0;
  double energy = 0.0;
  int untouched = 0;
  int stepped = 0;
  Random random(7);
  for (int i = 0; i < cases(size, 200, 20000); ++i) {
    Start s;
    s.parameters = bouncing_with(random.uniform());
    const Heading way = random.coin() ? Heading{} : random_heading(random);
    // Corners ahead: headings at 45 degrees to the way.
    const double speed = random_logarithmic(random, 0.1, 10.0);
    const auto robot = [&](double side) {
      BodyState r{way.to_world({side * 0.1, 0.0}), way.turned(sincos(pi / 4)), {}};
      const Vec2 v = r.heading.to_body(way.to_world({-side * speed, 0.0}));
      r.twist = {v.x(), v.y(), 0.0};
      return r;
    };
    s.robots = {robot(-1.0), robot(1.0)};
    const auto world = world_of(s);
    const double before = kinetic_energy(*world);
    const std::vector<WheelCommand> commands(2, lifted);
    bool touched = false;
    for (int k = 0; k < 16; ++k) {
      const simulator::TickEvents& events = world->advance(commands, tick);
      touched = touched || events.touched[0][1];
      stepped += events.stepped;
      overlap_of = std::max({overlap_of, events.deepest_overlap, deepest_overlap(*world, {})});
    }
    untouched += !touched;
    momentum = std::max(momentum, (velocity_of(*world, 0) + velocity_of(*world, 1)).norm() / speed);
    energy = std::max(energy, kinetic_energy(*world) / before - 1.0);
  }
  const std::string scene = "corner on corner";
  // Off by rounding they may pass by; with a gap of a rounding they must not overlap. At a small e
  // their corners may press, and turn around each other: such a curve is cut where its last terms
  // are 4e-10 m, which is up to 2e-9 m/s in its speeds, and some robots have 0.1 m/s.
  return {{scene, "overlap, m", overlap_of, 1e-9},
          {scene, "momentum, relative", momentum, 5e-8},
          {scene, "energy gained, relative", energy, 1e-12},
          {scene, "did not touch", static_cast<double>(untouched), 0.0},
          {scene, "ticks with small steps", static_cast<double>(stepped), 0.0}};
}

// Four robots meet corner on corner in the middle, each the last one turned by 90 degrees. A side
// is chosen by body index, so what follows has no symmetry (docs/model.md). Catches impacts that do
// not keep what they must.
Bars four_corners(Size /*size*/) {
  Start s;
  s.parameters = bouncing_with(0.6);
  for (const double way : {0.0, 1.0, 2.0, 3.0}) {
    const Heading out = Heading::from_angle(0.5 * pi * way);
    s.robots.push_back({0.12 * out.forward(), out, {-1.0, 0.0, 0.0}});
  }
  const auto world = world_of(s);
  double energy = kinetic_energy(*world);
  double momentum = 0.0;
  double angular = 0.0;
  double gained = 0.0;
  int impacts = 0;
  const std::vector<WheelCommand> commands(4, lifted);
  for (int k = 0; k < 6; ++k) {
    impacts += world->advance(commands, tick).impacts;
    Vec2 sum{0.0, 0.0};
    double turn = 0.0;  // about the middle, over the mass
    for (int i = 0; i < 4; ++i) {
      const Vec2 at = world->robot(i).position;
      const Vec2 v = velocity_of(*world, i);
      sum += v;
      turn += at.x() * v.y() - at.y() * v.x() +
              s.parameters.robot_inertia() / s.parameters.robot_mass * world->robot(i).twist.omega;
    }
    momentum = std::max(momentum, sum.norm());
    angular = std::max(angular, std::abs(turn));
    gained = std::max(gained, kinetic_energy(*world) / energy - 1.0);
    energy = kinetic_energy(*world);
  }
  const std::string scene = "four robots corner on corner";
  return {{scene, "sum of velocities, m/s", momentum, 1e-9},
          {scene, "angular momentum over mass, m^2/s", angular, 1e-9},
          {scene, "energy gained, relative", gained, 1e-12},
          {scene, "plays without a hit", static_cast<double>(impacts == 0), 0.0}};
}

// A robot that spins by 67 degrees a tick right beside a wall, and one that is driven into it.
Bars wheel_spin_at_wall(Size size) {
  const field::Field field = field::make_field(RobotLeague::small);
  Random random(8);
  double deepest = 0.0;
  double from_tiny = 0.0;
  int stepped = 0;
  int most_events = 0;
  const auto solids = test_support::solids_around(field);
  for (int i = 0; i < cases(size, 8, 500); ++i) {
    Start s;
    s.field = &field;
    const double away = random.uniform(0.038, 0.056);
    const double angle = random.uniform(-0.02, 0.02);
    s.robots.push_back(robot_at({0.1, field.half_width - away}, angle));
    if (overlap(s)) continue;
    const double spin =
        67.0 * pi / 180.0 / tick * s.parameters.wheel_distance / (2.0 * s.parameters.wheel_radius);
    const double forward = i % 2 == 0 ? 0.0 : random.uniform(-20.0, 20.0);
    const double way = random.coin() ? spin : -spin;
    const WheelCommand command = WheelSpeeds{forward - way, forward + way};
    const auto world = world_of(s);
    test_support::TinyWorld tiny(&field, s.parameters, 1, false, 1e-5);
    tiny.set_robot(0, s.robots[0]);
    for (int k = 0; k < 60; ++k) {
      const simulator::TickEvents& events = world->advance({&command, 1}, tick);
      deepest = std::max({deepest, events.deepest_overlap, deepest_overlap(*world, solids)});
      stepped += events.stepped;
      most_events = std::max(most_events, events.events);
      if (k >= 3) continue;
      tiny.advance({&command, 1}, tick);
      from_tiny = std::max(from_tiny, difference(world->robot(0), tiny.robot(0)));
    }
  }
  const std::string scene = "wheel spin of 67 degrees a tick at a wall";
  return {{scene, "overlap, m", deepest, 1e-9},
          {scene, "from tiny steps after 3 ticks, m and rad", from_tiny, 2e-5},
          {scene, "most events in a tick", static_cast<double>(most_events), most_events_of_one},
          {scene, "ticks with small steps", static_cast<double>(stepped), 0.0}};
}

// A robot bounces on the wall that it is driven into, and a ball between the two: infinitely many
// bounces in a finite time, then rest. The ball is in the middle and the robot's face is along the
// wall to the last bit: the bounces would multiply any deviation, and squeeze the ball out.
Bars zeno_bounces(Size size) {
  const field::Field field = field::make_field(RobotLeague::small);
  Random random(9);
  double speed = 0.0;
  double deepest = 0.0;
  int stepped = 0;
  int most_events = 0;
  const auto solids = test_support::solids_around(field);
  for (int i = 0; i < cases(size, 40, 1000); ++i) {
    Start s;
    s.field = &field;
    const double e = random.uniform(0.0, 0.95);
    s.parameters.restitution = {e, e, e, e};
    const double x = random.uniform(-0.2, 0.2);
    s.robots.push_back({{x, field.half_width - random.uniform(0.11, 0.15)},
                        Heading{0.0, 1.0},
                        {random.uniform(0.0, 1.8), 0.0, 0.0}});
    if (i % 2 == 0)
      s.ball.push_back({{x, field.half_width - 0.05}, {0.0, random.uniform(-1.0, 1.0)}});
    const double u = random.uniform(5.0, 80.0);
    const WheelCommand command = WheelSpeeds{u, u};
    const auto world = world_of(s);
    for (int k = 0; k < 90; ++k) {
      const simulator::TickEvents& events = world->advance({&command, 1}, tick);
      deepest = std::max({deepest, events.deepest_overlap, deepest_overlap(*world, solids)});
      stepped += events.stepped;
      most_events = std::max(most_events, events.events);
    }
    speed = std::max(speed, velocity_of(*world, 0).norm());
    if (!s.ball.empty()) speed = std::max(speed, world->ball().velocity.norm());
  }
  // At restitution 0.95 about 160 bounces lead from 1 m/s to one of series_height, and the ball has
  // two sides.
  constexpr double most_bounces = 250.0;
  const std::string scene = "Zeno bounces at a wall";
  return {{scene, "speed after 3 s, m/s", speed, 1e-7},
          {scene, "overlap, m", deepest, 1e-9},
          {scene, "most events in a tick", static_cast<double>(most_events), most_bounces},
          {scene, "ticks with small steps", static_cast<double>(stepped), 0.0}};
}

}  // namespace mirocup::scenes
