// SPDX-License-Identifier: MIT
#include "core/field/coverage.hpp"

#include "core/base/assert.hpp"
#include "core/base/math.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirocup::field {

namespace {

// A convex polygon, counter-clockwise. Four corners, and one more for each line that clips it.
struct Polygon {
  std::array<Vec2, 8> corner;
  int count = 0;

  void add(const Vec2& p) {
    MIROCUP_ASSERT(count < static_cast<int>(corner.size()));
    corner[count++] = p;
  }
  const Vec2& next(int i) const { return corner[i + 1 == count ? 0 : i + 1]; }
};

Polygon outline(const Pose& robot, double side) {
  const double h = side / 2.0;
  Polygon square;
  for (const Vec2& c : {Vec2{h, -h}, Vec2{h, h}, Vec2{-h, h}, Vec2{-h, -h}}) {
    square.add(robot.position + robot.heading.to_world(c));
  }
  return square;
}

// Returns the part of a polygon in the half-plane normal . x <= offset.
Polygon clip(const Polygon& from, const Vec2& normal, double offset) {
  Polygon kept;
  for (int i = 0; i < from.count; ++i) {
    const Vec2& a = from.corner[i];
    const Vec2& b = from.next(i);
    const double out_a = normal.dot(a) - offset;
    const double out_b = normal.dot(b) - offset;
    if (out_a <= 0.0) kept.add(a);
    if ((out_a < 0.0 && out_b > 0.0) || (out_a > 0.0 && out_b < 0.0)) {
      kept.add(a + (out_a / (out_a - out_b)) * (b - a));
    }
  }
  return kept;
}

Polygon clip_to_box(const Polygon& from, double low_x, double high_x, double half_height) {
  Polygon p = clip(from, {-1.0, 0.0}, -low_x);
  p = clip(p, {1.0, 0.0}, high_x);
  p = clip(p, {0.0, 1.0}, half_height);
  return clip(p, {0.0, -1.0}, half_height);
}

double size_of(const Polygon& p) {
  double twice = 0.0;
  for (int i = 0; i < p.count; ++i) twice += cross(p.corner[i], p.next(i));
  return twice / 2.0;
}

// Returns the size of the common part of a disc around the origin and the triangle (origin, a, b),
// with the sign of a x b.
double disc_under_edge(const Vec2& a, const Vec2& b, double radius) {
  const auto sector = [radius](const Vec2& from, const Vec2& to) {
    return radius * radius / 2.0 * atan2(cross(from, to), from.dot(to));
  };
  const Vec2 d = b - a;
  const double dd = d.squaredNorm();
  const double ad = a.dot(d);
  const double root = ad * ad - dd * (a.squaredNorm() - radius * radius);
  if (root <= 0.0 || dd == 0.0) return sector(a, b);
  const double enters = (-ad - std::sqrt(root)) / dd;
  const double leaves = (-ad + std::sqrt(root)) / dd;
  if (leaves <= 0.0 || enters >= 1.0) return sector(a, b);
  const Vec2 p = enters > 0.0 ? Vec2(a + enters * d) : a;
  const Vec2 q = leaves < 1.0 ? Vec2(a + leaves * d) : b;
  double size = cross(p, q) / 2.0;
  if (enters > 0.0) size += sector(a, p);
  if (leaves < 1.0) size += sector(q, b);
  return size;
}

double size_in_disc(const Polygon& p, const Vec2& centre, double radius) {
  double size = 0.0;
  for (int i = 0; i < p.count; ++i) {
    size += disc_under_edge(p.corner[i] - centre, p.next(i) - centre, radius);
  }
  return size;
}

}  // namespace

double covered_part(const Field& field, const Area& area, End end, const Pose& robot, double side) {
  // Computed for the right end.
  const Pose seen = team_frame(opposite(end), robot);
  const double reach = side * std::sqrt(0.5);
  const double x = seen.position.x();
  const double y = std::abs(seen.position.y());
  const double front = field.half_length - area.depth;
  const double foremost =
      area.arc_radius > 0.0 ? std::min(front, area.arc_centre - area.arc_radius) : front;
  if (x + reach <= foremost || y - reach >= area.half_width) return 0.0;
  if (x - reach >= front && x + reach <= field.half_length && y + reach <= area.half_width) {
    return 1.0;
  }

  const Polygon body = outline(seen, side);
  double size = size_of(clip_to_box(body, front, field.half_length, area.half_width));
  if (x + reach > field.half_length) {
    size += size_of(clip_to_box(body, field.half_length, field.half_length + field.goal_depth,
                                field.goal_half_width));
  }
  if (area.arc_radius > 0.0 && x - reach < front) {
    size += size_in_disc(clip(body, {1.0, 0.0}, front), {area.arc_centre, 0.0}, area.arc_radius);
  }
  return size / (side * side);
}

}  // namespace mirocup::field
