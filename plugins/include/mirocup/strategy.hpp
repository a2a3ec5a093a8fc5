// SPDX-License-Identifier: MIT
//
// A team in C++: derive a class from Team and export it.
//
//   using namespace mirocup::strategy;
//   class Mine : public Team {
//    public:
//     using Team::Team;
//     void decide(const Observation& now, Command& command) override {
//       for (int i = 0; i < now.robots; ++i) {
//         command.wheels[i] = drive_to(setup(), now.own[i], {now.ball_x, now.ball_y});
//       }
//     }
//   };
//   MIROCUP_EXPORT_TEAM(Mine, "mine")
//
// Frames, units, delays and limits are those of strategy.h. This header depends on nothing else.
// All functions are inline and keep nothing between two calls.
//
//   numbers     math::sin and its family, with the same bits everywhere: elementary.hpp
//   points      Point, + - *, dot, length, unit, inside, wrapped
//   observation ball, ball_velocity, position, ball_after, meeting_point, must_kick_off
//   one robot   wheels_for, turn_to, drive_to, drive_to_pose, drive_round, drive_clear
//   the laws    keep_out (of the goal area), out_of_area, without_pushing, keep_laws
//   own goals   make_way, avoid_own_goals
//   roles       kick_to (behind the ball, then through it), keep_goal, kick_off
//   stuck balls is_stuck, free_ball
//   a team      Team: decide(), place(), setup(), random(), parameter("name", default),
//               log("format", values...), draw_line, draw_circle, draw_polygon, draw_text,
//               draw_value
//
// The functions that drive return the wheel speeds of one robot for this tick; call them again in
// every tick. They are good enough to start from, and meant to be copied and improved.
#pragma once

#include "mirocup/elementary.hpp"
#include "mirocup/strategy.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <initializer_list>

// Lets the compiler check the arguments of a function against its format, as it does for printf().
#if defined(__GNUC__)
#define MIROCUP_PRINTF(form, first) __attribute__((format(printf, form, first)))
#else
#define MIROCUP_PRINTF(form, first)
#endif

namespace mirocup::strategy {

using Setup = mirocup_setup;
using Observation = mirocup_observation;
using Command = mirocup_command;
using Robot = mirocup_robot;
using Wheels = mirocup_wheels;
using Placement = mirocup_placement;

inline constexpr double pi = 3.14159265358979323846;

// A point or a vector, m.
struct Point {
  double x = 0.0;
  double y = 0.0;
};
inline Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y};
}
inline Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
inline Point operator*(double k, Point a) {
  return {k * a.x, k * a.y};
}
inline double dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y;
}
inline double length(Point a) {
  return std::sqrt(dot(a, a));
}
inline Point unit(Point a) {
  const double l = length(a);
  return l > 0.0 ? (1.0 / l) * a : Point{1.0, 0.0};
}

inline Point ball(const Observation& now) {
  return {now.ball_x, now.ball_y};
}
inline Point ball_velocity(const Observation& now) {
  return {now.ball_vx, now.ball_vy};
}
inline Point position(const Robot& robot) {
  return {robot.x, robot.y};
}

// Returns the same angle in (-pi, pi], rad; NaN for an angle that is infinite or NaN.
inline double wrapped(double angle) {
  const double rest = std::remainder(angle, 2.0 * pi);  // exact, in [-pi, pi]
  return rest <= -pi ? pi : rest;
}

// Returns the wheel speeds for a forward speed (m/s) and an angular velocity (rad/s). If one wheel
// would be too fast, both are slowed by the same factor, so that the robot keeps to its curve.
inline Wheels wheels_for(const Setup& setup, double forward, double turn) {
  const double side = turn * setup.wheel_distance / 2.0;
  Wheels w{(forward - side) / setup.wheel_radius, (forward + side) / setup.wheel_radius};
  const double fastest = std::max(std::abs(w.left), std::abs(w.right));
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
// whichever needs the smaller turn. `fastest`: m/s.
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
  // As fast as the distance allows, and slower while the robot still has to turn.
  const double wanted = std::min(fastest, arrival + 5.0 * distance);
  const double turn = 9.0 * error;
  double speed = wanted * std::max(0.0, math::cos(error));
  // Sliding wheels do not steer, so the robot keeps below 0.8 of the grip.
  const double steady = 0.8 * setup.grip * 9.81;
  if (std::abs(speed * turn) > steady) speed = steady / std::abs(turn);
  return wheels_for(setup, direction * speed, turn);
}

// Drives to a point and turns to a heading there. From far off the robot aims at a place before the
// point, so that it arrives with the right heading; if it stands beside the point, it backs off
// first.
inline Wheels drive_to_pose(const Setup& setup, const Robot& robot, Point target, double heading,
                            double fastest = 1.5) {
  const Point forward{math::cos(heading), math::sin(heading)};
  const Point to = target - position(robot);
  const double distance = length(to);
  if (distance < 0.01) return turn_to(setup, robot, heading);
  const bool is_on_line = dot(to, forward) > 0.9 * distance;
  if (is_on_line) return drive_to(setup, robot, target, 0.0, fastest);
  const double run_up = std::clamp(0.6 * distance, 0.05, 0.3);
  return drive_to(setup, robot, target - run_up * forward, 0.2, fastest);
}

// Returns the place of the ball after some seconds without robots and walls. The ball slows down a
// little.
inline Point ball_after(const Observation& now, double seconds) {
  return ball(now) + (seconds * (1.0 - 0.1 * seconds)) * ball_velocity(now);
}

// The distance of a robot's centre from a wall beside which it can still turn, m.
inline constexpr double elbow_room = 0.045;

// Returns the nearest point of the field that is at least `margin` (m) away from the walls. Ignores
// the triangles in the corners.
inline Point inside(const Setup& setup, Point p, double margin = elbow_room) {
  return {std::clamp(p.x, -setup.half_length + margin, setup.half_length - margin),
          std::clamp(p.y, -setup.half_width + margin, setup.half_width - margin)};
}

// Returns the place where a robot that drives at `pace` m/s meets the ball.
inline Point meeting_point(const Setup& setup, const Observation& now, const Robot& robot,
                           double pace = 1.2) {
  Point p = ball(now);
  for (int i = 0; i < 3; ++i) {
    p = ball_after(now, std::min(length(p - position(robot)) / pace, 0.8));
  }
  return inside(setup, p, setup.ball_radius);
}

// Returns a target of robot `i`, moved out of the areas that the laws forbid: the own goal area, in
// which only the keeper may be, and for robots 3 and higher also the penalty area. Not for the
// keeper.
inline Point keep_out(const Setup& setup, int i, Point p) {
  // For the arc in front of the area and half a robot, m.
  const double margin = setup.league == MIROCUP_LARGE ? 0.15 : 0.095;
  const bool is_crowd = i >= 3 && setup.penalty_area_depth > 0.0;
  const double depth = (is_crowd ? setup.penalty_area_depth : setup.goal_area_depth) + margin;
  const double half_width =
      (is_crowd ? setup.penalty_area_half_width : setup.goal_area_half_width) + margin;
  if (p.x < -setup.half_length + depth && std::abs(p.y) < half_width) {
    p.x = -setup.half_length + depth;
  }
  return p;
}

// Returns a place for a waiting robot, moved aside if the place is before the own goal and the ball
// is nearer to that goal: a ball that the keeper clears would rebound from the robot.
inline Point make_way(const Setup& setup, const Observation& now, Point p) {
  const bool is_in_front = now.ball_x < -setup.half_length + setup.goal_area_depth + 0.15 &&
                           p.x > now.ball_x + 0.02 && p.x < now.ball_x + 0.5;
  if (!is_in_front) return p;
  const double aside = setup.goal_half_width + 0.1;
  p.y = p.y < 0.0 ? std::min(p.y, -aside) : std::max(p.y, aside);
  return p;
}

// True if the ball has made no progress for `patience` s and nearly stands: between two robots, at
// a wall, in a corner.
inline bool is_stuck(const Observation& now, double patience = 0.6) {
  return now.stalemate_s > patience && length(ball_velocity(now)) < 0.15;
}

// Returns the same wheel speeds, unless the robot would push an opponent without playing the ball.
// Then it returns speeds at which the robot slows down before the opponent and backs off. A robot
// at the ball plays the ball: if it and the opponent both backed off, the ball would stay there.
inline Wheels without_pushing(const Setup& setup, const Observation& now, const Robot& robot,
                              Wheels wheels) {
  const Point here = position(robot);
  const Point nose{math::cos(robot.heading), math::sin(robot.heading)};
  const double forward = setup.wheel_radius * (wheels.left + wheels.right) / 2.0;
  const double turn = setup.wheel_radius * (wheels.right - wheels.left) / setup.wheel_distance;
  const Point direction = (forward < 0.0 ? -1.0 : 1.0) * nose;
  const Point to_ball = ball(now) - here;
  if (length(to_ball) < 0.09) return wheels;
  const bool ball_ahead = dot(to_ball, direction) > 0.0 &&
                          std::abs(to_ball.x * direction.y - to_ball.y * direction.x) < 0.055;
  double allowed = std::abs(forward);
  for (int j = 0; j < now.robots; ++j) {
    const Point to = position(now.opponent[j]) - here;
    if (dot(to, direction) <= 0.0 || std::abs(to.x * direction.y - to.y * direction.x) > 0.09)
      continue;
    // The ball is between the robot and the opponent: pushing both is playing the ball. So is
    // driving to a stuck ball.
    const double nearer = is_stuck(now, 1.0) && length(to_ball) < 0.2 ? 0.04 : 0.0;
    if (ball_ahead && dot(to_ball, direction) < dot(to, direction) + nearer) continue;
    const double gap = length(to) - 0.1;
    allowed = std::min(allowed, gap > 0.0 ? 0.1 + 4.0 * gap : -0.2);
  }
  if (allowed == std::abs(forward)) return wheels;
  return wheels_for(setup, forward < 0.0 ? -allowed : allowed, turn);
}

// Returns the same wheel speeds, unless robot `i` is in an area that keep_out() forbids, or will
// soon be there at its speed. Then returns speeds that take the robot out on the shortest way. Not
// for the keeper.
inline Wheels out_of_area(const Setup& setup, int i, const Robot& robot, Wheels wheels) {
  const double margin = 0.04;    // m: a robot counts if more than half of its body is inside
  const double braking_s = 0.1;  // the motors, and the delay of a tick
  const bool is_crowd = i >= 3 && setup.penalty_area_depth > 0.0;
  const double depth = is_crowd ? setup.penalty_area_depth : setup.goal_area_depth;
  const double half_width = is_crowd ? setup.penalty_area_half_width : setup.goal_area_half_width;
  // The arc before the area, m: its height and half its chord.
  const bool has_arc = is_crowd || setup.league == MIROCUP_SMALL;
  const double height = !has_arc ? 0.0 : setup.league == MIROCUP_LARGE ? 0.1 : 0.05;
  const double arc = std::abs(robot.y) < half_width / 2.0 ? height : 0.0;
  const double front = -setup.half_length + depth + arc + margin;
  const double side = half_width + margin;
  const double soon_x = robot.x + braking_s * robot.vx;
  const double soon_y = robot.y + braking_s * robot.vy;
  if (soon_x > front || std::abs(soon_y) > side) return wheels;
  const bool is_near_front = front - robot.x < side - std::abs(robot.y);
  const double beside = robot.y > 0.0 ? side + 0.1 : -side - 0.1;
  return drive_to(setup, robot,
                  is_near_front ? Point{front + 0.1, robot.y} : Point{robot.x, beside});
}

// Applies without_pushing() and out_of_area() to all robots of a command except the keeper, which
// holds its place.
inline void keep_laws(const Setup& setup, const Observation& now, Command& command) {
  for (int i = 1; i < now.robots; ++i) {
    command.wheels[i] = without_pushing(setup, now, now.own[i], command.wheels[i]);
    command.wheels[i] = out_of_area(setup, i, now.own[i], command.wheels[i]);
  }
}

// Returns the multiple of a right angle that is nearest to a heading, rad.
inline double squared(double heading) {
  return pi / 2.0 * std::round(heading / (pi / 2.0));
}

// True if a ball that rolls straight on crosses the own goal line between the posts, or up to
// `margin` (m) beside them.
inline bool rolls_into_own_goal(const Setup& setup, Point ball, Point velocity, double margin) {
  if (velocity.x > -0.05) return false;
  const double seconds = (-setup.half_length - ball.x) / velocity.x;
  return std::abs(ball.y + seconds * velocity.y) < setup.goal_half_width + margin;
}

// True if a ball that comes to `robot` within `soon_s` would rebound from it into the own goal.
inline bool would_turn_ball_in(const Setup& setup, const Observation& now, const Robot& robot,
                               double soon_s = 0.4) {
  const Point velocity = ball_velocity(now);
  const Point coming = velocity - Point{robot.vx, robot.vy};
  const Point along = unit(coming);
  const Point to = position(robot) - ball(now);
  const double ahead = dot(to, along);
  const double aside = along.x * to.y - along.y * to.x;
  if (ahead < 0.0 || ahead > soon_s * length(coming) + 0.06 || std::abs(aside) > 0.08) return false;
  for (int face = 0; face < 4; ++face) {
    const double heading = robot.heading + face * pi / 2.0;
    const Point normal{math::cos(heading), math::sin(heading)};
    const double closing = -dot(coming, normal);
    if (closing < 0.2 * length(coming)) continue;
    const Point off = velocity + (1.4 * closing) * normal;  // 1.4: what impacts leave
    if (rolls_into_own_goal(setup, position(robot) + 0.06 * normal, off, 0.05)) return true;
  }
  return false;
}

// Changes the command of robots from which a ball in the own half would rebound into the own goal:
// a robot that stands at a slant turns square to the field, and a square robot makes way. Not for
// the keeper.
inline void avoid_own_goals(const Setup& setup, const Observation& now, Command& command) {
  const Point velocity = ball_velocity(now);
  if (now.ball_x > 0.0 || length(velocity) < 0.25) return;
  if (rolls_into_own_goal(setup, ball(now), velocity, -0.02)) return;  // worse it cannot get
  for (int i = 1; i < now.robots; ++i) {
    const Robot& robot = now.own[i];
    if (!would_turn_ball_in(setup, now, robot)) continue;
    const double error = squared(robot.heading) - robot.heading;
    if (std::abs(error) > 0.15) {
      const double turns_on = robot.turn * (setup.control_period + setup.motor_time_constant);
      command.wheels[i] = wheels_for(setup, 0.0, 16.0 * (error - turns_on));
    } else {
      const Point along = unit(velocity);
      const Point to = position(robot) - ball(now);
      const Point aside = unit(to - dot(to, along) * along);
      const Point nose{math::cos(robot.heading), math::sin(robot.heading)};
      const double way = dot(nose, aside + 0.7 * along) < 0.0 ? -1.0 : 1.0;
      command.wheels[i] = wheels_for(setup, way * 1.5, 9.0 * error);
    }
  }
}

// Drives to a point, around an obstacle on the line to it.
inline Wheels drive_round(const Setup& setup, const Robot& robot, Point target, Point obstacle,
                          double arrival, double fastest) {
  const double berth = 0.11;
  const Point here = position(robot);
  const Point path = target - here;
  const Point to = obstacle - here;
  const Point along = unit(path);
  const double ahead = dot(to, along);
  const double aside = along.x * to.y - along.y * to.x;
  if (ahead <= 0.0 || ahead >= length(path) || std::abs(aside) >= berth) {
    return drive_to(setup, robot, target, arrival, fastest);
  }
  // Too near to turn past the obstacle: back off first.
  if (length(to) < 0.115) return drive_to(setup, robot, here - 0.1 * unit(to), 0.0, fastest);
  const double side = aside > 0.0 ? -1.0 : 1.0;
  const Point beside = obstacle + (side * berth * 1.2) * Point{-along.y, along.x};
  return drive_to(setup, robot, beside, 0.3, std::min(fastest, 0.9));
}

// Drives to a point, around the ball or an opponent that is on the line to it: a robot that returns
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

// Kicks the ball towards a point: drives to a place behind the ball first, and then through it. The
// point may lie behind the goal line; the middle of the opponents' goal is {half_length, 0}.
inline Wheels kick_to(const Setup& setup, const Observation& now, const Robot& robot, Point point,
                      double pace = 1.5) {
  const Point meet = meeting_point(setup, now, robot);
  const Point along = unit(point - meet);
  const Point from_ball = position(robot) - meet;
  const double behind = -dot(from_ball, along);
  const double aside = from_ball.y * along.x - from_ball.x * along.y;
  if (behind > 0.0 && behind < 0.35 && std::abs(aside) < 0.02 + 0.35 * behind) {
    const Point through = meet + 0.3 * along - (2.0 * aside) * Point{-along.y, along.x};
    return drive_to(setup, robot, through, pace, pace);
  }
  return drive_clear(setup, now, robot, inside(setup, meet - 0.11 * along), 0.3, pace);
}

// True if the ball is still on the spot of your own kick-off. It has to go backwards first.
inline bool must_kick_off(const Observation& now) {
  return now.restart == MIROCUP_KICK_OFF && now.own_restart != 0 &&
         math::hypot(now.ball_x, now.ball_y) < 0.055;
}

// Takes a kick-off: rolls the ball straight back to the team-mates. Left alone, it stops before the
// own goal line. A ball that stays near the centre would belong to the opponents: their kicker
// waits on the side of the ball from which it can shoot, and the taker has to go round it first.
inline Wheels kick_off(const Setup& setup, const Robot& robot) {
  // Through the ball, from wherever the robot was put down; opponents come fast.
  const double pace = length(position(robot)) > 0.1 ? 0.8 : 0.28;  // m/s
  return drive_to(setup, robot, -0.1 * unit(position(robot)), pace, pace);
}

// Returns the y, m, at which the bisector of the angle of the own goal, as seen from the ball,
// meets the goal line: the middle of the goal to cover.
inline double middle_of_goal_view(const Setup& setup, Point ball) {
  const double left = length(ball - Point{-setup.half_length, setup.goal_half_width});
  const double right = length(ball - Point{-setup.half_length, -setup.goal_half_width});
  return setup.goal_half_width * (right - left) / (right + left);
}

// Gets a stuck ball free: drives at it, and spins beside it, so that a corner of the robot throws
// it forward; before the opponents' goal, towards its middle.
inline Wheels free_ball(const Setup& setup, const Observation& now, const Robot& robot) {
  const Point to = ball(now) - position(robot);
  if (length(to) > 0.07) return drive_to(setup, robot, ball(now), 0.6, 1.2);
  Point way{1.0, 0.0};
  if (now.ball_x > 0.3 * setup.half_length) {
    way = Point{setup.half_length - 0.18, 0.0} - ball(now);
  } else if (now.ball_x < -setup.half_length + 0.06) {
    way = {0.3, now.ball_y < 0.0 ? -1.0 : 1.0};
  }
  const bool is_left = to.x * way.y - to.y * way.x > 0.0;
  return wheels_for(setup, 0.0, is_left ? 30.0 : -30.0);
}

// Drives along the goal line to a y, forwards or backwards, and looks along the line all the time:
// a keeper that turns away from it throws the ball into its goal. It brakes early by the way that
// it still rolls while its motors follow, because a keeper that runs past its place meets the ball
// with a side that turns it into the goal.
inline Wheels slide_to(const Setup& setup, const Robot& robot, double y, double fastest = 1.5) {
  const bool is_up = robot.heading > 0.0;
  const double error = wrapped((is_up ? pi / 2.0 : -pi / 2.0) - robot.heading);
  const double rolls_on = robot.vy * (setup.control_period + setup.motor_time_constant);  // m
  const double speed = std::clamp(12.0 * (y - robot.y - rolls_on), -fastest, fastest);
  const double forward = (is_up ? speed : -speed) * std::max(0.0, math::cos(2.0 * error));
  return wheels_for(setup, forward, 9.0 * error);
}

// Keeps the goal: stays in its mouth, where the ball will meet its face, and kicks away a slow ball
// in the goal area, not inwards. A ball that comes along the end wall then meets the middle of the
// keeper's face; farther out it would meet a corner, and turn the keeper aside.
inline Wheels keep_goal(const Setup& setup, const Observation& now, const Robot& robot) {
  const double line = -setup.half_length + 0.03;
  const Point here = position(robot);
  const Point away = ball(now) - here;

  const double outwards = now.ball_y < 0.0 ? -1.0 : 1.0;
  const bool is_slow = length(ball_velocity(now)) < 0.4;
  const bool is_in_reach = now.ball_x > here.x + 0.02 && length(away) < 0.16 &&
                           now.ball_x < -setup.half_length + setup.goal_area_depth + 0.02;
  const bool is_outer = away.x > 0.045 || outwards * away.y > -0.02;
  if (is_slow && is_in_reach && is_outer) {
    return drive_to(setup, robot, ball(now) + 0.2 * unit(away), 1.0);
  }
  // If the ball comes, the y is where it will meet the face that looks into the field; otherwise
  // the middle of the goal to cover. At the place where the ball would cross the goal line, the
  // keeper would meet a ball from the side with another face, and turn it into the goal.
  const double face = line + setup.robot_side / 2.0 + setup.ball_radius;
  double y = middle_of_goal_view(setup, ball(now));
  if (now.ball_vx < -0.1) {
    const double seconds = (face - now.ball_x) / now.ball_vx;
    if (seconds > 0.0 && seconds < 1.5) y = now.ball_y + now.ball_vy * seconds;
  }
  const double reach = setup.goal_half_width - 0.0385;
  const Point post{line, std::clamp(y, -reach, reach)};
  if (std::abs(post.x - here.x) < 0.04 && std::abs(here.y) < setup.goal_half_width + 0.05) {
    return slide_to(setup, robot, post.y, 1.8);
  }
  return drive_round(setup, robot, post, ball(now), 0.0, 1.5);
}

// Random numbers (splitmix64) that are the same whenever the same leg is played again.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  // Returns a number in [0, 1).
  double uniform() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
  }

 private:
  std::uint64_t state_;
};

// Returns the parameter of that name, or `fallback` if the leg gives the team no such parameter, or
// the host is older than parameters. See "Parameters" in strategy.h.
inline double parameter(const Setup& setup, const char* name, double fallback) {
  const bool is_there = setup.size >= offsetof(Setup, parameter) + sizeof setup.parameter;
  if (!is_there || setup.parameter == nullptr) return fallback;
  return setup.parameter(setup.host, name, fallback);
}

// These functions draw into the replay of `mirocup match --thoughts`; on older hosts they do
// nothing. `setup` is that of a Team. See "Thoughts" in strategy.h: own frame, m; colours are
// 0xRRGGBBAA; a layer can be switched off in the page. mirocup/skills/draw.hpp draws targets, roles
// and shots with them.
inline void draw_line(const Setup& setup, const char* layer, std::uint32_t colour, Point from,
                      Point to) {
  if (setup.draw_line == nullptr) return;
  setup.draw_line(setup.host, layer, colour, from.x, from.y, to.x, to.y);
}
inline void draw_circle(const Setup& setup, const char* layer, std::uint32_t colour, Point centre,
                        double radius) {
  if (setup.draw_circle == nullptr) return;
  setup.draw_circle(setup.host, layer, colour, centre.x, centre.y, radius);
}
inline void draw_polygon(const Setup& setup, const char* layer, std::uint32_t colour,
                         std::initializer_list<Point> corners) {
  static_assert(sizeof(Point) == 2 * sizeof(double));
  if (setup.draw_polygon == nullptr || corners.size() == 0) return;
  setup.draw_polygon(setup.host, layer, colour, &corners.begin()->x,
                     static_cast<std::int32_t>(corners.size()));
}
inline void draw_text(const Setup& setup, const char* layer, std::uint32_t colour, Point at,
                      const char* text) {
  if (setup.draw_text == nullptr) return;
  setup.draw_text(setup.host, layer, colour, at.x, at.y, text);
}

// Returns a copy of the setup, which ends after `size` bytes. Every host has the members up to
// `log`.
inline Setup copy_of(const Setup& setup) {
  Setup copy{};
  constexpr std::size_t least = offsetof(Setup, host);
  std::memcpy(&copy, &setup, std::clamp<std::size_t>(setup.size, least, sizeof copy));
  return copy;
}

// The base class of a team in C++. It keeps the setup and has random numbers from its seed.
class Team {
 public:
  explicit Team(const Setup& setup) : setup_(copy_of(setup)), random_(setup.seed) {}
  virtual ~Team() = default;

  // Sets the wheel speeds of this tick; they are 0 when it is called.
  virtual void decide(const Observation& now, Command& command) = 0;

  // Chooses the places of the robots at a restart, and of the ball at an own kick-off or goal kick.
  // strategy.h says which places are allowed. Bodies whose poses it does not change stay where they
  // are.
  virtual void place(const Observation& now, Placement& placement) {
    (void)now;
    (void)placement;
  }

 protected:
  const Setup& setup() const { return setup_; }
  Random& random() { return random_; }

  // Returns the parameter of that name, or `fallback` if the leg gives none. Read it when the team
  // is made, as a member: `const double wait_ = parameter("wait", 0.45);`
  double parameter(const char* name, double fallback) const {
    return strategy::parameter(setup_, name, fallback);
  }

  // Writes a line to the log of the leg. With values, the first argument is a format of printf(),
  // log("ball at %.2f", now.ball_x), which the compiler checks, and the line is cut after 255
  // bytes. Without values the text is written unchanged, percent signs included.
  void log(const char* text) const { setup_.log(text); }
  // This is a template only so that a call without values selects the overload above.
  template <int = 0>
  MIROCUP_PRINTF(2, 3)
  void log(const char* format, ...) const {
    char line[256];
    std::va_list values;
    va_start(values, format);
    std::vsnprintf(line, sizeof line, format, values);
    va_end(values);
    setup_.log(line);
  }

  // The drawing functions above, with the setup of this team.
  void draw_line(const char* layer, std::uint32_t colour, Point from, Point to) const {
    strategy::draw_line(setup_, layer, colour, from, to);
  }
  void draw_circle(const char* layer, std::uint32_t colour, Point centre, double radius) const {
    strategy::draw_circle(setup_, layer, colour, centre, radius);
  }
  void draw_polygon(const char* layer, std::uint32_t colour,
                    std::initializer_list<Point> corners) const {
    strategy::draw_polygon(setup_, layer, colour, corners);
  }
  void draw_text(const char* layer, std::uint32_t colour, Point at, const char* text) const {
    strategy::draw_text(setup_, layer, colour, at, text);
  }
  // The page shows a curve of the value over time. The name has at most 31 bytes.
  void draw_value(const char* name, double value) const {
    constexpr std::uint32_t invisible = 0;
    char text[64];
    std::snprintf(text, sizeof text, "%.31s = %.6g", name, value);
    draw_text("values", invisible, {0.0, 0.0}, text);
  }

 private:
  Setup setup_;
  Random random_;
};

}  // namespace mirocup::strategy

// Exports a class as the team of the library. Its constructor takes the setup.
#define MIROCUP_EXPORT_TEAM(Class, Name)                                               \
  extern "C" MIROCUP_PUBLIC const mirocup_strategy* mirocup_entry(void) {              \
    static const mirocup_strategy entry = {                                            \
        MIROCUP_ABI_VERSION,                                                           \
        sizeof(mirocup_strategy),                                                      \
        Name,                                                                          \
        [](const mirocup_setup* setup) -> void* { return new Class(*setup); },         \
        [](void* team, const mirocup_observation* now, mirocup_command* command) {     \
          static_cast<Class*>(team)->decide(*now, *command);                           \
        },                                                                             \
        [](void* team) { delete static_cast<Class*>(team); },                          \
        [](void* team, const mirocup_observation* now, mirocup_placement* placement) { \
          static_cast<Class*>(team)->place(*now, *placement);                          \
        }};                                                                            \
    return &entry;                                                                     \
  }
