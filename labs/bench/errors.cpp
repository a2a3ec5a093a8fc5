// SPDX-License-Identifier: MIT
#include "labs/bench/errors.hpp"

#include "core/base/random.hpp"
#include "tests/support/exact_motion.hpp"
#include "tests/support/tiny_world.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::bench {

namespace {

using simulator::BodyState;
using simulator::WheelSpeeds;
using test_support::Outline;
using Positions = std::array<std::vector<Vec2>, 2>;

WheelSpeeds random_wheels(Random& random) {
  constexpr double fastest = 80.0;  // rad/s
  const double left = random.uniform(-fastest, fastest);
  return {left, random.uniform(-fastest, fastest)};
}

Vec2 random_in(Random& random, double half_x, double half_y) {
  const double x = random.uniform(-half_x, half_x);
  return {x, random.uniform(-half_y, half_y)};
}

BodyState random_robot(Random& random, const Vec2& at) {
  BodyState r{at, Heading::from_angle(random.uniform(-pi, pi)), {}};
  r.twist.forward = random.uniform(-1.0, 1.0);
  r.twist.omega = random.uniform(-7.0, 7.0);
  return r;
}

Vec2 random_velocity(Random& random) {
  const double speed = random.uniform(0.0, 2.0);
  return speed * Heading::from_angle(random.uniform(-pi, pi)).forward();
}

void add_commands(Random& random, Moment& moment) {
  for (int i = 0; i < ticks_of_moment; ++i) {
    Commands& all = moment.commands.emplace_back();
    for (std::size_t k = 0; k < moment.start.robots.size(); ++k) {
      all.push_back(random_wheels(random));
    }
  }
}

// True if two bodies start closer to each other than 0.1 mm.
bool is_crowded_out(const Start& start, const std::vector<Outline>& solids) {
  constexpr double apart = 1e-4;
  std::vector<Outline> bodies;
  for (const BodyState& r : start.robots) {
    bodies.push_back(
        test_support::square_at(r.position, r.heading.angle(), start.parameters.robot_side));
  }
  bodies.push_back(test_support::circle_at(start.ball.position, start.parameters.ball_radius));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (test_support::distance(bodies[i], bodies[j]) < apart) return true;
    }
    for (const Outline& solid : solids) {
      if (test_support::distance(bodies[i], solid) < apart) return true;
    }
  }
  return false;
}

template <class World>
std::vector<Vec2> positions_in(const World& world, const Moment& moment) {
  std::vector<Vec2> all;
  for (std::size_t i = 0; i < moment.start.robots.size(); ++i) {
    all.push_back(world.robot(static_cast<int>(i)).position);
  }
  all.push_back(world.ball().position);
  return all;
}

template <class World>
Positions play(const Moment& moment, World& world, auto advance) {
  Positions positions;
  for (int i = 0; i < ticks_of_moment; ++i) {
    advance(world, moment.commands[i]);
    if (i == 0) positions[0] = positions_in(world, moment);
  }
  positions[1] = positions_in(world, moment);
  return positions;
}

Positions in_tiny_steps(const Moment& moment, const field::Field& field, double step) {
  const Start& s = moment.start;
  test_support::TinyWorld world(&field, s.parameters, static_cast<int>(s.robots.size()), true,
                                step);
  for (std::size_t i = 0; i < s.robots.size(); ++i) {
    world.set_robot(static_cast<int>(i), s.robots[i]);
  }
  world.set_ball(s.ball);
  return play(moment, world, [](auto& w, const Commands& c) { w.advance(c, tick); });
}

Positions exactly(const Moment& moment) {
  Positions positions;
  auto robot = test_support::exactly(moment.start.robots[0]);
  const auto ball = test_support::exactly(moment.start.ball);
  for (int i = 0; i < ticks_of_moment; ++i) {
    robot =
        test_support::drive_exactly(moment.start.parameters, robot, moment.commands[i][0], tick);
    if (i > 0 && i < ticks_of_moment - 1) continue;
    const auto rolled = test_support::roll_exactly(moment.start.parameters, ball,
                                                   (i + 1) * test_support::Real(tick));
    positions[i == 0 ? 0 : 1] = {{static_cast<double>(robot.x), static_cast<double>(robot.y)},
                                 {static_cast<double>(rolled.x), static_cast<double>(rolled.y)}};
  }
  return positions;
}

double largest(const std::vector<Vec2>& a, const std::vector<Vec2>& b, std::size_t from,
               std::size_t to) {
  double worst = 0.0;
  for (std::size_t i = from; i < to; ++i) worst = std::max(worst, (a[i] - b[i]).norm());
  return worst;
}

double largest(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return largest(a, b, 0, a.size());
}

Spread spread(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return {at(0.5), at(0.9), at(0.99)};
}

// Returns the share of shots at the body at the origin that end beyond it. Each shot starts a
// little farther away, so that its steps end at other places of its path.
double share_through(const Contender& contender, const simulator::Parameters& parameters,
                     double speed) {
  constexpr int phases = 40;
  int through = 0;
  for (int i = 0; i < phases; ++i) {
    Start s;
    s.parameters = parameters;
    s.robots.push_back({{0.0, 0.0}, {}, {}});
    const double way = speed * tick * (1.0 + static_cast<double>(i) / phases);
    s.ball = {{-half_size(parameters).x() - parameters.ball_radius - way, 0.007}, {speed, 0.0}};
    const auto engine = contender.make(s);
    const Commands lifted(1);  // wheels off the ground: it only stands there
    for (int k = 0; k < 4; ++k) engine->advance(lifted);
    through += engine->ball().position.x() > engine->robot(0).position.x();
  }
  return static_cast<double>(through) / phases;
}

}  // namespace

Moments free_motion(int count) {
  Random random(6);
  Moments moments;
  for (int i = 0; i < count; ++i) {
    Moment m;
    m.start.robots.push_back(random_robot(random, {0.0, 0.0}));
    m.start.ball = {{5.0, 0.0}, random_velocity(random)};
    add_commands(random, m);
    m.positions = exactly(m);
    moments.all.push_back(std::move(m));
  }
  return moments;
}

Moments crowds(int count, double step) {
  constexpr int robots = 6;
  constexpr double half_crowd = 0.3;
  const field::Field field = field::make_field(RobotLeague::small);
  const auto solids = test_support::solids_around(field);
  Random random(5);
  Moments moments;
  std::vector<double> one, all;
  for (int i = 0; i < count; ++i) {
    Moment m;
    do {
      m.start = {};
      m.start.league = RobotLeague::small;
      const Vec2 centre = random_in(random, 0.5, 0.4);
      for (int k = 0; k < robots; ++k) {
        const Vec2 at = centre + random_in(random, half_crowd, half_crowd);
        m.start.robots.push_back(random_robot(random, at));
      }
      const Vec2 at = centre + random_in(random, half_crowd, half_crowd);
      m.start.ball = {at, random_velocity(random)};
    } while (is_crowded_out(m.start, solids));
    add_commands(random, m);
    m.positions = in_tiny_steps(m, field, step);
    const Positions coarser = in_tiny_steps(m, field, 2.0 * step);
    one.push_back(largest(m.positions[0], coarser[0]));
    all.push_back(largest(m.positions[1], coarser[1]));
    moments.all.push_back(std::move(m));
  }
  moments.after_one = spread(one);
  moments.after_all = spread(all);
  return moments;
}

MomentErrors errors(const Moments& moments, const Contender& contender) {
  std::vector<double> one, five, robots, ball;
  for (const Moment& m : moments.all) {
    const auto engine = contender.make(m.start);
    const Positions p = play(m, *engine, [](auto& e, const Commands& c) { e.advance(c); });
    const std::size_t count = m.start.robots.size();
    one.push_back(largest(p[0], m.positions[0]));
    five.push_back(largest(p[1], m.positions[1]));
    robots.push_back(largest(p[1], m.positions[1], 0, count));
    ball.push_back(largest(p[1], m.positions[1], count, count + 1));
  }
  return {spread(one), spread(five), spread(robots), spread(ball)};
}

Shots shots(const Contender& contender) {
  simulator::Parameters plate;  // 5 mm by 300 mm, too heavy to be moved
  plate.robot_corners.corners = 4;
  plate.robot_corners.x = {-0.0025, 0.0025, 0.0025, -0.0025};
  plate.robot_corners.y = {-0.15, -0.15, 0.15, 0.15};
  plate.robot_mass = 1e3;
  Shots all;
  for (std::size_t i = 0; i < std::size(shot_speeds); ++i) {
    all.through_robot[i] = share_through(contender, {}, shot_speeds[i]);
    all.through_plate[i] = share_through(contender, plate, shot_speeds[i]);
  }
  return all;
}

}  // namespace mirocup::bench
