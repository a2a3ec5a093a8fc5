// SPDX-License-Identifier: MIT
#include "tests/support/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mirocup::test_support {

namespace {

constexpr double far_out = 4.0;       // m: thickness of walls
constexpr double same_corner = 1e-6;  // m: two corners closer than this count as one

struct Separation {
  double amount = -std::numeric_limits<double>::infinity();
  Vec2 normal{0.0, 0.0};  // of the separating edge, outwards
};

Vec2 next_corner(const Outline& o, std::size_t i) {
  return o.corners[i + 1 == o.corners.size() ? 0 : i + 1];
}

Vec2 outward(const Vec2& start, const Vec2& stop) {
  const Vec2 edge = stop - start;
  return Vec2{edge.y(), -edge.x()} / std::hypot(edge.x(), edge.y());
}

// Returns the edge of `polygon` that separates it best from the corners of `other`.
Separation best_separation(const Outline& polygon, const Outline& other) {
  Separation best;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const Vec2 normal = outward(polygon.corners[i], next_corner(polygon, i));
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec2& corner : other.corners) {
      nearest = std::min(nearest, normal.dot(corner - polygon.corners[i]));
    }
    if (nearest > best.amount) best = {nearest, normal};
  }
  return best;
}

Vec2 nearest_on_edge(const Vec2& start, const Vec2& stop, const Vec2& point) {
  const Vec2 edge = stop - start;
  const double share = std::clamp(edge.dot(point - start) / edge.squaredNorm(), 0.0, 1.0);
  return start + share * edge;
}

// Returns the point of a polygon's border that is nearest to a point.
Vec2 nearest_on_border(const Outline& polygon, const Vec2& point) {
  Vec2 best = polygon.corners[0];
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const Vec2 candidate = nearest_on_edge(polygon.corners[i], next_corner(polygon, i), point);
    if ((candidate - point).norm() < (best - point).norm()) best = candidate;
  }
  return best;
}

// Returns the distance of a point from a polygon, negative inside.
double point_distance(const Outline& polygon, const Vec2& point) {
  const double inside = best_separation(polygon, {{point}, 0.0}).amount;
  return inside <= 0.0 ? inside : (point - nearest_on_border(polygon, point)).norm();
}

Outline box(const Vec2& corner, const Vec2& u, const Vec2& v) {
  const bool counter_clockwise = cross(u, v) > 0.0;
  const Vec2 first = counter_clockwise ? u : v;
  const Vec2 second = counter_clockwise ? v : u;
  return {{corner, corner + first, corner + first + second, corner + second}, 0.0};
}

// Returns a box that covers all beyond the line through `point`; `normal` points to the outside.
Outline beyond(const Vec2& point, const Vec2& normal) {
  const Vec2 along{-normal.y(), normal.x()};
  return box(point - far_out * along, 2.0 * far_out * along, far_out * normal);
}

TouchPoint touch_of_circle(const Outline& circle, const Outline& polygon) {
  const Vec2& centre = circle.corners[0];
  const Separation facing = best_separation(polygon, circle);
  if (facing.amount <= 0.0) {
    return {centre - facing.amount * facing.normal, facing.normal, facing.amount - circle.radius};
  }
  const Vec2 nearest = nearest_on_border(polygon, centre);
  const double away = (centre - nearest).norm();
  return {nearest, (centre - nearest) / away, away - circle.radius};
}

}  // namespace

Outline square_at(const Vec2& centre, double angle, double side) {
  const Vec2 u = 0.5 * side * Vec2{std::cos(angle), std::sin(angle)};
  const Vec2 v{-u.y(), u.x()};
  return {{centre + u - v, centre + u + v, centre - u + v, centre - u - v}, 0.0};
}

Outline circle_at(const Vec2& centre, double radius) {
  return {{centre}, radius};
}

std::vector<Outline> solids_around(const field::Field& f) {
  const double x = f.half_length;
  const double y = f.half_width;
  std::vector<Outline> solids;
  for (const double sign : {-1.0, 1.0}) {
    solids.push_back(beyond({0.0, sign * y}, {0.0, sign}));
    solids.push_back(beyond({sign * (x + f.goal_depth), 0.0}, {sign, 0.0}));
    for (const double up : {-1.0, 1.0}) {
      const Vec2 diagonal{sign * std::sqrt(0.5), up * std::sqrt(0.5)};
      solids.push_back(beyond({sign * (x - f.corner_leg), up * y}, diagonal));
      solids.push_back(
          box({sign * x, up * f.goal_half_width}, {sign * far_out, 0.0}, {0.0, up * far_out}));
    }
  }
  return solids;
}

double distance(const Outline& a, const Outline& b) {
  if (b.radius > 0.0) return distance(b, a);
  if (a.radius > 0.0) return point_distance(b, a.corners[0]) - a.radius;
  const double apart = std::max(best_separation(a, b).amount, best_separation(b, a).amount);
  if (apart <= 0.0) return apart;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec2& corner : a.corners) nearest = std::min(nearest, point_distance(b, corner));
  for (const Vec2& corner : b.corners) nearest = std::min(nearest, point_distance(a, corner));
  return nearest;
}

std::vector<TouchPoint> touch_points(const Outline& a, const Outline& b, double margin) {
  if (a.radius > 0.0) {
    const TouchPoint touch = touch_of_circle(a, b);
    return touch.gap <= margin ? std::vector{touch} : std::vector<TouchPoint>{};
  }
  if (b.radius > 0.0) {
    TouchPoint touch = touch_of_circle(b, a);
    touch.normal = -touch.normal;
    return touch.gap <= margin ? std::vector{touch} : std::vector<TouchPoint>{};
  }
  const Separation by_a = best_separation(a, b);
  const Separation by_b = best_separation(b, a);
  if (std::max(by_a.amount, by_b.amount) > margin) return {};
  const Vec2 normal = by_a.amount > by_b.amount ? Vec2{-by_a.normal} : by_b.normal;

  std::vector<TouchPoint> found;
  const auto add_corners = [&](const Outline& with_corner, const Outline& other) {
    for (const Vec2& corner : with_corner.corners) {
      const double gap = point_distance(other, corner);
      const bool is_new = std::none_of(found.begin(), found.end(), [&](const TouchPoint& t) {
        return (t.point - corner).norm() < same_corner;
      });
      if (gap <= margin && is_new) found.push_back({corner, normal, gap});
    }
  };
  add_corners(a, b);
  add_corners(b, a);
  return found;
}

}  // namespace mirocup::test_support
