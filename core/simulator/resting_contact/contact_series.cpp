// SPDX-License-Identifier: MIT
#include "core/simulator/resting_contact/contact_series.hpp"

#include "core/base/assert.hpp"
#include "core/simulator/model/solver_settings.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator::resting_contact {

namespace {

// Returns the outline of the side with the edge or corner, or null for a plane wall.
const geometry::Outline* pressed_shape(const collision::StaticWorld& world,
                                       const collision::Contact& c) {
  return c.b != no_body ? &world.shape(c.b) : end_wall_outline(world, c.pair);
}

Vec2 along_edge(const Vec2& normal) {
  return {-normal.y(), normal.x()};
}

Heading first_heading(const trajectory::Segment& s) {
  return {s.cos[0], s.sin[0]};
}

void start_on_edge(const collision::StaticWorld& world, const collision::Contact& c,
                   ContactSeries& rows) {
  const trajectory::Segment *a = rows.a, *b = rows.b;
  const bool is_ball = c.point.kind == collision::Touching::circle_on_edge;
  const Heading heading_a = a == nullptr || is_ball ? Heading{} : first_heading(*a);
  const Heading heading_b = b == nullptr ? Heading{} : first_heading(*b);
  const geometry::Outline* shape = pressed_shape(world, c);

  rows.point = a == nullptr || is_ball ? Vec2{0.0, 0.0} : world.shape(c.a).corner[c.point.corner];
  rows.normal = b == nullptr ? c.point.normal : shape->normal[c.point.edge];
  const Vec2 along = along_edge(rows.normal);
  rows.push = rows.normal + c.resting.friction * along;
  rows.edge_begin = shape == nullptr ? -infinity : along.dot(shape->corner[c.point.edge]);
  rows.edge_end = shape == nullptr ? infinity : along.dot(shape->corner[shape->next(c.point.edge)]);

  const Vec2 place =
      a == nullptr ? c.point.point : Vec2{Vec2{a->x[0], a->y[0]} + heading_a.to_world(rows.point)};
  const Vec2 touching = b == nullptr ? place : heading_b.to_body(place - Vec2{b->x[0], b->y[0]});
  rows.distance = rows.normal.dot(touching);
  rows.lever_b[0] = cross(touching, rows.normal);

  const Heading heading = heading_a.seen_from(heading_b);
  rows.heading.c[0] = {heading.cos, heading.sin};
  rows.later_velocity = {0.0, 0.0};
  if (a == nullptr) rows.velocity = {};

  const Vec2 seen_from_a = heading.to_body(rows.normal);
  rows.first_a = {seen_from_a.x(), seen_from_a.y(), cross(rows.point, seen_from_a)};
  rows.first_b = {rows.normal.x(), rows.normal.y(), rows.lever_b[0]};
}

void set_point_velocity(const trajectory::Segment& a, int k, ContactSeries& rows) {
  rows.velocity.c[k] = {a.forward[k] - rows.point.y() * a.omega[k],
                        a.left[k] + rows.point.x() * a.omega[k]};
}

// Returns term k of the point's velocity in the frame of the edge's side.
Vec2 point_velocity(const ContactSeries& rows, int k) {
  const Heading heading{rows.heading.c[0][0], rows.heading.c[0][1]};
  return rows.later_velocity + heading.to_world({rows.velocity.c[k][0], rows.velocity.c[k][1]});
}

void extend_on_edge(int k, ContactSeries& rows) {
  rows.omega[k] = 0.0;
  if (rows.a != nullptr) {
    set_point_velocity(*rows.a, k, rows);
    rows.omega[k] += rows.a->omega[k];
  }
  if (rows.b != nullptr) rows.omega[k] -= rows.b->omega[k];
  const double next = k + 1;
  rows.lever_b[k + 1] = -slide_term(rows, k) / next;

  // All products with terms of the heading, in one loop: each sum has increasing j.
  const auto& heading = rows.heading.c;
  Vec2 turning{heading[0][0] * rows.omega[k], heading[0][1] * rows.omega[k]};
  Vec2 velocity, force;
  double lever = 0.0;
  const auto add_velocity = [&](int j) {
    const auto& v = rows.velocity.c[k + 1 - j];
    velocity += Vec2{heading[j][0] * v[0] - heading[j][1] * v[1],
                     heading[j][1] * v[0] + heading[j][0] * v[1]};
  };
  for (int j = 1; j <= k; ++j) {
    const double force_term = rows.force[k - j];
    turning += rows.omega[k - j] * Vec2{heading[j][0], heading[j][1]};
    force += force_term * Vec2{heading[j][0], heading[j][1]};
    lever += rows.lever_b[j] * force_term;
    add_velocity(j);
  }
  rows.heading.c[k + 1] = {-turning.y() / next, turning.x() / next};
  add_velocity(k + 1);
  rows.later_velocity = velocity;
  rows.later_force = force;
  rows.later_lever_b = lever;
}

double gap_rate_on_edge(int k, ContactSeries& rows) {
  double rate = 0.0;
  if (rows.a != nullptr) {
    set_point_velocity(*rows.a, k, rows);
    rate = rows.normal.dot(point_velocity(rows, k));
  }
  if (rows.b != nullptr) {
    const trajectory::Segment& b = *rows.b;
    rate -= rows.normal.x() * b.forward[k] + rows.normal.y() * b.left[k] +
            product_term(rows.lever_b, b.omega, k);
  }
  return rate;
}

// Sets terms k where the ball presses on a corner of a robot or of the outline behind a goal post.
void set_on_corner(const collision::StaticWorld& world, const collision::Contact& c, int k,
                   ContactSeries& rows) {
  const geometry::Outline& shape = *pressed_shape(world, c);
  const double radius = world.ball_outline.radius;
  const trajectory::Segment& ball = *rows.a;
  const Vec2 corner = shape.corner[c.point.corner];
  Vec2 from_corner;  // to the ball, in the field's frame
  Vec2 seen;         // the same, in the frame of the corner's side
  if (rows.b == nullptr) {
    from_corner = Vec2{ball.x[k], ball.y[k]};
    if (k == 0) from_corner -= corner;
    seen = from_corner;
  } else {
    const trajectory::Segment& b = *rows.b;
    rows.dx[k] = ball.x[k] - b.x[k];
    rows.dy[k] = ball.y[k] - b.y[k];
    rows.x[k] = product_term(b.cos, rows.dx, k) + product_term(b.sin, rows.dy, k);
    rows.y[k] = product_term(b.cos, rows.dy, k) - product_term(b.sin, rows.dx, k);
    from_corner =
        Vec2{rows.dx[k], rows.dy[k]} - Vec2{b.cos[k] * corner.x() - b.sin[k] * corner.y(),
                                            b.sin[k] * corner.x() + b.cos[k] * corner.y()};
    seen = Vec2{rows.x[k], rows.y[k]};
    if (k == 0) seen -= corner;
  }
  const Vec2 normal_a = from_corner / radius;
  const Vec2 normal_b = seen / radius;
  rows.row_a[0][k] = normal_a.x();
  rows.row_a[1][k] = normal_a.y();
  rows.row_b[0][k] = normal_b.x();
  rows.row_b[1][k] = normal_b.y();
  rows.row_b[2][k] = cross(corner, normal_b);
  const int before = c.point.corner == 0 ? shape.corners - 1 : c.point.corner - 1;
  rows.inside[0][k] = cross(shape.normal[before], normal_b);
  rows.inside[1][k] = cross(normal_b, shape.normal[c.point.corner]);
}

double gap_rate_on_corner(int k, const ContactSeries& rows) {
  const trajectory::Segment& ball = *rows.a;
  double rate =
      product_term(rows.row_a[0], ball.forward, k) + product_term(rows.row_a[1], ball.left, k);
  if (rows.b == nullptr) return rate;
  const trajectory::Segment& b = *rows.b;
  rate -= product_term(rows.row_b[0], b.forward, k) + product_term(rows.row_b[1], b.left, k) +
          product_term(rows.row_b[2], b.omega, k);
  return rate;
}

bool is_on_corner(const collision::Contact& c) {
  return c.point.kind == collision::Touching::circle_on_corner;
}

}  // namespace

void start_rows(const collision::StaticWorld& world, const collision::Contact& c,
                std::span<const trajectory::Segment> segments, ContactSeries& rows) {
  spoil(rows);
  rows.a = c.a == no_body ? nullptr : &segments[c.a];
  rows.b = c.b == no_body ? nullptr : &segments[c.b];
  if (!is_on_corner(c)) return start_on_edge(world, c, rows);
  set_on_corner(world, c, 0, rows);
  rows.first_a = {rows.row_a[0][0], rows.row_a[1][0], 0.0};
  rows.first_b = {rows.row_b[0][0], rows.row_b[1][0], rows.row_b[2][0]};
}

void extend_rows(const collision::StaticWorld& world, const collision::Contact& c, int k,
                 ContactSeries& rows) {
  if (is_on_corner(c)) {
    set_on_corner(world, c, k + 1, rows);
  } else {
    extend_on_edge(k, rows);
  }
}

double gap_rate_term(const collision::Contact& c, int k, ContactSeries& rows) {
  return is_on_corner(c) ? gap_rate_on_corner(k, rows) : gap_rate_on_edge(k, rows);
}

double slide_term(const ContactSeries& rows, int k) {
  const Vec2 along = along_edge(rows.normal);
  double speed = rows.a != nullptr ? along.dot(point_velocity(rows, k)) : 0.0;
  if (rows.b != nullptr) {
    const trajectory::Segment& b = *rows.b;
    speed -= along.x() * b.forward[k] + along.y() * b.left[k] + rows.distance * b.omega[k];
  }
  return speed;
}

solver::ConstraintRow first_push(const collision::Contact& c, const ContactSeries& rows) {
  if (c.resting.friction == 0.0) return c.row;
  const Vec2 on_a = Heading{rows.heading.c[0][0], rows.heading.c[0][1]}.to_body(rows.push);
  return solver::difference_row(
      c.a, c.b, {on_a.x(), on_a.y(), cross(rows.point, on_a)},
      {rows.push.x(), rows.push.y(), rows.lever_b[0] + c.resting.friction * rows.distance});
}

RowTerms later_force_term(const collision::Contact& c, const ContactSeries& rows, int k) {
  if (is_on_corner(c)) {
    const auto term = [&](const trajectory::Series& row) {
      return product_term(row, rows.force, k, 1);
    };
    return {{term(rows.row_a[0]), term(rows.row_a[1]), 0.0},
            {term(rows.row_b[0]), term(rows.row_b[1]), term(rows.row_b[2])}};
  }
  const Vec2 on_a = Heading{rows.later_force.x(), rows.later_force.y()}.to_body(rows.push);
  return {{on_a.x(), on_a.y(), cross(rows.point, on_a)}, {0.0, 0.0, rows.later_lever_b}};
}

double time_on_edge(const collision::Contact& c, const ContactSeries& rows, double margin,
                    double length) {
  const auto until = [&](const trajectory::Series& inside, double level) {
    if (inside[0] <=
        level + settings::contact_series.restart_margin * settings::taylor_series.root_tolerance)
      return;
    length = std::min(length, first_crossing(inside, level, 0.0, length));
  };
  if (is_on_corner(c)) {
    until(rows.inside[0], -margin);
    until(rows.inside[1], -margin);
  } else if (rows.edge_end != infinity) {
    until(-1.0 * rows.lever_b, rows.edge_begin - margin);
    until(rows.lever_b, -rows.edge_end - margin);
  }
  return length;
}

// The speed is minus the rate of lever_b, whose last known term is that of index terms - 1.
double time_of_rest(const collision::Contact& c, const ContactSeries& rows, double slow,
                    double length) {
  const double sign = c.resting.friction > 0.0 ? 1.0 : -1.0;  // of -speed
  // A slide that begins has speed zero at the start. Divided by t, that root is left out.
  const int first = std::abs(rows.lever_b[1]) <= slow ? 1 : 0;
  trajectory::Series speed;
  speed.terms = rows.lever_b.terms;
  for (int k = first; k + 1 < speed.terms; ++k)
    speed[k - first] = sign * (k + 1) * rows.lever_b[k + 1];
  return std::min(length, first_crossing(speed, 0.0, 0.0, length));
}

void set_terms(ContactSeries& rows, int terms) {
  rows.force[terms - 1] = 0.0;
  rows.force.terms = rows.lever_b.terms = terms;
  for (trajectory::Series& inside : rows.inside) inside.terms = terms;
}

}  // namespace mirocup::simulator::resting_contact
