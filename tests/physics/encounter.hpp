// SPDX-License-Identifier: MIT
//
// Two bodies of the exact motion that approach each other, and the bracket of equation (21) where
// they touch.
#pragma once

#include "tests/physics/scene.hpp"

#include <optional>

namespace mirocup::scenes {

using test_support::Real;

// A body of the exact motion; what is neither robot nor ball is solid.
struct MovingOutline {
  std::optional<test_support::ExactRobot> robot;
  std::optional<test_support::ExactBall> ball;
  WheelCommand command;
  test_support::Outline solid;

  bool is_solid() const { return !robot && !ball; }
  test_support::Outline outline(const Parameters& p) const;
  void move(const Parameters& p, Real duration);
  double speed_bound(const Parameters& p) const;  // no point of it is or gets faster than this
  double mass(const Parameters& p) const;
  Vec2 position() const;
  Vec2 forward() const;
};

// A robot's, about its centre.
double inertia(const Parameters& p);

// What one unit of impulse changes along the normal: a bracket of (21).
double inverse_mass(const Parameters& p, const MovingOutline& m,
                    const test_support::TouchPoint& touch);

void push(const Parameters& p, MovingOutline& m, const test_support::TouchPoint& touch,
          double impulse);

struct Encounter {
  Real time = 0;
  test_support::TouchPoint touch{};
  double approach = 0.0;
};

// Moves both to their first touch within `limit` seconds: steps that are too short to reach it,
// then Newton's method. Nothing if there is none, or one so slow that its time is ill-defined.
std::optional<Encounter> first_touch(const Parameters& p, MovingOutline& a, MovingOutline& b,
                                     Real limit);

}  // namespace mirocup::scenes
