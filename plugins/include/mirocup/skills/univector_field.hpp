// SPDX-License-Identifier: MIT
//
// A field of directions that leads to a pose: at each place it gives the direction to drive in.
// From any place, a robot that follows the field reaches the target with the wanted heading,
// because it arrives along one of two spirals, one on either side of the target. Obstacles turn the
// field aside.
//
//   field_heading    the direction at a place
//   around           a direction, turned aside by a moving obstacle
//   round_others     a direction, turned aside by all other robots
//   follow_heading   drives in a direction
//   follow_field     drives along the field, slower where it bends
//
// Y.-J. Kim, J.-H. Kim, D.-S. Kwon: Evolutionary programming-based univector field navigation
// method for fast mobile robots, IEEE Transactions on Systems, Man, and Cybernetics B 31 (2001).
// Frames and units are those of strategy.h.
#pragma once

#include "mirocup/strategy.hpp"

namespace mirocup::strategy {

struct UnivectorField {
  double radius = 0.075;  // m: radius of the circles beside the target in which the spirals end
  double smooth = 0.07;   // m: a greater value makes a wider way round the target
};

// A place and the wanted heading at the place.
struct Target {
  Point at;        // m
  double heading;  // rad
};

// Returns the field's direction at `here`, rad.
inline double field_heading(const UnivectorField& field, Point here, const Target& target) {
  const double c = math::cos(target.heading);
  const double s = math::sin(target.heading);
  const Point from = here - target.at;
  const Point p{c * from.x + s * from.y, -s * from.x + c * from.y};  // the target looks along +x
  const double d = field.radius;
  // The spiral about (0, turn * d): counter-clockwise for turn 1, clockwise for turn -1.
  const auto spiral = [&](double turn) {
    const Point v{p.x, p.y - turn * d};
    const double rho = length(v);
    const double bend =
        rho > d ? 2.0 - (d + field.smooth) / (rho + field.smooth) : std::sqrt(rho / d);
    return math::atan2(v.y, v.x) + turn * pi / 2.0 * bend;
  };
  if (p.y < -d) return wrapped(target.heading + spiral(-1.0));
  if (p.y > d) return wrapped(target.heading + spiral(1.0));
  const double left = spiral(1.0);
  const double right = spiral(-1.0);
  const Point sum = (p.y + d) * Point{math::cos(left), math::sin(left)} +
                    (d - p.y) * Point{math::cos(right), math::sin(right)};
  return wrapped(target.heading + math::atan2(sum.y, sum.x));
}

// A moving obstacle.
struct Obstacle {
  Point at;        // m
  Point velocity;  // m/s
};

struct Avoidance {
  double nearest = 0.085;  // m between the middles; a nearer robot turns aside completely
  double width = 0.045;    // m: a greater width makes avoiding begin more softly
  double lead_s = 0.15;    // s: an obstacle counts at its relative place after this time
};

// Returns `heading`, turned aside by an obstacle on the way. `velocity`: of the robot, m/s.
inline double around(double heading, Point here, Point velocity, const Obstacle& obstacle,
                     const Avoidance& how = {}) {
  const Point to = obstacle.at - here;
  const double distance = length(to);
  Point shift = how.lead_s * (obstacle.velocity - velocity);
  if (length(shift) > 0.8 * distance) shift = (0.8 * distance / length(shift)) * shift;
  const double gap = length(to + shift);
  const double bearing = math::atan2(to.y, to.x);
  const double side = wrapped(heading - bearing);
  if (std::abs(side) > pi / 2.0) return heading;  // the robot drives away from the obstacle
  // The new heading passes the obstacle on the side to which `heading` points, and leads a little
  // away from the obstacle.
  const double past = bearing + (side >= 0.0 ? 1.0 : -1.0) * 0.6 * pi;
  const double far = math::max(0.0, gap - how.nearest) / how.width;
  const double weight = math::exp(-0.5 * far * far);
  return wrapped(heading + weight * wrapped(past - heading));
}

// Returns `heading`, turned aside by the other robots within `sight` m, except robots at `target`.
// `robot` is the state of robot number `me` at its next command.
inline double round_others(const Observation& now, int me, const Robot& robot, Point target,
                           double heading, double sight = 0.35, const Avoidance& how = {}) {
  const auto pass = [&](const Robot& other) {
    const bool is_near = length(position(other) - position(robot)) < sight;
    if (!is_near || length(position(other) - target) < 0.1) return;
    heading = around(heading, position(robot), {robot.vx, robot.vy},
                     {position(other), {other.vx, other.vy}}, how);
  };
  for (int j = 0; j < now.robots; ++j) {
    pass(now.opponent[j]);
    if (j != me) pass(now.own[j]);
  }
  return heading;
}

// Drives in the direction `heading` at `speed` m/s, forwards or backwards; a robot that already
// moves reverses only if it must. `turn` is the rate at which `heading` itself turns, rad/s.
inline Wheels follow_heading(const Setup& setup, const Robot& robot, double heading, double speed,
                             double turn = 0.0) {
  const double lead_s = 0.06;  // s: a turn continues for this time after a command
  double error = wrapped(heading - robot.heading - lead_s * robot.turn);
  const double moving = robot.vx * math::cos(robot.heading) + robot.vy * math::sin(robot.heading);
  double direction = 1.0;
  if (math::cos(error) + 0.2 * math::clamp(moving, -1.0, 1.0) < 0.0) {
    direction = -1.0;
    error = wrapped(error + pi);
  }
  const double wanted = turn + 10.0 * error;
  double forward = speed * math::max(0.0, math::cos(error));
  const double steady = 0.8 * setup.grip * 9.81;  // sliding wheels do not steer, m/s^2
  if (std::abs(forward * wanted) > steady) forward = steady / std::abs(wanted);
  return wheels_for(setup, direction * forward, wanted);
}

// Drives along the field to a target at up to `speed` m/s and round `count` obstacles. Reads the
// field at the robot's place `lead_s` seconds later, because motors follow late. A robot on the
// axis before the target may choose either side.
inline Wheels follow_field(const Setup& setup, const Robot& robot, const Target& target,
                           double speed, const Obstacle* obstacles = nullptr, int count = 0,
                           const UnivectorField& field = {}, double lead_s = 0.08) {
  const Point velocity{robot.vx, robot.vy};
  const auto direction = [&](Point here) {
    double heading = field_heading(field, here, target);
    for (int i = 0; i < count; ++i) heading = around(heading, here, velocity, obstacles[i]);
    return heading;
  };
  // The place of the robot when its motors have followed the command.
  const Point here = position(robot) + lead_s * velocity;
  const double heading = direction(here);
  const double step = 0.03;  // m
  const Point next = here + step * Point{math::cos(heading), math::sin(heading)};
  const double bend = wrapped(direction(next) - heading) / step;  // rad/m
  const double grip = 0.7 * setup.grip * 9.81;
  const double fastest = math::min(speed, std::sqrt(grip / math::max(std::abs(bend), 0.1)));
  return follow_heading(setup, robot, heading, fastest, fastest * bend);
}

}  // namespace mirocup::strategy
