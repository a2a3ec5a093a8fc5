// SPDX-License-Identifier: MIT
//
// A robot as teams and programs on the network see it. Metres, radians, m/s, rad/s.
//
// The heading is an angle here, rounded to a multiple of 2^-50 rad. As a double, pi is also such a
// multiple, so a half-turn of the field adds or subtracts pi without rounding: a team sees the same
// bits at either end, and a program that receives the robot in the field's frame can compute what
// the team sees, bit for bit.
#pragma once

#include "core/field/frames.hpp"
#include "core/simulator/model/state.hpp"

namespace mirocup::match {

struct ObservedRobot {
  Vec2 position{0.0, 0.0};
  double heading = 0.0;  // in (-pi, pi], counter-clockwise from +x
  Vec2 velocity{0.0, 0.0};
  double turn = 0.0;
  int age = 0;  // ticks since a camera saw the robot like this; 0 without a camera
};

// Returns an angle in (-pi, pi], rounded as described above.
double observed_angle(const Heading& heading);
double observed_angle(double angle);

// Returns the angle of the opposite heading, in (-pi, pi]; exact for rounded angles.
double half_turned(double angle);

// Returns the robot in the field's frame.
ObservedRobot observed(const simulator::BodyState& robot);

// Converts from the field's frame to the frame of the team that defends `end`, and back; exact.
ObservedRobot team_frame(End end, const ObservedRobot& robot);

}  // namespace mirocup::match
