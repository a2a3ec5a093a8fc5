// SPDX-License-Identifier: MIT
//
// Numbers far from those of a game: faces that are nearly parallel, masses far apart, motors
// without a lag. And what every level of accuracy owes to a first impact.
#include "tests/physics/bars.hpp"
#include "tests/physics/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mirocup::scenes {

namespace {

using simulator::Accuracy;

std::unique_ptr<World> world_at(Accuracy level, const Start& s) {
  return world_of(s, simulator::tolerances_of(level));
}

constexpr double approach = 1.3;  // m/s
constexpr double aside = 0.03;    // m: the second robot's centre

// The first robot stands, turned by `angle`; the second runs into its face, `aside` to the left.
Start nearly_parallel(double angle) {
  Start s;
  s.parameters.restitution = {0.5, 0.5, 0.5, 0.5};
  s.robots = {{{0.0, 0.0}, Heading::from_angle(angle), {}},
              {{0.15, aside}, Heading{}, {-approach, 0.0, 0.0}}};
  return s;
}

// Speed along the first face's normal, and turn rate.
struct Motion {
  double speed, turn;
};

// The two ends of the common part of the faces hit in turn, each by equation (21), until both part.
// The places of the bodies do not change in between.
std::array<Motion, 2> hits_in_turn(const Parameters& p, double angle) {
  const double half = 0.5 * p.robot_side;
  const double place[] = {aside - half, half};  // m along the face; the first is hit first
  const double centre[] = {0.0, aside};
  std::array<Motion, 2> robots{{{0.0, 0.0}, {-approach, 0.0}}};
  const auto rate = [&](int end) {
    const auto speed_of = [&](int k) {
      return robots[k].speed - robots[k].turn * (place[end] - centre[k]);
    };
    return speed_of(1) - speed_of(0);
  };
  double gap[] = {0.0, angle * (place[1] - place[0])};
  while (true) {
    int next = -1;
    double time = std::numeric_limits<double>::infinity();
    for (int end = 0; end < 2; ++end) {
      const double closing = -rate(end);
      if (closing <= 0.0 || gap[end] / closing >= time) continue;
      next = end;
      time = gap[end] / closing;
    }
    if (next < 0) return robots;
    const double moved[] = {rate(0) * time, rate(1) * time};
    for (int end = 0; end < 2; ++end) gap[end] += moved[end];
    gap[next] = 0.0;
    const double levers[] = {place[next] - centre[0], place[next] - centre[1]};
    const double inverse =
        2.0 / p.robot_mass + (levers[0] * levers[0] + levers[1] * levers[1]) / p.robot_inertia();
    const double impulse = -(1.0 + p.restitution.robot_robot) * rate(next) / inverse;
    for (int k = 0; k < 2; ++k) {
      const double signed_impulse = k == 0 ? -impulse : impulse;
      robots[k].speed += signed_impulse / p.robot_mass;
      robots[k].turn -= signed_impulse * levers[k] / p.robot_inertia();
    }
  }
}

std::array<Motion, 2> motions_after(Accuracy level, const Start& s) {
  constexpr double soon = 0.06;  // s: 2 ms after the hits, before a corner comes round again
  const auto world = world_at(level, s);
  world->advance(std::vector<WheelCommand>(2), soon);
  std::array<Motion, 2> all{};
  for (int k = 0; k < 2; ++k) {
    const BodyState r = world->robot(k);
    all[k] = {r.velocity().x(), r.twist.omega};
  }
  return all;
}

double difference(const std::array<Motion, 2>& a, const std::array<Motion, 2>& b) {
  double most = 0.0;
  for (int k = 0; k < 2; ++k) {
    most = std::max({most, std::abs(a[k].speed - b[k].speed), std::abs(a[k].turn - b[k].turn)});
  }
  return most;
}

}  // namespace

// Catches an order of the corners that is decided by a tolerance: the twists differ fourfold
// between a hit of both at once and hits in turn. Below 2e-9 rad both gaps are below contact_gap.
Bars nearly_parallel_faces(Size /*size*/) {
  double in_turn = 0.0;
  double at_once = 0.0;
  double head_on = 0.0;
  for (const Accuracy level : levels) {
    Start centred = nearly_parallel(0.0);
    centred.robots[1].position.y() = 0.0;
    const double half = 0.5 * approach;  // equal masses: (21) with e = 0.5
    head_on = std::max(head_on, difference(motions_after(level, centred),
                                           {{{-1.5 * half, 0.0}, {-0.5 * half, 0.0}}}));
    for (const double angle : {1e-6, 1e-4}) {
      const Start s = nearly_parallel(angle);
      in_turn = std::max(
          in_turn, difference(motions_after(level, s), hits_in_turn(s.parameters, angle)) / angle);
    }
    const auto flush = motions_after(level, nearly_parallel(0.0));
    const auto nearly = motions_after(level, nearly_parallel(1e-9));
    at_once = std::max(at_once, difference(flush, nearly) / 1e-9);
  }
  const std::string scene = "faces parallel to 1e-9, 1e-6 and 1e-4 rad";
  // The closed form leaves out that the bodies turn by 16 rad/s between two hits.
  return {{scene, "parallel, centred: from (21), m/s and rad/s", head_on, 1e-12},
          {scene, "1e-6, 1e-4: from hits in turn, m/s and rad/s a rad", in_turn, 200.0},
          {scene, "1e-9: from parallel faces, m/s and rad/s a rad", at_once, 200.0}};
}

// Returns how far `coarse` and `standard` are from `reference` after a slow ball has bounced off a
// robot: 1 if it has not.
double difference_of_slow_bounces() {
  double worst = 0.0;
  for (const double speed : {0.001, 0.002, 0.004, 0.008}) {
    Start s;
    s.parameters = without_rolling_friction();
    s.robots = {{{0.0, 0.0}, Heading{}, {}}};
    const double touching = 0.5 * s.parameters.robot_side + s.parameters.ball_radius;
    s.ball.push_back({{touching + 0.1 * tick * speed, 0.01}, {-speed, 0.0}});
    std::array<simulator::BallState, std::size(levels)> after;
    for (const Accuracy level : levels) {
      const auto world = world_at(level, s);
      world->advance(std::vector<WheelCommand>(1), tick);
      after[static_cast<std::size_t>(level)] = world->ball();
    }
    const double truth = after[static_cast<std::size_t>(Accuracy::reference)].velocity.x();
    if (truth <= 0.0) return 1.0;
    for (const simulator::BallState& ball : after)
      worst = std::max(worst, std::abs(ball.velocity.x() - truth) / speed);
  }
  return worst;
}

// A robot pushes against a wall, and another one runs into its back at 2 to 8 cm/s: returns how far
// `standard` is from `reference` after 0.1 s, m. The wall must throw the first one back, though it
// pressed before.
double difference_of_bounces_off_a_press() {
  const field::Field field = field::make_field(RobotLeague::small);
  double worst = 0.0;
  for (const double speed : {0.02, 0.03, 0.04, 0.06, 0.08}) {
    Start s;
    s.field = &field;
    const double half = 0.5 * s.parameters.robot_side;
    s.robots = {
        {{0.0, field.half_width - half}, Heading{0.0, 1.0}, {}},
        {{0.01, field.half_width - 3.0 * half - 0.001}, Heading{0.0, 1.0}, {speed, 0.0, 0.0}}};
    const std::vector<WheelCommand> commands{WheelSpeeds{1.0, 1.0}, WheelCommand{}};
    const auto truth = world_at(Accuracy::reference, s);
    const auto standard = world_at(Accuracy::standard, s);
    for (int k = 0; k < 3; ++k) {
      truth->advance(commands, tick);
      standard->advance(commands, tick);
    }
    for (int i = 0; i < 2; ++i)
      worst = std::max(worst, difference(standard->robot(i), truth->robot(i)));
  }
  return worst;
}

// Catches a level whose tolerances of lasting contacts change what hits for the first time, and one
// that drops slow bounces.
Bars first_impacts_of_levels(Size size) {
  double worst = 0.0;
  int hits = 0;
  Random random(23);
  for (int i = 0; i < cases(size, 300, 10000); ++i) {
    Start s;
    const auto robot = [&](const Vec2& at) {
      const simulator::Twist twist{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                   random.uniform(-9.0, 9.0)};
      return BodyState{at, random_heading(random), twist};
    };
    s.robots.push_back(robot({0.0, 0.0}));
    const Vec2 other{0.2, random.uniform(-0.06, 0.06)};
    if (random.coin()) {
      s.ball.push_back({other, {random.uniform(-3.0, 0.0), random.uniform(-0.5, 0.5)}});
    } else {
      s.robots.push_back(robot(other));
    }
    const std::vector<WheelCommand> lifted(s.robots.size());
    const auto truth = world_at(Accuracy::reference, s);
    const auto coarse = world_at(Accuracy::coarse, s);
    const auto standard = world_at(Accuracy::standard, s);
    int impacts = 0;
    for (int k = 0; k < 8; ++k) {
      impacts += truth->advance(lifted, tick).impacts;
      for (World* world : {coarse.get(), standard.get()}) {
        world->advance(lifted, tick);
        if (impacts > 1) continue;
        for (int robot_of = 0; robot_of < world->robots(); ++robot_of) {
          worst = std::max({worst, difference(world->robot(robot_of), truth->robot(robot_of)),
                            velocity_difference(world->robot(robot_of), truth->robot(robot_of))});
        }
      }
    }
    hits += impacts > 0;
  }
  const std::string scene = "first impact of free bodies";
  return {{scene, "coarse and standard from reference, m and m/s", worst, 1e-12},
          {scene, "share without a hit", 1.0 - hits / double(cases(size, 300, 10000)), 0.8},
          {scene, "coarse and standard, 1 to 8 mm/s, relative", difference_of_slow_bounces(), 1e-9},
          {scene, "standard, off a wall that was pressed, m", difference_of_bounces_off_a_press(),
           2e-4}};
}

// A robot of 10 000 kg closes the gap to a wall in which the ball bounces, and is thrown back by
// it. Catches energy from nothing, and a tick without end. Over its budget of events `standard`
// steps the ball, which takes its energy.
Bars mass_ratios(Size /*size*/) {
  const field::Field field = field::make_field(RobotLeague::small);
  double gained = -1.0;
  double lost = 0.0;
  int most_events = 0;
  for (const Accuracy level : levels) {
    Start s;
    s.field = &field;
    s.parameters = without_rolling_friction();
    s.parameters.restitution = {1.0, 1.0, 1.0, 1.0};
    s.parameters.robot_mass = 1e4;
    s.robots.push_back({{0.0, field.half_width - 0.2}, Heading{0.0, 1.0}, {0.5, 0.0, 0.0}});
    s.ball.push_back({{0.0, field.half_width - 0.08}, {0.0, 1.0}});
    const auto world = world_at(level, s);
    const double before = kinetic_energy(*world);
    const WheelCommand lifted;
    for (int k = 0; k < 15; ++k) {
      const simulator::TickEvents& events = world->advance({&lifted, 1}, tick);
      if (level == Accuracy::standard) most_events = std::max(most_events, events.events);
      const double change = kinetic_energy(*world) / before - 1.0;
      gained = std::max(gained, change);
      if (level != Accuracy::standard) lost = std::max(lost, -change);
    }
  }
  const std::string scene = "ball between a wall and a robot of 1e4 kg";
  return {{scene, "energy gained, relative", gained, 1e-9},
          {scene, "energy lost at coarse and reference, relative", lost, 1e-9},
          {scene, "most events in a tick of standard", static_cast<double>(most_events), 500.0}};
}

// Catches a cost that grows without bound as the lag falls, and a robot that does not keep up.
Bars instant_motors(Size /*size*/) {
  double behind = 0.0;
  int most_events = 0;
  for (const double lag : {1e-5, 1e-9, 1e-300}) {
    Start s;
    s.parameters.motor_time_constant = lag;
    s.robots.push_back({{0.0, 0.0}, Heading{}, {}});
    const auto world = world_of(s);
    const WheelCommand command = WheelSpeeds{30.0, 30.0};
    const double speed = 30.0 * s.parameters.wheel_radius;
    for (int k = 1; k <= 3; ++k) {
      most_events = std::max(most_events, world->advance({&command, 1}, tick).events);
      behind = std::max(behind, std::abs(world->robot(0).position.x() - speed * tick * k) / speed);
    }
  }
  const std::string scene = "motors with lags of 1e-5 s and less";
  return {{scene, "behind motors without a lag, s", behind, 1.001e-5},
          {scene, "most events in a tick", static_cast<double>(most_events), 6000.0}};
}

}  // namespace mirocup::scenes
