// SPDX-License-Identifier: MIT
//
// Which way a robot points, as a unit vector.
//
// An angle would make a half-turn of the field inexact (x + pi rounds); a unit vector is negated,
// bit for bit, so both ends of the field play the same game (core/README.md, "Fair ends").
#pragma once

#include "core/base/math.hpp"
#include "core/base/vec2.hpp"

#include <cmath>

namespace mirocup {

struct Heading {
  double cos = 1.0;
  double sin = 0.0;

  // Counter-clockwise from +x, in radians.
  static Heading from_angle(double angle) {
    const SinCos sc = sincos(angle);
    return {sc.cos, sc.sin};
  }

  // In (-pi, pi].
  double angle() const { return atan2(sin, cos); }

  // Unit vectors of the body frame in the field's frame.
  Vec2 forward() const { return {cos, sin}; }
  Vec2 left() const { return {-sin, cos}; }

  // From the body frame to the field's, and back.
  Vec2 to_world(const Vec2& v) const {
    return {cos * v.x() - sin * v.y(), sin * v.x() + cos * v.y()};
  }
  Vec2 to_body(const Vec2& v) const {
    return {cos * v.x() + sin * v.y(), cos * v.y() - sin * v.x()};
  }

  Heading half_turned() const { return {-cos, -sin}; }

  // In the frame of another one.
  Heading seen_from(const Heading& frame) const {
    return {frame.cos * cos + frame.sin * sin, frame.cos * sin - frame.sin * cos};
  }

  // Turned by an angle given as its sine and cosine.
  Heading turned(const SinCos& by) const {
    return Heading{cos * by.cos - sin * by.sin, sin * by.cos + cos * by.sin}.normalised();
  }

  // Length 1 again after rounding; for vectors that are nearly of length 1 already.
  Heading normalised() const {
    const double length = std::sqrt(cos * cos + sin * sin);
    return {cos / length, sin / length};
  }
};

}  // namespace mirocup
