// SPDX-License-Identifier: MIT
//
// Points and vectors of the plane, in metres or metres per second; in the field's frame unless the
// user says otherwise.
#pragma once

#include <Eigen/Core>

namespace mirocup {

using Vec2 = Eigen::Vector2d;

// Returns the z component of a x b.
inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Returns omega x r for an angular velocity about z (rad/s): the velocity of a point at lever r.
inline Vec2 cross(double omega, const Vec2& r) {
  return {-omega * r.y(), omega * r.x()};
}

}  // namespace mirocup
