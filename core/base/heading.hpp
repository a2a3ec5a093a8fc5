// SPDX-License-Identifier: MIT
//
// The heading of a robot, as a unit vector.
//
// If a heading were an angle, a half-turn of the field would add pi to it and round the sum. The
// half-turn negates a unit vector, which is exact to the last bit. So both ends of the field play
// the same game (core/README.md, "Fair ends").
#pragma once

#include "core/base/math.hpp"
#include "core/base/vec2.hpp"

#include <cmath>

namespace mirocup {

// The cosine and sine of the angle from +x, counter-clockwise.
struct Heading {
  double cos = 1.0;
  double sin = 0.0;

  // The heading of an angle in radians, counter-clockwise from +x.
  static Heading from_angle(double angle) {
    const SinCos sc = sincos(angle);
    return {sc.cos, sc.sin};
  }

  // Returns the angle in radians, in (-pi, pi].
  double angle() const { return atan2(sin, cos); }

  // Unit vectors of the body frame in the field's frame.
  Vec2 forward() const { return {cos, sin}; }
  Vec2 left() const { return {-sin, cos}; }

  // Rotate a vector from the body frame to the field's frame, and back.
  Vec2 to_world(const Vec2& v) const {
    return {cos * v.x() - sin * v.y(), sin * v.x() + cos * v.y()};
  }
  Vec2 to_body(const Vec2& v) const {
    return {cos * v.x() + sin * v.y(), cos * v.y() - sin * v.x()};
  }

  // Returns the opposite heading, exactly.
  Heading half_turned() const { return {-cos, -sin}; }

  // Returns this heading in the frame of a body with the heading `frame`.
  Heading seen_from(const Heading& frame) const {
    return {frame.cos * cos + frame.sin * sin, frame.cos * sin - frame.sin * cos};
  }

  // Returns the heading turned counter-clockwise by an angle, given as its sine and cosine.
  Heading turned(const SinCos& by) const {
    return Heading{cos * by.cos - sin * by.sin, sin * by.cos + cos * by.sin}.normalised();
  }

  // Returns the heading with length 1, for a vector whose length differs from 1 by rounding only.
  Heading normalised() const {
    const double length = std::sqrt(cos * cos + sin * sin);
    return {cos / length, sin / length};
  }
};

}  // namespace mirocup
