// SPDX-License-Identifier: MIT
#include "core/simulator/contact_rows.hpp"

namespace mirocup::simulator {

namespace {

// A point or direction of which only term k is known.
using Term = Vec2;

// Term k of a constant.
Term constant_term(const Vec2& v, int k) {
  return k == 0 ? v : Vec2{0.0, 0.0};
}

void set_row(std::array<Series, 3>& row, int k, const Term& normal, double turn) {
  row[0][k] = normal.x();
  row[1][k] = normal.y();
  row[2][k] = turn;
}

// The outline of an obstacle that has corners, or null for a plane wall.
const Shape* end_wall_of(const Arena& arena, const Pair& pair) {
  return pair.obstacle() < plane_walls ? nullptr
                                       : &arena.end_wall_shapes[pair.obstacle() - plane_walls];
}

// Term k of the point's position along the edge, from both its ends.
void set_inside_edge(const Shape& shape, int edge, const Term& point, int k, ContactRows& rows) {
  const Vec2& start = shape.corner[edge];
  const Vec2& stop = shape.corner[shape.next(edge)];
  const Vec2 along{-shape.normal[edge].y(), shape.normal[edge].x()};
  rows.inside[0][k] = along.dot(point) - (k == 0 ? along.dot(start) : 0.0);
  rows.inside[1][k] = (k == 0 ? along.dot(stop) : 0.0) - along.dot(point);
}

// Term k of how far the direction away from a corner is from the normals of the edges that meet
// there.
void set_inside_corner(const Shape& shape, int corner, const Term& direction, int k,
                       ContactRows& rows) {
  const int before = corner == 0 ? shape.corners - 1 : corner - 1;
  rows.inside[0][k] = cross(shape.normal[before], direction);
  rows.inside[1][k] = cross(direction, shape.normal[corner]);
}

// Term k of the pose of `a` in the frame of `b`. Without `a`, of the fixed point instead.
void extend_relative(const Segment* a, const Segment& b, const Vec2& fixed, int k,
                     ContactRows& rows) {
  const Term place = a != nullptr ? Term{a->x[k], a->y[k]} : constant_term(fixed, k);
  rows.dx[k] = place.x() - b.x[k];
  rows.dy[k] = place.y() - b.y[k];
  rows.x[k] = product_term(b.cos, rows.dx, k) + product_term(b.sin, rows.dy, k);
  rows.y[k] = product_term(b.cos, rows.dy, k) - product_term(b.sin, rows.dx, k);
}

void extend_relative_heading(const Segment& a, const Segment& b, int k, ContactRows& rows) {
  rows.cos[k] = product_term(b.cos, a.cos, k) + product_term(b.sin, a.sin, k);
  rows.sin[k] = product_term(b.cos, a.sin, k) - product_term(b.sin, a.cos, k);
}

void corner_on_robot(const Arena& arena, const Contact& c, const Segment* a, const Segment& b,
                     int k, ContactRows& rows) {
  const Shape& shape = arena.shape(c.b);
  const Vec2& n = shape.normal[c.at.edge];
  extend_relative(a, b, c.at.point, k, rows);
  Term point{rows.x[k], rows.y[k]};
  if (a != nullptr) {
    extend_relative_heading(*a, b, k, rows);
    const Vec2& r = arena.shape(c.a).corner[c.at.corner];
    point +=
        Term{rows.cos[k] * r.x() - rows.sin[k] * r.y(), rows.sin[k] * r.x() + rows.cos[k] * r.y()};
    const Term seen_from_a{rows.cos[k] * n.x() + rows.sin[k] * n.y(),
                           rows.cos[k] * n.y() - rows.sin[k] * n.x()};
    set_row(rows.row_a, k, seen_from_a, cross(r, seen_from_a));
  }
  set_row(rows.row_b, k, constant_term(n, k), cross(point, n));
  set_inside_edge(shape, c.at.edge, point, k, rows);
}

void corner_on_wall(const Arena& arena, const Contact& c, const Segment& a, int k,
                    ContactRows& rows) {
  const Vec2& n = c.at.normal;
  const Vec2& r = arena.shape(c.a).corner[c.at.corner];
  const Term seen_from_a{a.cos[k] * n.x() + a.sin[k] * n.y(), a.cos[k] * n.y() - a.sin[k] * n.x()};
  set_row(rows.row_a, k, seen_from_a, cross(r, seen_from_a));
  if (const Shape* wall = end_wall_of(arena, c.pair)) {
    const Term point{a.x[k] + a.cos[k] * r.x() - a.sin[k] * r.y(),
                     a.y[k] + a.sin[k] * r.x() + a.cos[k] * r.y()};
    set_inside_edge(*wall, c.at.edge, point, k, rows);
  }
}

void ball_on_robot(const Arena& arena, const Contact& c, const Segment& ball, const Segment& b,
                   int k, ContactRows& rows) {
  const Shape& shape = arena.shape(c.b);
  extend_relative(&ball, b, Vec2{0.0, 0.0}, k, rows);
  const Term centre{rows.x[k], rows.y[k]};
  if (c.at.kind == Touching::circle_on_edge) {
    const Vec2& n = shape.normal[c.at.edge];
    set_row(rows.row_a, k,
            {b.cos[k] * n.x() - b.sin[k] * n.y(), b.sin[k] * n.x() + b.cos[k] * n.y()}, 0.0);
    set_row(rows.row_b, k, constant_term(n, k), cross(centre, n));
    set_inside_edge(shape, c.at.edge, centre, k, rows);
    return;
  }
  const Vec2& r = shape.corner[c.at.corner];
  const double radius = arena.ball_shape.radius;
  const Term n = (centre - constant_term(r, k)) / radius;
  const Term corner{b.cos[k] * r.x() - b.sin[k] * r.y(), b.sin[k] * r.x() + b.cos[k] * r.y()};
  set_row(rows.row_a, k, (Term{rows.dx[k], rows.dy[k]} - corner) / radius, 0.0);
  set_row(rows.row_b, k, n, cross(r, n));
  set_inside_corner(shape, c.at.corner, n, k, rows);
}

void ball_on_wall(const Arena& arena, const Contact& c, const Segment& ball, int k,
                  ContactRows& rows) {
  const Shape* wall = end_wall_of(arena, c.pair);
  const Term centre{ball.x[k], ball.y[k]};
  if (c.at.kind == Touching::circle_on_edge) {
    set_row(rows.row_a, k, constant_term(c.at.normal, k), 0.0);
    if (wall != nullptr) set_inside_edge(*wall, c.at.edge, centre, k, rows);
    return;
  }
  const Vec2& post = wall->corner[c.at.corner];
  const Term n = (centre - constant_term(post, k)) / arena.ball_shape.radius;
  set_row(rows.row_a, k, n, 0.0);
  set_inside_corner(*wall, c.at.corner, n, k, rows);
}

}  // namespace

void extend_rows(const Arena& arena, const Contact& c, std::span<const Segment> segments, int k,
                 ContactRows& rows) {
  if (k == 0) rows.inside = {Series::constant(1.0), Series::constant(1.0)};
  const Segment* a = c.a == no_body ? nullptr : &segments[c.a];
  if (c.at.kind == Touching::corner_on_edge) {
    if (c.b != no_body) {
      corner_on_robot(arena, c, a, segments[c.b], k, rows);
    } else {
      corner_on_wall(arena, c, *a, k, rows);
    }
  } else if (c.b != no_body) {
    ball_on_robot(arena, c, *a, segments[c.b], k, rows);
  } else {
    ball_on_wall(arena, c, *a, k, rows);
  }
}

double gap_rate_term(const Contact& c, const ContactRows& rows, std::span<const Segment> segments,
                     int k) {
  const auto along = [k](const std::array<Series, 3>& row, const Segment& s) {
    return product_term(row[0], s.forward, k) + product_term(row[1], s.left, k) +
           product_term(row[2], s.turn, k);
  };
  double rate = 0.0;
  if (c.a != no_body) rate += along(rows.row_a, segments[c.a]);
  if (c.b != no_body) rate -= along(rows.row_b, segments[c.b]);
  return rate;
}

}  // namespace mirocup::simulator
