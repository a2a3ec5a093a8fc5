// SPDX-License-Identifier: MIT
//
// Reference solution of free motion: one robot or the ball alone, in extended precision.
//
// Written from the equations and not from core/simulator, of which it uses only the structs of its
// numbers: angles instead of unit vectors, the C library's sine, and for the robot the
// extrapolated midpoint rule of Gragg, Bulirsch and Stoer. The moments at which wheels begin or
// cease to slide are found by bisection.
#pragma once

#include "core/simulator/model/parameters.hpp"
#include "core/simulator/model/state.hpp"

namespace mirocup::test_support {

using Real = long double;

struct ExactRobot {
  Real x = 0, y = 0, angle = 0;          // field's frame, m and rad
  Real forward = 0, left = 0, turn = 0;  // body's frame, m/s and rad/s
};

struct ExactBall {
  Real x = 0, y = 0, vx = 0, vy = 0;
};

ExactRobot exactly(const simulator::BodyState& robot);
ExactBall exactly(const simulator::BallState& ball);
simulator::BodyState rounded(const ExactRobot& robot);

// Returns the motion for `duration` seconds under one command, with wheels on the ground or not.
// The relative error is about 1e-17 for every second.
ExactRobot drive_exactly(const simulator::Parameters& parameters, ExactRobot robot,
                         const simulator::WheelCommand& command, Real duration);

// The same in closed form: ds/dt = -(f_v s + K_c m g) / m' until s = 0.
ExactBall roll_exactly(const simulator::Parameters& parameters, ExactBall ball, Real duration);

// Returns the time in which a ball rolls `distance`, at most `limit`; more than `limit` if the ball
// stops before.
Real time_to_roll(const simulator::Parameters& parameters, Real speed, Real distance, Real limit);

}  // namespace mirocup::test_support
