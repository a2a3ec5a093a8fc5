// SPDX-License-Identifier: MIT
#include "core/simulator/collision/contact_constraint.hpp"

namespace mirocup::simulator::collision {

solver::InverseMass free_robot_mass(const Parameters& p) {
  return {1.0 / p.robot_mass, 1.0 / p.robot_mass, 1.0 / p.robot_inertia()};
}

solver::InverseMass robot_mass(const Parameters& p, bool wheels_on_ground) {
  solver::InverseMass mass = free_robot_mass(p);
  if (wheels_on_ground && p.grip == infinite_grip) mass.left = 0.0;
  return mass;
}

solver::InverseMass ball_mass(const Parameters& p) {
  const double inverse = 1.0 / p.effective_ball_mass();
  return {inverse, inverse, 0.0};
}

solver::JacobianRow contact_row(const BodyState& body, const ContactPoint& contact) {
  const Vec2 n = body.heading.to_body(contact.normal);
  return {n.x(), n.y(), cross(Vec2{contact.point - body.position}, contact.normal)};
}

void set_row(std::span<const BodyState> bodies, Contact& c) {
  const auto part = [&](int body) {
    return body != no_body ? contact_row(bodies[body], c.point) : solver::JacobianRow{};
  };
  c.row = solver::difference_row(c.a, c.b, part(c.a), part(c.b));
}

BodySet bodies_of(std::span<const Contact> contacts) {
  BodySet bodies;
  for (const Contact& c : contacts) bodies |= bodies_of(c.pair);
  return bodies;
}

solver::ConstraintRow lateral_wheel_row(int robot) {
  return {.a = robot, .b = no_body, .on_a = {0.0, 1.0, 0.0}, .on_b = {}};
}

double row_rate(const solver::ConstraintRow& row, std::span<const BodyState> bodies) {
  double rate = solver::along(row.on_a, bodies[row.a].twist);
  if (row.b != no_body) rate += solver::along(row.on_b, bodies[row.b].twist);
  return rate;
}

double inverse_effective_mass(const solver::ConstraintRow& row,
                              std::span<const solver::InverseMass> mass) {
  const auto of_body = [&mass](int body, const solver::JacobianRow& part) {
    const solver::InverseMass& m = mass[body];
    return part[0] * m.forward * part[0] + part[1] * m.left * part[1] + part[2] * m.omega * part[2];
  };
  double sum = of_body(row.a, row.on_a);
  if (row.b != no_body) sum += of_body(row.b, row.on_b);
  return sum;
}

void add_impulse(const solver::JacobianRow& row, double impulse, const solver::InverseMass& mass,
                 Twist& twist) {
  twist.forward += impulse * row[0] * mass.forward;
  twist.left += impulse * row[1] * mass.left;
  twist.omega += impulse * row[2] * mass.omega;
}

void apply_impulse(const solver::ConstraintRow& row, double impulse,
                   std::span<const solver::InverseMass> mass, std::span<BodyState> bodies) {
  add_impulse(row.on_a, impulse, mass[row.a], bodies[row.a].twist);
  if (row.b != no_body) add_impulse(row.on_b, impulse, mass[row.b], bodies[row.b].twist);
}

}  // namespace mirocup::simulator::collision
