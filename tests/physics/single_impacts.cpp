// SPDX-License-Identifier: MIT
//
// One impact of one pair, at random: its time against a search on the exact motion, its velocities
// against equation (21), and what it must conserve.
#include "tests/physics/bars.hpp"
#include "tests/physics/encounter.hpp"
#include "tests/physics/scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mirocup::scenes {

using namespace test_support;

namespace {

enum class Target { wall, post, robot };

struct Scene {
  Start start;
  std::vector<WheelCommand> commands;
  MovingOutline a, b;
};

Outline solid_of(const field::Field& field, Target target) {
  // In the order of solids_around(): the right side's cut corner and end wall come last.
  const auto solids = test_support::solids_around(field);
  return target == Target::wall ? solids[6] : solids[11];
}

BodyState random_robot(Random& random, const Parameters& p, const Vec2& at, const Vec2& velocity,
                       const WheelCommand& command) {
  BodyState r{at, random_heading(random), {}};
  const Vec2 v = r.heading.to_body(velocity);
  const bool holds = command && p.grip == simulator::infinite_grip;
  r.twist = {v.x(), holds ? 0.0 : v.y(), random.uniform(-20.0, 20.0)};
  return r;
}

WheelCommand random_command(Random& random, const Parameters& p) {
  return random.coin() ? random_wheels(random, 80.0, p) : WheelCommand{};
}

// A body a little away from its target, on its way to it.
Scene random_scene(Random& random, bool ball, Target target, const field::Field& field,
                   const Parameters& parameters) {
  Scene s;
  s.start.parameters = parameters;
  Vec2 aim{0.0, 0.0};
  if (target == Target::robot) {
    const WheelCommand command = random_command(random, parameters);
    const BodyState other =
        random_robot(random, parameters, {0.0, 0.0}, random_in(random, 0.5, 0.5), command);
    s.start.robots.push_back(other);
    s.commands.push_back(command);
    s.b = {.robot = exactly(other), .ball = {}, .command = command, .solid = {}};
  } else {
    s.start.field = &field;
    s.b.solid = solid_of(field, target);
    aim = target == Target::wall ? Vec2{random.uniform(-0.4, 0.4), field.half_width}
                                 : Vec2{field.half_length, field.goal_half_width};
  }
  const Vec2 from = aim + random.uniform(0.12, 0.2) * random_heading(random).forward();
  const Vec2 towards = (aim + random_in(random, 0.05, 0.05) - from).normalized();
  const Vec2 velocity = random_logarithmic(random, 0.2, 10.0) * towards;
  if (ball) {
    s.start.ball.push_back({from, velocity});
    s.a.ball = exactly(s.start.ball[0]);
    return s;
  }
  const WheelCommand command = random_command(random, parameters);
  s.start.robots.push_back(random_robot(random, parameters, from, 0.3 * velocity, command));
  s.commands.push_back(command);
  s.a = {.robot = exactly(s.start.robots.back()), .ball = {}, .command = command, .solid = {}};
  return s;
}

// At a post, other things can be in the way.
bool can_be_reached(const Scene& s, const field::Field& field, const Encounter& e) {
  if (s.start.field == nullptr) return true;
  const Vec2 post{field.half_length, field.goal_half_width};
  return e.touch.point.y() > field.half_width - 1e-6 || (e.touch.point - post).norm() < 0.05;
}

Parameters random_parameters(Random& random, Parameters p) {
  if (random.coin()) p.grip = simulator::infinite_grip;
  const double e = random.uniform();
  p.restitution = {e, e, e, e};
  return p;
}

// Is the simulator's impact within `window` seconds of that time?
bool impact_is_at(const Scene& s, Real time, double window) {
  const auto world = world_of(s.start);
  const double before = static_cast<double>(time - window);
  if (world->advance(s.commands, before).impacts != 0) return false;
  return world->advance(s.commands, 2.0 * window).impacts == 1;
}

// Does the body meet another part of the field before its target?
bool is_intercepted(const Scene& s, const field::Field& field, Real time) {
  if (s.start.field == nullptr) return false;
  const auto solids = test_support::solids_around(field);
  return std::any_of(solids.begin(), solids.end(), [&](const Outline& solid) {
    MovingOutline body = s.a;
    MovingOutline other{.robot = {}, .ball = {}, .command = {}, .solid = solid};
    const auto e = first_touch(s.start.parameters, body, other, time);
    return e && e->time < time - 1e-6L;
  });
}

// Wide enough that no tick begins where two touch already by the tolerance.
constexpr double clear = 1e-6;  // s

// Returns the world `clear` seconds before an impact, and puts the bodies of the scene where those
// of the world are: the error of free motion until then has a bar of its own. Returns null if a
// body bounced earlier.
std::unique_ptr<World> world_before(Real time, Scene& s) {
  auto world = world_of(s.start);
  if (world->advance(s.commands, static_cast<double>(time) - clear).impacts != 0) return nullptr;
  if (s.a.robot) s.a.robot = exactly(world->robot(world->robots() - 1));
  if (s.a.ball) s.a.ball = exactly(world->ball());
  if (s.b.robot) s.b.robot = exactly(world->robot(0));
  return world;
}

// Equation (21) at the impact, then `after` seconds on the way.
void bounce_and_move(const Parameters& p, const Encounter& e, double after, Scene& s) {
  const double restitution = p.restitution.ball_wall;  // of every pair
  const double bracket = inverse_mass(p, s.a, e.touch) + inverse_mass(p, s.b, e.touch);
  const double impulse = (1.0 + restitution) * e.approach / bracket;
  push(p, s.a, e.touch, impulse);
  push(p, s.b, e.touch, -impulse);
  s.a.move(p, after);
  s.b.move(p, after);
}

// The velocities `clear` after an impact, against (21). Nothing if there is not one impact then.
std::optional<double> velocity_error(Scene s, Real time) {
  const Parameters& p = s.start.parameters;
  const auto world = world_before(time, s);
  if (world == nullptr) return {};
  const std::optional<Encounter> last = first_touch(p, s.a, s.b, 0.1L);
  if (!last || world->advance(s.commands, 2.0 * clear).impacts != 1) return {};
  bounce_and_move(p, *last, static_cast<double>(2.0L * clear - last->time), s);
  double worst = 0.0;
  const auto compare = [&](const MovingOutline& m, int index) {
    if (m.robot) {
      worst = std::max(worst, velocity_difference(world->robot(index), rounded(*m.robot)));
    } else if (m.ball) {
      const Vec2& v = world->ball().velocity;
      worst =
          std::max(worst, static_cast<double>(std::hypot(v.x() - m.ball->vx, v.y() - m.ball->vy)));
    }
  };
  compare(s.a, world->robots() - 1);
  compare(s.b, 0);
  return worst;
}

struct PairKind {
  const char* name;
  bool ball;
  Target target;
};

constexpr PairKind pair_kinds[] = {
    {"ball on wall", true, Target::wall},        {"ball on goal post", true, Target::post},
    {"ball on robot", true, Target::robot},      {"robot on wall", false, Target::wall},
    {"robot on goal post", false, Target::post}, {"robot on robot", false, Target::robot}};

void add_bars(const PairKind& kind, const std::string& scene, const Parameters& base, int wanted,
              Bars& bars) {
  // From coarse to fine: the last one in which the impact is found bounds the error of its time.
  constexpr double windows[] = {1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14};
  const field::Field field = field::make_field(RobotLeague::small);
  Random random(mix_seed(static_cast<std::uint64_t>(kind.name[0] + 256 * kind.name[6])) +
                (kind.ball ? 1 : 2));
  double worst_time = 0.0;
  double worst_velocity = 0.0;
  int missed = 0;
  int several = 0;
  for (int found = 0; found < wanted;) {
    const Parameters p = random_parameters(random, base);
    const Scene s = random_scene(random, kind.ball, kind.target, field, p);
    if (overlap(s.start)) continue;
    MovingOutline a = s.a;
    MovingOutline b = s.b;
    const std::optional<Encounter> e = first_touch(p, a, b, 0.1L);
    if (!e || !can_be_reached(s, field, *e)) continue;
    if (!impact_is_at(s, e->time, windows[0])) {
      if (is_intercepted(s, field, e->time)) continue;
      ++found;
      ++missed;
      continue;
    }
    ++found;
    if (const auto error = velocity_error(s, e->time)) {
      worst_velocity = std::max(worst_velocity, *error);
    } else {
      ++several;
    }
    double bound = windows[0];
    for (const double window : windows) {
      if (!impact_is_at(s, e->time, window)) break;
      bound = window;
    }
    worst_time = std::max(worst_time, bound);
  }
  bars.push_back({scene, "impacts not found within 1e-9 s", static_cast<double>(missed), 0.0});
  bars.push_back({scene, "share with several impacts within 2e-6 s, not compared",
                  several / static_cast<double>(wanted), 0.01});
  bars.push_back({scene, "error of the time, s, at most", worst_time, 1e-9});
  bars.push_back({scene, "velocities against (21), m/s and rad/s", worst_velocity, 1e-9});
}

// Momentum and, about the origin, angular momentum, with their sizes.
struct Momentum {
  Vec2 linear{0.0, 0.0};
  double angular = 0.0, size = 0.0, angular_size = 0.0;

  void add(double mass, const Vec2& at, const Vec2& velocity, double spin) {
    linear += mass * velocity;
    angular += mass * cross(at, velocity) + spin;
    size += mass * velocity.norm();
    angular_size += mass * at.norm() * velocity.norm() + std::abs(spin);
  }
};

Momentum momentum_of(const World& world) {
  const Parameters& p = world.parameters();
  Momentum sum;
  for (int i = 0; i < world.robots(); ++i) {
    const BodyState r = world.robot(i);
    sum.add(p.robot_mass, r.position, r.heading.to_world({r.twist.forward, r.twist.left}),
            inertia(p) * r.twist.omega);
  }
  if (world.static_world().has_ball) {
    sum.add(1.4 * p.ball_mass, world.ball().position, world.ball().velocity, 0.0);
  }
  return sum;
}

}  // namespace

Bars single_impacts(Size size) {
  Bars bars;
  for (const PairKind& kind : pair_kinds) {
    add_bars(kind, std::string("single impacts: ") + kind.name, {}, cases(size, 60, 10000), bars);
  }
  return bars;
}

Bars motors_in_impacts(Size size) {
  Bars bars;
  const Motors& motors = other_motors[std::size(other_motors) - 1];
  for (const PairKind& kind : pair_kinds) {
    if (kind.ball && kind.target != Target::robot) continue;  // no motor takes part
    add_bars(kind, std::string(motors.name) + ": " + kind.name, with(motors),
             cases(size, 30, 10000), bars);
  }
  return bars;
}

// Free bodies, so that nothing but the impact changes energy and momentum.
Bars conserved_in_impacts(Size size) {
  Random random(3);
  const field::Field field = field::make_field(RobotLeague::small);
  double worst_energy = 0.0;
  double worst_momentum = 0.0;
  int found = 0;
  while (found < cases(size, 300, 10000)) {
    Parameters p = without_rolling_friction();
    const double e = random.uniform();
    p.restitution = {e, e, e, e};
    const PairKind& kind = pair_kinds[random.below(std::size(pair_kinds))];
    Scene s = random_scene(random, kind.ball, kind.target, field, p);
    for (WheelCommand& command : s.commands) command.reset();
    s.a.command.reset();
    s.b.command.reset();
    if (overlap(s.start)) continue;
    const std::optional<Encounter> touch = first_touch(p, s.a, s.b, 0.1L);
    if (!touch || !can_be_reached(s, field, *touch)) continue;
    const auto world = world_before(touch->time, s);
    if (world == nullptr) continue;
    const double energy = kinetic_energy(*world);
    const Momentum before = momentum_of(*world);
    const std::optional<Encounter> last = first_touch(p, s.a, s.b, 0.1L);
    if (!last || world->advance(s.commands, 2.0 * clear).impacts != 1) continue;
    ++found;
    const double bracket = inverse_mass(p, s.a, last->touch) + inverse_mass(p, s.b, last->touch);
    const double loss = 0.5 * (1.0 - e * e) * last->approach * last->approach / bracket;
    worst_energy =
        std::max(worst_energy, std::abs(kinetic_energy(*world) - (energy - loss)) / energy);
    if (kind.target != Target::robot) continue;
    const Momentum after = momentum_of(*world);
    worst_momentum = std::max({worst_momentum, (after.linear - before.linear).norm() / before.size,
                               std::abs(after.angular - before.angular) / before.angular_size});
  }
  return {
      {"single impacts of free bodies", "energy against (1 - e^2), relative", worst_energy, 1e-12},
      {"single impacts of free bodies", "momentum and angular momentum, relative", worst_momentum,
       1e-12}};
}

}  // namespace mirocup::scenes
