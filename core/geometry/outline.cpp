// SPDX-License-Identifier: MIT
#include "core/geometry/outline.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::geometry {

Outline circle(double radius) {
  Outline shape;
  shape.radius = radius;
  return shape;
}

Outline polygon(std::span<const Vec2> corners) {
  MIROCUP_ASSERT(corners.size() >= 3 && corners.size() <= max_corners);
  Outline shape;
  shape.corners = static_cast<int>(corners.size());
  for (int i = 0; i < shape.corners; ++i) {
    shape.corner[i] = corners[i];
    shape.radius = std::max(shape.radius, std::sqrt(corners[i].squaredNorm()));
    const Vec2 edge = corners[shape.next(i)] - corners[i];
    const double length = std::sqrt(edge.squaredNorm());
    shape.normal[i] = Vec2{edge.y(), -edge.x()} / length;
    shape.offset[i] = shape.normal[i].dot(corners[i]);
  }
  const double nearest =
      *std::min_element(shape.offset.begin(), shape.offset.begin() + shape.corners);
  if (nearest > 0.0) shape.inner_radius = nearest;
  return shape;
}

Outline square(double side) {
  const double h = side / 2.0;
  const std::array<Vec2, 4> corners{Vec2{h, -h}, Vec2{h, h}, Vec2{-h, h}, Vec2{-h, -h}};
  return polygon(corners);
}

Outline end_wall(const field::GoalPost& post) {
  constexpr double reach = 10.0;  // m, larger than any field
  const Vec2 out = -reach * post.face;
  const Vec2 along = -reach * post.side;
  const bool counter_clockwise = cross(out, along) > 0.0;
  const Vec2 first = counter_clockwise ? out : along;
  const Vec2 second = counter_clockwise ? along : out;
  const std::array<Vec2, 4> corners{post.post, post.post + first, post.post + first + second,
                                    post.post + second};
  return polygon(corners);
}

}  // namespace mirocup::geometry
