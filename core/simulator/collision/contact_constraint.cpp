// SPDX-License-Identifier: MIT
#include "core/simulator/collision/contact_constraint.hpp"

namespace mirocup::simulator {

InverseMass free_robot_mass(const Parameters& p) {
  return {1.0 / p.robot_mass, 1.0 / p.robot_mass, 1.0 / p.robot_inertia()};
}

InverseMass robot_mass(const Parameters& p, bool wheels_on_ground) {
  InverseMass mass = free_robot_mass(p);
  if (wheels_on_ground && p.grip == infinite_grip) mass.left = 0.0;
  return mass;
}

InverseMass ball_mass(const Parameters& p) {
  const double inverse = 1.0 / p.effective_ball_mass();
  return {inverse, inverse, 0.0};
}

JacobianRow contact_row(const BodyState& body, const ContactPoint& contact) {
  const Vec2 n = body.heading.to_body(contact.normal);
  return {n.x(), n.y(), cross(Vec2{contact.point - body.position}, contact.normal)};
}

void set_rows(std::span<const BodyState> bodies, Contact& c) {
  if (c.a != no_body) c.row_a = contact_row(bodies[c.a], c.at);
  if (c.b != no_body) c.row_b = contact_row(bodies[c.b], c.at);
}

BodySet bodies_of(std::span<const Contact> contacts) {
  BodySet bodies;
  for (const Contact& c : contacts) bodies |= bodies_of(c.pair);
  return bodies;
}

CoupledRow row_of(const Contact& c) {
  const JacobianRow on_b{-c.row_b[0], -c.row_b[1], -c.row_b[2]};
  if (c.a == no_body) return {.a = c.b, .b = no_body, .on_a = on_b, .on_b = {}};
  return {.a = c.a, .b = c.b, .on_a = c.row_a, .on_b = on_b};
}

Contact wheels_as_contact(int body) {
  Contact c;
  c.a = body;
  c.row_a = {0.0, 1.0, 0.0};
  return c;
}

double gap_rate(const Contact& c, std::span<const BodyState> bodies) {
  double rate = 0.0;
  if (c.a != no_body) rate += along(c.row_a, bodies[c.a].twist);
  if (c.b != no_body) rate -= along(c.row_b, bodies[c.b].twist);
  return rate;
}

double give(const Contact& c, std::span<const InverseMass> mass) {
  const auto of_body = [&mass](int body, const JacobianRow& row) {
    const InverseMass& m = mass[body];
    return row[0] * m.forward * row[0] + row[1] * m.left * row[1] + row[2] * m.turn * row[2];
  };
  double sum = 0.0;
  if (c.a != no_body) sum += of_body(c.a, c.row_a);
  if (c.b != no_body) sum += of_body(c.b, c.row_b);
  return sum;
}

void add_impulse(const JacobianRow& row, double impulse, const InverseMass& mass, Twist& twist) {
  twist.forward += impulse * row[0] * mass.forward;
  twist.left += impulse * row[1] * mass.left;
  twist.turn += impulse * row[2] * mass.turn;
}

void apply_impulse(const Contact& c, double impulse, std::span<const InverseMass> mass,
                   std::span<BodyState> bodies) {
  if (c.a != no_body) add_impulse(c.row_a, impulse, mass[c.a], bodies[c.a].twist);
  if (c.b != no_body) add_impulse(c.row_b, -impulse, mass[c.b], bodies[c.b].twist);
}

}  // namespace mirocup::simulator
