// SPDX-License-Identifier: MIT
#include "core/simulator/model/parameters.hpp"

namespace mirocup::simulator::inline model {

double Parameters::robot_inertia() const {
  if (robot_corners.corners == 0) return robot_mass * robot_side * robot_side / 6.0;
  // Triangles from the centre to each edge.
  double area = 0.0;    // times 2
  double second = 0.0;  // moment of area, times 12
  for (int i = 0; i < robot_corners.corners; ++i) {
    const Vec2 a = robot_corners.corner(i);
    const Vec2 b = robot_corners.corner((i + 1) % robot_corners.corners);
    const double triangle = cross(a, b);
    area += triangle;
    second += triangle * (a.squaredNorm() + a.dot(b) + b.squaredNorm());
  }
  return robot_mass * second / (6.0 * area);
}

geometry::Outline robot_outline(const Parameters& p) {
  if (p.robot_corners.corners == 0) return geometry::square(p.robot_side);
  std::array<Vec2, geometry::max_corners> corners;
  for (int i = 0; i < p.robot_corners.corners; ++i) corners[i] = p.robot_corners.corner(i);
  return geometry::polygon({corners.data(), static_cast<std::size_t>(p.robot_corners.corners)});
}

}  // namespace mirocup::simulator::inline model
