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
  const double speed = std::sqrt(v.forward * v.forward + v.left * v.left);
  if (speed == 0.0) return v;
  const RollingDeceleration d = rolling_deceleration(p);
  const double left = std::max(0.0, 1.0 - step * (d.constant / speed + d.linear));
  return {v.forward * left, v.left * left, 0.0};
}

bool has_finite_grip(const Forces& forces, int body) {
  return body != forces.ball && forces.drives[body].wheels_on_ground &&
         forces.parameters.grip != infinite_grip;
}

// How a sideways impulse at the wheels of `body` acts on a contact.
double wheel_coupling(const Contact& c, int body, const InverseMass& mass) {
  double sum = 0.0;
  if (c.a == body) sum += c.row_a[1] * mass.left;
  if (c.b == body) sum -= c.row_b[1] * mass.left;
  return sum;
}

}  // namespace

void step_in_contact(const Forces& forces, std::span<const int> members,
                     std::span<Contact> contacts, double step, std::span<const InverseMass> mass,
                     std::span<Body> bodies, BoxProblem& problem) {
  const Parameters& p = forces.parameters;
  std::array<int, max_bodies> wheels;  // members whose wheels hold up to their grip
  int wheel_count = 0;
  for (const int i : members) {
    Twist& v = bodies[i].twist;
    v = i == forces.ball ? braked(p, v, step) : driven(p, forces.drives[i], v, step);
    if (has_finite_grip(forces, i)) wheels[wheel_count++] = i;
  }

  const int n = static_cast<int>(contacts.size());
  problem.reset(n + wheel_count);
  for (int i = 0; i < n; ++i) {
    problem.b[i] = gap_rate(contacts[i], bodies) + std::max(contacts[i].at.gap, 0.0) / step;
    for (int j = 0; j <= i; ++j) {
      problem.a(i, j) = coupling(contacts[i], contacts[j], mass);
      problem.a(j, i) = problem.a(i, j);
    }
  }
  const double grip_impulse = p.grip * p.robot_mass * gravity * step;
  for (int k = 0; k < wheel_count; ++k) {
    const int row = n + k;
    const int body = wheels[k];
    problem.b[row] = bodies[body].twist.left;
    problem.low[row] = -grip_impulse;
    problem.high[row] = grip_impulse;
    problem.a(row, row) = mass[body].left;
    for (int i = 0; i < n; ++i) {
      problem.a(row, i) = wheel_coupling(contacts[i], body, mass[body]);
      problem.a(i, row) = problem.a(row, i);
    }
  }
  problem.solve();

  for (int i = 0; i < n; ++i) {
    contacts[i].impulse = problem.x[i];
    apply_impulse(contacts[i], problem.x[i], mass, bodies);
  }
  for (int k = 0; k < wheel_count; ++k) {
    double& left = bodies[wheels[k]].twist.left;
    left += problem.x[n + k] * mass[wheels[k]].left;
    if (std::abs(left) < no_sliding) left = 0.0;
  }
}

void push_apart(std::span<const Contact> contacts, std::span<const InverseMass> free_mass,
                std::span<Body> bodies, BoxProblem& problem) {
  const int n = static_cast<int>(contacts.size());
  problem.reset(n);
  for (int i = 0; i < n; ++i) {
    problem.b[i] = contacts[i].at.gap;
    for (int j = 0; j <= i; ++j) {
      problem.a(i, j) = coupling(contacts[i], contacts[j], free_mass);
      problem.a(j, i) = problem.a(i, j);
    }
  }
  problem.solve();

  const auto move = [&](int i, const JacobianRow& row, double amount) {
    Body& body = bodies[i];
    const InverseMass& m = free_mass[i];
    body.position += body.heading.to_world({amount * row[0] * m.forward, amount * row[1] * m.left});
    body.heading = body.heading.turned(sincos(amount * row[2] * m.turn));
  };
  for (int i = 0; i < n; ++i) {
    const double amount = problem.x[i];
    if (amount == 0.0) continue;
    if (contacts[i].a != no_body) move(contacts[i].a, contacts[i].row_a, amount);
    if (contacts[i].b != no_body) move(contacts[i].b, contacts[i].row_b, -amount);
  }
}

}  // namespace mirocup::simulator
