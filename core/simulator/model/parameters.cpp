// SPDX-License-Identifier: MIT
#include "core/simulator/model/parameters.hpp"

#include "core/base/assert.hpp"

namespace mirocup::simulator {
inline namespace model {

double Parameters::robot_inertia() const {
  if (robot_corners.corners == 0) return robot_mass * robot_side * robot_side / 6.0;
  // The sum over the triangles from the centre of mass to each edge. A triangle with the sides a
  // and b has the area a x b / 2 and, about the corner that they share, the second moment of area
  // a x b (a.a + a.b + b.b) / 12.
  double area = 0.0;    // m^2, times 2
  double second = 0.0;  // m^4, times 12
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
  MIROCUP_ASSERT(p.robot_corners.corners <= geometry::max_corners);
  if (p.robot_corners.corners == 0) return geometry::square(p.robot_side);
  std::array<Vec2, geometry::max_corners> corners;
  for (int i = 0; i < p.robot_corners.corners; ++i) corners[i] = p.robot_corners.corner(i);
  return geometry::polygon({corners.data(), static_cast<std::size_t>(p.robot_corners.corners)});
}

}  // namespace model
}  // namespace mirocup::simulator
