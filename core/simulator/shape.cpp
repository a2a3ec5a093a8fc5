// SPDX-License-Identifier: MIT
#include "core/simulator/shape.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::simulator {

Shape circle(double radius) {
  Shape shape;
  shape.radius = radius;
  return shape;
}

Shape polygon(std::span<const Vec2> corners) {
  Shape shape;
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

Shape square(double side) {
  const double h = side / 2.0;
  const std::array<Vec2, 4> corners{Vec2{h, -h}, Vec2{h, h}, Vec2{-h, h}, Vec2{-h, -h}};
  return polygon(corners);
}

Shape robot_shape(const Parameters& p) {
  if (p.robot_outline.corners == 0) return square(p.robot_side);
  std::array<Vec2, max_corners> corners;
  for (int i = 0; i < p.robot_outline.corners; ++i) corners[i] = p.robot_outline.corner(i);
  return polygon({corners.data(), static_cast<std::size_t>(p.robot_outline.corners)});
}

Shape end_wall(const field::GoalPost& post) {
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

}  // namespace mirocup::simulator
