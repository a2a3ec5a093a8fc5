// SPDX-License-Identifier: MIT
//
// An independent integrator to compare the simulator with: angles instead of unit vectors, the C
// library's sine, forces written out from the model's text, the classical Runge-Kutta method with
// tiny steps. It shares no code with core/simulator but the structs of its numbers.
#pragma once

#include "core/simulator/parameters.hpp"
#include "core/simulator/state.hpp"

namespace mirocup::test_support {

struct RobotByAngle {
  double x = 0.0, y = 0.0, angle = 0.0;
  double forward = 0.0, left = 0.0, turn = 0.0;
};

// A robot alone for `duration` seconds under constant wheel speeds (rad/s), in `steps` steps.
// Sliding wheels that come to rest within a step are found by bisection.
RobotByAngle drive_in_tiny_steps(const simulator::Parameters& parameters, RobotByAngle robot,
                                 double left_wheel, double right_wheel, double duration, int steps);

}  // namespace mirocup::test_support
