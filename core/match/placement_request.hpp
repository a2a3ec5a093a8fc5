// SPDX-License-Identifier: MIT
//
// Where a team asks to stand at a restart, in its own frame: metres, radians counter-clockwise.
//
// Like a command it is input from outside: any number may be in it, and it is kept as it came, so
// that a recorded leg can be played again without the team.
#pragma once

#include "core/field/frames.hpp"
#include "core/field/league.hpp"
#include "core/referee/placement.hpp"

#include <array>

namespace mirocup::match {

struct Observation;
struct Scene;

struct AskedPose {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
};

struct Poses {
  double ball_x = 0.0;
  double ball_y = 0.0;
  std::array<AskedPose, max_robots_per_team> robots;
};

// What a team asks for that asks for nothing: everything where it is.
Poses standing(const Observation& observation);

// The same numbers, bit for bit: what is not a number equals itself.
bool is_same(double a, double b);
bool is_same(const AskedPose& a, const AskedPose& b);
bool is_same(const Poses& a, const Poses& b, int robots);

// The scene with what one team asks for in it, in the field's frame. What is as it was `shown`
// stays bit for bit. A heading that is no angle makes a pose that is nowhere.
referee::Placement asked_placement(const Scene& scene, Team team, const Poses& shown,
                                   const Poses& asked, int robots);

}  // namespace mirocup::match
