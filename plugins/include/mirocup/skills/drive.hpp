// SPDX-License-Identifier: MIT
//
// Turning and driving in the shortest time that motors and wheels allow.
//
// A motor follows a wanted speed with the time constant T, so a robot that turns at w still turns
// by w T after the command to stop. With the command c for one tick of length P and then 0, the
// robot turns by w T + c P in all. This equation, solved for c, gives the command after which the
// robot ends at the wanted heading, without overshoot and without a gain to choose. The same
// equation in metres holds for driving.
//
//   when_commanded   where a robot will be when its next command begins
//   turn_quickly     turns on the spot
//   drive_quickly    drives to a point, forwards or backwards
//   take_pose        drives to a point and turns to a heading there
//
// A command is driven one tick after the team gave it. A team that remembers its last command
// passes the state of when_commanded() to these functions. Frames and units are those of
// strategy.h.
#pragma once

#include "mirocup/strategy.hpp"

namespace mirocup::strategy {

inline Point nose_of(const Robot& robot) {
  return {math::cos(robot.heading), math::sin(robot.heading)};
}

// Returns the forward speed of a robot, m/s; negative if it drives backwards.
inline double speed_ahead(const Robot& robot) {
  return dot({robot.vx, robot.vy}, nose_of(robot));
}

inline double greatest_speed(const Setup& setup) {
  return setup.wheel_radius * setup.wheel_speed_limit;
}

// Returns the robot one tick later if it drives `command` in this tick. Precondition: the wheels do
// not slide.
inline Robot when_commanded(const Setup& setup, const Robot& robot, Wheels command) {
  const double lag = setup.motor_time_constant;
  const double period = setup.control_period;
  // The part of the difference to the commanded speed that is left after the tick.
  const double left = lag > 0.0 ? math::exp(-period / lag) : 0.0;
  const double forward = setup.wheel_radius * (command.right + command.left) / 2.0;
  const double turn = setup.wheel_radius * (command.right - command.left) / setup.wheel_distance;
  const double before = speed_ahead(robot);
  const double way = forward * period + (before - forward) * lag * (1.0 - left);
  const double angle = turn * period + (robot.turn - turn) * lag * (1.0 - left);
  const double after = forward + (before - forward) * left;

  Robot then = robot;
  const double between = robot.heading + angle / 2.0;
  then.x += way * math::cos(between);
  then.y += way * math::sin(between);
  then.heading = wrapped(robot.heading + angle);
  then.vx = after * math::cos(then.heading);
  then.vy = after * math::sin(then.heading);
  then.turn = turn + (robot.turn - turn) * left;
  return then;
}

// Returns the wheel speeds for a turn (rad/s) and a forward speed (m/s). The turn has priority; the
// forward speed gets the rest of the wheel speed.
inline Wheels wheels_turning_first(const Setup& setup, double forward, double turn) {
  const double most = greatest_speed(setup);
  const double side = math::clamp(turn * setup.wheel_distance / 2.0, -most, most);
  const double rest = most - std::abs(side);
  const double mean = math::clamp(forward, -rest, rest);
  return {(mean - side) / setup.wheel_radius, (mean + side) / setup.wheel_radius};
}

// Returns the turn (rad/s) to command so that a robot that now turns at `turn` rad/s ends `error`
// rad farther. The command corrects only `part` of the error, because robots do not follow commands
// exactly; later ticks correct the rest.
inline double turn_for(const Setup& setup, double turn, double error, double part = 0.9) {
  return (part * error - setup.motor_time_constant * turn) / setup.control_period;
}

inline Wheels turn_quickly(const Setup& setup, const Robot& robot, double heading) {
  const double error = wrapped(heading - robot.heading);
  const double brake = -speed_ahead(robot) * setup.motor_time_constant / setup.control_period;
  return wheels_turning_first(setup, brake, turn_for(setup, robot.turn, error));
}

// Drives at up to `speed` m/s in a direction, forwards or backwards, whichever needs the smaller
// turn. The robot stops after `distance` (m). A sliding wheel does not steer, so the turn limits
// the speed.
inline Wheels head_for(const Setup& setup, const Robot& robot, double direction, double speed,
                       double distance = 1e9) {
  double error = wrapped(direction - robot.heading);
  double way = 1.0;
  const double moving = speed_ahead(robot);
  if (math::cos(error) + 0.15 * math::clamp(moving, -1.0, 1.0) < 0.0) {
    error = wrapped(error + pi);
    way = -1.0;
  }
  const double turn = turn_for(setup, robot.turn, error);
  const double lag = setup.motor_time_constant;
  const double stop = (distance - way * moving * lag) / setup.control_period;
  const double sharp = math::clamp(2.5 * math::cos(error) - 1.5, 0.0, 1.0);
  double forward = math::min(speed * sharp, stop);
  const double steady = 0.85 * setup.grip * 9.81;  // m/s^2
  const double limit = steady / math::max(std::abs(error) / (2.0 * lag), 1e-6);
  if (forward > limit) forward = limit;
  return wheels_turning_first(setup, way * forward, turn);
}

// Drives to a point and stops there, or passes it at `arrival` m/s.
inline Wheels drive_quickly(const Setup& setup, const Robot& robot, Point target,
                            double arrival = 0.0, double speed = 1.8) {
  const Point to = target - position(robot);
  const double distance = length(to);
  if (distance < 0.004 && arrival == 0.0) return turn_quickly(setup, robot, robot.heading);
  const double beyond = arrival * 0.15;  // m, so that the robot does not brake
  return head_for(setup, robot, math::atan2(to.y, to.x), speed, distance + beyond);
}

// Drives to within `near` m of a point, then turns to a heading or to its opposite, whichever is
// nearer.
inline Wheels take_pose(const Setup& setup, const Robot& robot, Point target, double heading,
                        double near = 0.012, double speed = 1.8) {
  if (length(target - position(robot)) > near)
    return drive_quickly(setup, robot, target, 0.0, speed);
  const double error = wrapped(heading - robot.heading);
  return turn_quickly(setup, robot, std::abs(error) > pi / 2.0 ? heading + pi : heading);
}

}  // namespace mirocup::strategy
