// SPDX-License-Identifier: MIT
//
// A robot that can touch nothing and whose wheels cannot slide: where it will be, without a series.
//
// Speeds are exponentials and the heading is their integral, in closed form; the way is one smooth
// integral, done by Gauss's rule, exact to rounding for the turns that are let in here. It costs a
// tenth of the series that contacts need.
#pragma once

#include "core/base/math.hpp"
#include "core/simulator/parameters.hpp"
#include "core/simulator/robot_motion.hpp"
#include "core/simulator/segment.hpp"
#include "core/simulator/way.hpp"

#include <array>

namespace mirocup::simulator {

inline constexpr int gauss_nodes = angles_at_once;

// e^(-t/T) at the nodes of Gauss's rule over [0, span] and at its end: the same for all robots.
struct MotorDecay {
  double span = -1.0;  // s
  double time_constant = 0.0;
  std::array<double, gauss_nodes> at_node;
  double at_end = 1.0;
};
MotorDecay motor_decay(const Parameters& parameters, double span);

// Can the robot's motion over `span` seconds be had this way? The wheels roll and will roll, and it
// does not turn too far for the rule.
bool is_quiet(const Parameters& parameters, const Body& robot, const Drive& drive, double span);

// The robot after decay.span seconds.
Body moved(const Body& robot, const Drive& drive, const MotorDecay& decay);

// A box that holds its centre on the way from `robot` to `end`, as moved() gave it.
Box box_around_way(const Body& robot, const Body& end, const Drive& drive, const MotorDecay& decay);

// The same as a way that begins at `begin`, s of the tick.
Way quiet_way(const Body& robot, const Body& end, const Drive& drive, const MotorDecay& decay,
              double begin);

}  // namespace mirocup::simulator
