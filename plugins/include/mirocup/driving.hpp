// SPDX-License-Identifier: MIT
//
// Driving of one robot: to a point, to a pose, round an obstacle. The functions return the wheel
// speeds of one robot for this tick; call them again in every tick. Sizes and limits come from the
// setup. Include strategy.hpp instead of this header.
#pragma once

#include "mirocup/types.hpp"

#include <cmath>

namespace mirocup::strategy {

// Returns the wheel speeds for a forward speed (m/s) and an angular velocity (rad/s). If one wheel
// would be too fast, both wheels are slowed by the same factor, so that the robot stays on its
// curve.
inline Wheels wheels_for(const Setup& setup, double forward, double turn) {
  const double side = turn * setup.wheel_distance / 2.0;
  Wheels w{(forward - side) / setup.wheel_radius, (forward + side) / setup.wheel_radius};
  const double fastest = math::max(std::abs(w.left), std::abs(w.right));
  if (fastest > setup.wheel_speed_limit) {
    const double k = setup.wheel_speed_limit / fastest;
    w.left *= k;
    w.right *= k;
  }
  return w;
}

// Turns on the spot towards a heading, rad.
inline Wheels turn_to(const Setup& setup, const Robot& robot, double heading) {
  return wheels_for(setup, 0.0, 8.0 * wrapped(heading - robot.heading));
}

// Drives to a point and passes it at `arrival` m/s (0: stops there), forwards or backwards,
// whichever needs the smaller turn. `fastest` is the greatest speed, m/s.
inline Wheels drive_to(const Setup& setup, const Robot& robot, Point target, double arrival = 0.0,
                       double fastest = 1.5) {
  const Point to = target - position(robot);
  const double distance = length(to);
  if (distance < 0.005 && arrival == 0.0) return {0.0, 0.0};
  double error = wrapped(math::atan2(to.y, to.x) - robot.heading);
  double direction = 1.0;
  if (std::abs(error) > pi / 2.0) {
    error = wrapped(error + pi);
    direction = -1.0;
  }
  // The speed is as great as the distance allows, and smaller while the robot still has to turn.
  const double wanted = math::min(fastest, arrival + 5.0 * distance);
  const double turn = 9.0 * error;
  double speed = wanted * math::max(0.0, math::cos(error));
  // Sliding wheels do not steer, so the robot keeps below 0.8 of the grip.
  const double steady = 0.8 * setup.grip * 9.81;
  if (std::abs(speed * turn) > steady) speed = steady / std::abs(turn);
  return wheels_for(setup, direction * speed, turn);
}

// Drives to a point and turns to a heading there. A distant robot first aims at a place before the
// point, so that it arrives with the right heading. A robot beside the point first backs off.
inline Wheels drive_to_pose(const Setup& setup, const Robot& robot, Point target, double heading,
                            double fastest = 1.5) {
  const Point forward{math::cos(heading), math::sin(heading)};
  const Point to = target - position(robot);
  const double distance = length(to);
  if (distance < 0.01) return turn_to(setup, robot, heading);
  const bool is_on_line = dot(to, forward) > 0.9 * distance;
  if (is_on_line) return drive_to(setup, robot, target, 0.0, fastest);
  const double run_up = math::clamp(0.6 * distance, 0.05, 0.3);
  return drive_to(setup, robot, target - run_up * forward, 0.2, fastest);
}

// Returns about the place of the ball after `seconds` if it meets neither robots nor walls. The
// ball slows down on its way.
inline Point ball_after(const Observation& now, double seconds) {
  return ball(now) + (seconds * (1.0 - 0.1 * seconds)) * ball_velocity(now);
}

// Returns the smallest distance, m, of a robot's centre from a wall at which the robot can turn.
inline double elbow_room(const Setup& setup) {
  return 0.6 * setup.robot_side;
}

// Returns the distance, m, between the middles of robot and ball at which the robot can turn
// without touching the ball.
inline double behind_ball(const Setup& setup) {
  return setup.robot_side + 0.035;
}

// Returns `p`, or the point nearest to `p` that is at least `margin` (m) away from the walls.
// Ignores the triangles in the corners of the field.
inline Point inside(const Setup& setup, Point p, double margin) {
  return {math::clamp(p.x, -setup.half_length + margin, setup.half_length - margin),
          math::clamp(p.y, -setup.half_width + margin, setup.half_width - margin)};
}

// Returns `p`, or the point nearest to `p` at which a robot has room to turn.
inline Point inside(const Setup& setup, Point p) {
  return inside(setup, p, elbow_room(setup));
}

// Returns the place where a robot that drives at `pace` m/s meets the ball.
inline Point meeting_point(const Setup& setup, const Observation& now, const Robot& robot,
                           double pace = 1.2) {
  Point p = ball(now);
  for (int i = 0; i < 3; ++i) {
    p = ball_after(now, math::min(length(p - position(robot)) / pace, 0.8));
  }
  return inside(setup, p, setup.ball_radius);
}

// Returns the multiple of a right angle that is nearest to a heading, rad.
inline double squared(double heading) {
  return pi / 2.0 * std::round(heading / (pi / 2.0));
}

// Drives to a point, around an obstacle on the line to it.
inline Wheels drive_round(const Setup& setup, const Robot& robot, Point target, Point obstacle,
                          double arrival, double fastest) {
  const double berth = behind_ball(setup);
  const Point here = position(robot);
  const Point path = target - here;
  const Point to = obstacle - here;
  const Point along = unit(path);
  const double ahead = dot(to, along);
  const double aside = along.x * to.y - along.y * to.x;
  if (ahead <= 0.0 || ahead >= length(path) || std::abs(aside) >= berth) {
    return drive_to(setup, robot, target, arrival, fastest);
  }
  // The robot is too near to turn past the obstacle, so it first backs off.
  if (length(to) < setup.robot_side + 0.04)
    return drive_to(setup, robot, here - 0.1 * unit(to), 0.0, fastest);
  const double side = aside > 0.0 ? -1.0 : 1.0;
  const Point beside = obstacle + (side * berth * 1.2) * Point{-along.y, along.x};
  return drive_to(setup, robot, beside, 0.3, math::min(fastest, 0.9));
}

// Drives to a point, around the ball or an opponent on the line to the point: a robot that returns
// home must not push the ball along, and no robot may push an opponent. At the point the robot
// waits square to the field, because a ball that hits a slanting face may go into the own goal.
inline Wheels drive_clear(const Setup& setup, const Observation& now, const Robot& robot,
                          Point target, double arrival = 0.0, double fastest = 1.5) {
  const Point here = position(robot);
  if (arrival == 0.0 && length(target - here) < 0.03) {
    return turn_to(setup, robot, squared(robot.heading));
  }
  Point obstacle = ball(now);
  for (int j = 0; j < now.robots; ++j) {
    const Point p = position(now.opponent[j]);
    if (length(p - here) < 0.2 && length(p - here) < length(obstacle - here) &&
        dot(p - here, target - here) > 0.0) {
      obstacle = p;
    }
  }
  return drive_round(setup, robot, target, obstacle, arrival, fastest);
}

// Drives along the goal line to a y, forwards or backwards, and always looks along the line: a
// keeper that turns away from the line throws the ball into its goal. The robot brakes early, by
// the distance that it rolls while its motors follow, because a keeper that runs past its place
// meets the ball with a side that turns the ball into the goal.
inline Wheels slide_to(const Setup& setup, const Robot& robot, double y, double fastest = 1.5) {
  const bool is_up = robot.heading > 0.0;
  const double error = wrapped((is_up ? pi / 2.0 : -pi / 2.0) - robot.heading);
  const double rolls_on = robot.vy * (setup.control_period + setup.motor_time_constant);  // m
  const double speed = math::clamp(12.0 * (y - robot.y - rolls_on), -fastest, fastest);
  const double forward = (is_up ? speed : -speed) * math::max(0.0, math::cos(2.0 * error));
  return wheels_for(setup, forward, 9.0 * error);
}

}  // namespace mirocup::strategy
