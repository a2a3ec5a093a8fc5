// SPDX-License-Identifier: MIT
#include "core/simulator/contact_stepping.hpp"

#include "core/simulator/ball_motion.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator {

namespace {

// The twist after a step without any contact and without the ground's sideways force.
Twist driven(const Parameters& p, const Drive& drive, const Twist& v, double step) {
  Twist next;
  next.forward = v.forward + step * v.turn * v.left;
  next.left = v.left - step * v.turn * v.forward;
  next.turn = v.turn;
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

bool has_finite_grip(const Forces& forces, int body) {
  return body != forces.ball && forces.drives[body].wheels_on_ground &&
         forces.parameters.grip != infinite_grip;
}

// Rounds in which the bounds of friction follow the normal impulses.
constexpr int friction_rounds = 10;

// The impulses that a step asks for: of contacts, along their tangents, of wheels.
struct StepRows {
  std::array<Contact, max_unknowns> list;
  int count = 0;

  bool full() const { return count == max_unknowns; }
  void add(const Contact& c) { list[count++] = c; }
};

void set_bounds(BoxProblem& problem, int i, double bound) {
  problem.low[i] = -bound;
  problem.high[i] = bound;
}

}  // namespace

double speed_at_most(const Arena& arena, int body, const Body& state) {
  const Twist& v = state.twist;
  return std::abs(v.forward) + std::abs(v.left) + std::abs(v.turn) * arena.shape(body).radius;
}

double overlap_by_turning(const Arena& arena, std::span<const Contact> contacts,
                          std::span<const Body> bodies, double step) {
  double most = 0.0;
  for (const Contact& c : contacts) {
    double turn = 0.0;
    double speed = 0.0;
    for (const int body : {c.a, c.b}) {
      if (body == no_body) continue;
      turn += std::abs(bodies[body].twist.turn);
      speed += speed_at_most(arena, body, bodies[body]);
    }
    most = std::max(most, turn * speed * step * step);
  }
  return most;
}

void step_in_contact(const Forces& forces, std::span<const int> members,
                     std::span<Contact> contacts, double step, std::span<const InverseMass> mass,
                     std::span<Body> bodies, BoxProblem& problem) {
  const Parameters& p = forces.parameters;
  StepRows rows;
  for (const int i : members) {
    Twist& v = bodies[i].twist;
    v = i == forces.ball ? braked(p, v, step) : driven(p, forces.drives[i], v, step);
  }
  for (Contact& c : contacts) rows.add(c);
  const int normals = rows.count;
  for (const Contact& c : contacts) {
    if (c.friction > 0.0 && !rows.full()) rows.add(tangent_of(c, bodies));
  }
  const int with_tangents = rows.count;
  for (const int i : members) {
    if (has_finite_grip(forces, i) && !rows.full()) rows.add(wheels_as_contact(i));
  }

  problem.reset(rows.count);
  for (int i = 0; i < rows.count; ++i) {
    problem.b[i] = gap_rate(rows.list[i], bodies);
    if (i < normals) problem.b[i] += std::max(contacts[i].at.gap, 0.0) / step;
  }
  set_couplings(
      rows.count, [&](int i) -> const Contact& { return rows.list[i]; }, mass, problem);
  const double grip_impulse = p.grip * p.robot_mass * gravity * step;
  for (int i = with_tangents; i < rows.count; ++i) set_bounds(problem, i, grip_impulse);
  for (int i = normals; i < with_tangents; ++i) set_bounds(problem, i, 0.0);
  problem.solve();
  for (int round = 0; round < friction_rounds && with_tangents > normals; ++round) {
    for (int i = normals, k = 0; i < with_tangents; ++i, ++k) {
      while (contacts[k].friction == 0.0) ++k;
      set_bounds(problem, i, contacts[k].friction * problem.x[k]);
    }
    problem.solve();
  }

  for (int i = 0; i < rows.count; ++i) apply_impulse(rows.list[i], problem.x[i], mass, bodies);
  for (int i = 0; i < normals; ++i) contacts[i].impulse = problem.x[i];
  for (const int i : members) {
    if (has_finite_grip(forces, i) && std::abs(bodies[i].twist.left) < no_sliding) {
      bodies[i].twist.left = 0.0;
    }
  }
}

}  // namespace mirocup::simulator
