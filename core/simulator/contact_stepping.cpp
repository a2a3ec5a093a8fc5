// SPDX-License-Identifier: MIT
#include "core/simulator/contact_stepping.hpp"

#include "core/simulator/ball_motion.hpp"
#include "core/simulator/near_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator {

namespace {

constexpr double radii_a_step = 0.5;

// Looks at the end of a step, and times that it is halved, before what is found there is taken.
constexpr int most_looks = 10;
constexpr int most_halvings = 3;

// Rounds in which the bounds of friction follow the normal impulses.
constexpr int friction_rounds = 10;

// The twist after a step without any contact and without the ground's sideways force.
Twist driven(const Parameters& p, const Drive& drive, const Twist& v, double step) {
  // The frame turns; the velocity does not.
  const Heading turned = Heading::from_angle(v.turn * step);
  const Vec2 kept = v.left == 0.0 ? Vec2{v.forward, -v.forward * turned.sin}
                                  : turned.to_body({v.forward, v.left});
  Twist next{kept.x(), kept.y(), v.turn};
  if (!drive.wheels_on_ground) return next;
  const double reached = -expm1(-step / p.motor_time_constant);
  next.forward += reached * (drive.forward - v.forward);
  next.turn += reached * (drive.turn - v.turn);
  if (p.grip == infinite_grip) next.left = 0.0;
  return next;
}

Twist braked(const Parameters& p, const Twist& v, double step) {
  const RollingDeceleration d = rolling_deceleration(p);
  const auto part_left = [&](double speed) {
    return speed == 0.0 ? 1.0 : std::max(0.0, 1.0 - step * (d.constant / speed + d.linear));
  };
  if (d.is_per_axis()) {
    return {v.forward * part_left(std::max(std::abs(v.forward), d.per_axis_below)),
            v.left * part_left(std::max(std::abs(v.left), d.per_axis_below)), 0.0};
  }
  const double left = part_left(std::sqrt(v.forward * v.forward + v.left * v.left));
  return {v.forward * left, v.left * left, 0.0};
}

// No point of the body is faster, m/s.
double speed_at_most(const Shape& shape, const Twist& v) {
  return std::abs(v.forward) + std::abs(v.left) + std::abs(v.turn) * shape.radius;
}

}  // namespace

ContactStepping::ContactStepping(const Arena& arena, BoxProblem& problem)
    : arena_(arena), problem_(problem) {
  for (int i = 0; i < arena.robots; ++i) wheels_[i] = wheels_as_contact(i);
}

ContactStepping::Step ContactStepping::take(const BodySet& candidates,
                                            std::span<const Drive> drives,
                                            std::span<const InverseMass> mass, double longest,
                                            std::span<Body> bodies) {
  const double length = longest_step(candidates, bodies);
  double parts = std::ceil(longest / length);
  Step step;
  for (int halved = 0; halved <= most_halvings; ++halved, parts *= 2.0) {
    if (find(candidates, drives, mass, longest / parts, bodies, step)) break;
  }
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (step.members[i]) bodies[i].twist = end_[i].twist;
  }
  keep_what_presses();
  return step;
}

void ContactStepping::keep_what_presses() {
  int left = 0;
  for (Contact& c : contacts_.contacts()) {
    c.holds = c.impulse != 0.0;
    if (c.holds) contacts_.list[left++] = c;
  }
  contacts_.count = left;
}

double ContactStepping::fastest_of(const BodySet& some, std::span<const Body> bodies) const {
  double fastest = 0.0;
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (!some[i]) continue;
    fastest = std::max(fastest, speed_at_most(arena_.shape(i), bodies[i].twist));
  }
  return fastest;
}

// Nothing goes farther than half the ball's radius in a step: it would be seen behind what it hit.
double ContactStepping::longest_step(const BodySet& some, std::span<const Body> bodies) const {
  const double fastest = fastest_of(some, bodies);
  const double farthest = radii_a_step * arena_.parameters.ball_radius;
  const double length = arena_.tolerances.step;
  return fastest * length > farthest ? farthest / fastest : length;
}

// A step of that length. False if overlaps remain at its end, or if it turns out to be too long.
bool ContactStepping::find(const BodySet& candidates, std::span<const Drive> drives,
                           std::span<const InverseMass> mass, double length,
                           std::span<const Body> bodies, Step& step) {
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (!candidates[i]) continue;
    alone_[i].twist = arena_.is_ball(i)
                          ? braked(arena_.parameters, bodies[i].twist, length)
                          : driven(arena_.parameters, drives[i], bodies[i].twist, length);
  }
  look_ahead(candidates, length, bodies);
  step = {{}, length};
  for (const Contact& c : contacts_.contacts()) step.members |= bodies_of(c.pair);
  if (step.members.none()) return true;
  return settle(step.members, drives, mass, length, bodies) &&
         length <= 1.5 * longest_step(step.members, end_);
}

// What motors can do to the distance of two corners within a step, m: both robots go to full speed, or
// to their fastest turn, which moves a corner about as fast, and do so over the whole step.
double ContactStepping::reach_of_motors(double length) const {
  const Parameters& p = arena_.parameters;
  const double fastest = p.wheel_radius * p.wheel_speed_limit;
  return 2.0 * 2.0 * fastest / p.motor_time_constant * length * length;
}

// Where the candidates would be if they kept their twists, and what is close to what there.
void ContactStepping::look_ahead(const BodySet& candidates, double length,
                                 std::span<const Body> bodies) {
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (candidates[i]) end_[i] = along_arc(bodies[i], length);
  }
  const double margin = fastest_of(candidates, bodies) * length + reach_of_motors(length);
  for (int i = 0; i < arena_.bodies(); ++i) {
    const Vec2& p = end_[i].position;
    boxes_[i] = {p.x() - margin, p.x() + margin, p.y() - margin, p.y() + margin};
  }
  contacts_.count = 0;
  const unsigned long others = candidates.to_ulong();
  for (int i = 0; i < arena_.bodies(); ++i) {
    if (!candidates[i]) continue;
    for_near_pairs(arena_, boxes_, i, others & bodies_below(i),
                   [&](const Pair& pair) { add_contacts(arena_, pair, end_, margin, contacts_); });
  }
}

// Solves until what was solved for is what is found. False if that does not come about.
bool ContactStepping::settle(const BodySet& members, std::span<const Drive> drives,
                             std::span<const InverseMass> mass, double length,
                             std::span<const Body> bodies) {
  for (int look = 0; look < most_looks; ++look) {
    solve(members, drives, mass, length, look > 0);
    for (int i = 0; i < arena_.bodies(); ++i) {
      if (!members[i]) continue;
      Body moving = bodies[i];
      moving.twist = end_[i].twist;
      end_[i] = along_arc(moving, length);
    }
    for (Contact& c : contacts_.contacts()) look_again(arena_, end_, c);
    if (has_settled()) return true;
  }
  return false;
}

bool ContactStepping::has_settled() const {
  const double touch = arena_.tolerances.step_touch;
  for (const Contact& c : contacts_.contacts()) {
    if (c.at.gap < -touch || (c.impulse > 0.0 && c.at.gap > touch)) return false;
  }
  return true;
}

// The impulses that a step asks for: of contacts, along their tangents, of wheels. Sets the twists of
// end_.
void ContactStepping::solve(const BodySet& members, std::span<const Drive> drives,
                            std::span<const InverseMass> mass, double length, bool again) {
  const Parameters& p = arena_.parameters;
  std::array<const Contact*, max_unknowns> row;
  int count = 0;
  for (const Contact& c : contacts_.contacts()) row[count++] = &c;
  const int normals = count;
  tangents_.count = 0;
  for (const Contact& c : contacts_.contacts()) {
    if (c.friction == 0.0 || count == max_unknowns - max_bodies) continue;
    tangents_.list[tangents_.count] = tangent_of(c, end_);
    row[count++] = &tangents_.list[tangents_.count++];
  }
  const int with_tangents = count;
  for (int i = 0; i < arena_.robots; ++i) {
    const bool holds = members[i] && drives[i].wheels_on_ground && p.grip != infinite_grip;
    if (holds && count < max_unknowns) row[count++] = &wheels_[i];
  }

  problem_.reset(count);
  for (int i = 0; i < count; ++i) {
    problem_.b[i] = gap_rate(*row[i], alone_);
    // The gap at the end of the step, from what it is with the twists of the last look.
    if (i < normals) problem_.b[i] += row[i]->at.gap / length - gap_rate(*row[i], end_);
  }
  set_couplings(
      count, [&](int i) -> const Contact& { return *row[i]; }, mass, problem_);
  const auto set_bounds = [&](int i, double bound) {
    problem_.low[i] = -bound;
    problem_.high[i] = bound;
  };
  const double grip_impulse = p.grip * p.robot_mass * gravity * length;
  for (int i = with_tangents; i < count; ++i) set_bounds(i, grip_impulse);
  for (int i = normals; i < with_tangents; ++i) set_bounds(i, 0.0);
  if (!problem_.solve_softly(again)) problem_.solve();
  for (int round = 0; round < friction_rounds && with_tangents > normals; ++round) {
    for (int i = normals, k = 0; i < with_tangents; ++i, ++k) {
      while (contacts_.list[k].friction == 0.0) ++k;
      set_bounds(i, contacts_.list[k].friction * problem_.x[k]);
    }
    problem_.solve_softly(true);
  }

  for (int i = 0; i < arena_.bodies(); ++i) {
    if (members[i]) end_[i].twist = alone_[i].twist;
  }
  for (int i = 0; i < count; ++i) apply_impulse(*row[i], problem_.x[i], mass, end_);
  for (int i = 0; i < normals; ++i) contacts_.list[i].impulse = problem_.x[i];
  for (int i = with_tangents; i < count; ++i) {
    double& left = end_[row[i]->a].twist.left;
    if (std::abs(problem_.x[i]) < grip_impulse) left = 0.0;
  }
}

}  // namespace mirocup::simulator
