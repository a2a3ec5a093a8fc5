// SPDX-License-Identifier: MIT
//
// Points and vectors of the plane, in metres or metres per second; in the field's frame unless the
// code that uses them says otherwise. Operations have the names that they have in Eigen, and round
// as Eigen's do: once for each multiplication, addition and division, x before y.
#pragma once

#include <cmath>

namespace mirocup {

class Vec2 {
 public:
  constexpr Vec2() = default;
  constexpr Vec2(double x, double y) : x_(x), y_(y) {}
  static constexpr Vec2 Zero() { return {}; }

  constexpr double x() const { return x_; }
  constexpr double y() const { return y_; }
  constexpr double& x() { return x_; }
  constexpr double& y() { return y_; }

  constexpr Vec2 operator-() const { return {-x_, -y_}; }
  constexpr Vec2& operator+=(const Vec2& b) { return *this = {x_ + b.x_, y_ + b.y_}; }
  constexpr Vec2& operator-=(const Vec2& b) { return *this = {x_ - b.x_, y_ - b.y_}; }
  constexpr Vec2& operator*=(double s) { return *this = {x_ * s, y_ * s}; }
  constexpr Vec2& operator/=(double s) { return *this = {x_ / s, y_ / s}; }
  friend constexpr Vec2 operator+(const Vec2& a, const Vec2& b) {
    return {a.x_ + b.x_, a.y_ + b.y_};
  }
  friend constexpr Vec2 operator-(const Vec2& a, const Vec2& b) {
    return {a.x_ - b.x_, a.y_ - b.y_};
  }
  friend constexpr Vec2 operator*(double s, const Vec2& a) { return {s * a.x_, s * a.y_}; }
  friend constexpr Vec2 operator*(const Vec2& a, double s) { return {a.x_ * s, a.y_ * s}; }
  friend constexpr Vec2 operator/(const Vec2& a, double s) { return {a.x_ / s, a.y_ / s}; }
  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;

  constexpr double dot(const Vec2& b) const { return x_ * b.x_ + y_ * b.y_; }
  constexpr double squaredNorm() const { return dot(*this); }
  double norm() const { return std::sqrt(squaredNorm()); }
  // Returns the unit vector of this direction; a zero vector stays zero.
  Vec2 normalized() const { return squaredNorm() > 0 ? *this / norm() : *this; }

 private:
  double x_ = 0, y_ = 0;
};

// Returns the z component of a x b.
constexpr double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Returns omega x r for an angular velocity about z (rad/s): the velocity of a point at lever r.
constexpr Vec2 cross(double omega, const Vec2& r) {
  return {-omega * r.y(), omega * r.x()};
}

}  // namespace mirocup
