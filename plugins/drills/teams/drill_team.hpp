// SPDX-License-Identifier: MIT
//
// The common functions of the drill teams: copies of the driving, the laws and the goalkeeping of
// strategy.hpp and skills/shoot.hpp from the time at which the drills were measured. With copies, a
// better skill makes no drill harder. docs/drills.md ("The opponents") says when the copies may
// change. Points, angles, wheel speeds and random numbers are those of strategy.hpp:
// they never change.
//
// Frames and units are those of strategy.h. The drill teams know only the laws of the small league.
#pragma once

#include "mirocup/strategy.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::drill_teams {

using namespace strategy;

inline double cross(Point a, Point b) {
  return a.x * b.y - a.y * b.x;
}
inline Point nose(const Robot& robot) {
  return {mirocup_cos(robot.heading), mirocup_sin(robot.heading)};
}

// A drill team: robot 0 keeps the goal, and steer() drives each of the other robots. `now` is the
// observation of the tick.
class DrillTeam : public Team {
 public:
  using Team::Team;

  void decide(const Observation& observation, Command& command) override {
    now = &observation;
    ball = {now->ball_x, now->ball_y};
    velocity = {now->ball_vx, now->ball_vy};
    command.wheels[0] = keep_goal(now->own[0]);
    before_steering();
    for (int i = 1; i < now->robots; ++i) command.wheels[i] = steer(i, now->own[i]);
    avoid_own_goals(command);
    for (int i = 1; i < now->robots; ++i) {
      command.wheels[i] = without_pushing(now->own[i], command.wheels[i]);
      command.wheels[i] = out_of_area(now->own[i], command.wheels[i]);
    }
    after_laws(command);
  }

 protected:
  virtual void before_steering() {}
  virtual Wheels steer(int i, const Robot& robot) = 0;
  virtual void after_laws(Command& command) { (void)command; }

  // Returns the wheel speeds for a forward speed (m/s) and an angular velocity (rad/s).
  Wheels wheels_for(double forward, double turn) const {
    return strategy::wheels_for(setup(), forward, turn);
  }
  double forward_of(Wheels wheels) const {
    return setup().wheel_radius * (wheels.left + wheels.right) / 2.0;
  }
  double turn_of(Wheels wheels) const {
    return setup().wheel_radius * (wheels.right - wheels.left) / setup().wheel_distance;
  }

  // Drives to a point at no more than `fastest` m/s, and passes it at `arrival` m/s.
  Wheels drive_to(const Robot& robot, Point target, double arrival = 0.0,
                  double fastest = 1.5) const {
    const Point to = target - position(robot);
    const double distance = length(to);
    if (distance < 0.005 && arrival == 0.0) return {0.0, 0.0};
    double error = wrapped(mirocup_atan2(to.y, to.x) - robot.heading);
    double direction = 1.0;
    if (std::abs(error) > pi / 2.0) {
      error = wrapped(error + pi);
      direction = -1.0;
    }
    const double wanted = std::min(fastest, arrival + 5.0 * distance);
    const double turn = 9.0 * error;
    return steady(direction, wanted * std::max(0.0, mirocup_cos(error)), turn);
  }

  // Slows the robot down so that its wheels grip, because sliding wheels do not steer.
  Wheels steady(double direction, double speed, double turn) const {
    const double most = 0.8 * setup().grip * 9.81;
    if (std::abs(speed * turn) > most) speed = most / std::abs(turn);
    return wheels_for(direction * speed, turn);
  }

  // Drives to a point, round an obstacle on the line to the point.
  Wheels drive_round(const Robot& robot, Point target, Point obstacle, double arrival,
                     double fastest) const {
    const double berth = 0.11;
    const Point here = position(robot);
    const Point path = target - here;
    const Point to = obstacle - here;
    const Point along = unit(path);
    const double ahead = dot(to, along);
    const double aside = cross(along, to);
    if (ahead <= 0.0 || ahead >= length(path) || std::abs(aside) >= berth) {
      return drive_to(robot, target, arrival, fastest);
    }
    if (length(to) < 0.115) return drive_to(robot, here - 0.1 * unit(to), 0.0, fastest);
    const double side = aside > 0.0 ? -1.0 : 1.0;
    const Point beside = obstacle + (side * berth * 1.2) * Point{-along.y, along.x};
    return drive_to(robot, beside, 0.3, std::min(fastest, 0.9));
  }

  // Drives to a point round the ball or an opponent, and stands square at the point.
  Wheels drive_clear(const Robot& robot, Point target, double arrival = 0.0,
                     double fastest = 1.5) const {
    const Point here = position(robot);
    if (arrival == 0.0 && length(target - here) < 0.03) {
      return wheels_for(0.0, 8.0 * wrapped(squared(robot.heading) - robot.heading));
    }
    Point obstacle = ball;
    for (int j = 0; j < now->robots; ++j) {
      const Point to = position(now->opponent[j]) - here;
      if (length(to) < 0.2 && length(to) < length(obstacle - here) &&
          dot(to, target - here) > 0.0) {
        obstacle = position(now->opponent[j]);
      }
    }
    return drive_round(robot, target, obstacle, arrival, fastest);
  }

  Point inside(Point p, double margin = 0.045) const {
    return {std::clamp(p.x, -setup().half_length + margin, setup().half_length - margin),
            std::clamp(p.y, -setup().half_width + margin, setup().half_width - margin)};
  }

  // Returns the place where a robot that drives at 1.2 m/s meets the ball.
  Point meeting_point(const Robot& robot) const {
    Point p = ball;
    for (int i = 0; i < 3; ++i) {
      const double s = std::min(length(p - position(robot)) / 1.2, 0.8);
      p = ball + (s * (1.0 - 0.1 * s)) * velocity;
    }
    return inside(p, setup().ball_radius);
  }

  // Returns the target `p` of a robot that is not the keeper, moved out of the own goal area.
  Point keep_out(Point p) const {
    const double front = -setup().half_length + setup().goal_area_depth + 0.095;
    if (p.x < front && std::abs(p.y) < setup().goal_area_half_width + 0.095) p.x = front;
    return p;
  }

  // Returns the place `p`, moved aside if the own keeper may clear the ball against a robot there.
  Point make_way(Point p) const {
    const bool is_in_front = ball.x < -setup().half_length + setup().goal_area_depth + 0.15 &&
                             p.x > ball.x + 0.02 && p.x < ball.x + 0.5;
    if (!is_in_front) return p;
    const double aside = setup().goal_half_width + 0.1;
    p.y = p.y < 0.0 ? std::min(p.y, -aside) : std::max(p.y, aside);
    return p;
  }

  bool is_stuck(double patience = 0.6) const {
    return now->stalemate_s > patience && length(velocity) < 0.15;
  }

  // Spins beside a stuck ball, so that the ball gets free.
  Wheels free_ball(const Robot& robot) const {
    const Point to = ball - position(robot);
    if (length(to) > 0.07) return drive_to(robot, ball, 0.6, 1.2);
    Point way{1.0, 0.0};
    if (ball.x > 0.3 * setup().half_length) {
      way = Point{setup().half_length - 0.18, 0.0} - ball;
    } else if (ball.x < -setup().half_length + 0.06) {
      way = {0.3, ball.y < 0.0 ? -1.0 : 1.0};
    }
    return wheels_for(0.0, cross(to, way) > 0.0 ? 30.0 : -30.0);
  }

  // True if the ball is on the spot of an own kick-off. Then kick_off() rolls it backwards.
  bool must_kick_off() const {
    return now->restart == MIROCUP_KICK_OFF && now->own_restart != 0 &&
           mirocup_hypot(ball.x, ball.y) < 0.055;
  }
  Wheels kick_off(const Robot& robot) const {
    const double pace = length(position(robot)) > 0.1 ? 0.8 : 0.28;  // m/s
    return drive_to(robot, -0.1 * unit(position(robot)), pace, pace);
  }

  const Observation* now = nullptr;
  Point ball;      // m
  Point velocity;  // of the ball, m/s

 private:
  // Keeps the goal: stays in its mouth, where the ball will come, and clears a slow ball.
  Wheels keep_goal(const Robot& robot) const {
    const double line = -setup().half_length + 0.03;
    const Point here = position(robot);
    const Point away = ball - here;
    const double outwards = ball.y < 0.0 ? -1.0 : 1.0;
    const bool is_in_reach = ball.x > here.x + 0.02 && length(away) < 0.16 &&
                             ball.x < -setup().half_length + setup().goal_area_depth + 0.02;
    const bool is_outer = away.x > 0.045 || outwards * away.y > -0.02;
    if (length(velocity) < 0.4 && is_in_reach && is_outer) {
      return drive_to(robot, ball + 0.2 * unit(away), 1.0);
    }
    const double face = line + setup().robot_side / 2.0 + setup().ball_radius;
    const double left = length(ball - Point{-setup().half_length, setup().goal_half_width});
    const double right = length(ball - Point{-setup().half_length, -setup().goal_half_width});
    double y = setup().goal_half_width * (right - left) / (right + left);
    if (velocity.x < -0.1) {
      const double seconds = (face - ball.x) / velocity.x;
      if (seconds > 0.0 && seconds < 1.5) y = ball.y + velocity.y * seconds;
    }
    const double reach = setup().goal_half_width - 0.0385;
    const Point post{line, std::clamp(y, -reach, reach)};
    if (std::abs(post.x - here.x) < 0.04 && std::abs(here.y) < setup().goal_half_width + 0.05) {
      return slide_to(robot, post.y, 1.8);
    }
    return drive_round(robot, post, ball, 0.0, 1.5);
  }

  Wheels slide_to(const Robot& robot, double y, double fastest) const {
    const bool is_up = robot.heading > 0.0;
    const double error = wrapped((is_up ? pi / 2.0 : -pi / 2.0) - robot.heading);
    const double rolls_on = robot.vy * (setup().control_period + setup().motor_time_constant);  // m
    const double speed = std::clamp(12.0 * (y - robot.y - rolls_on), -fastest, fastest);
    const double forward = (is_up ? speed : -speed) * std::max(0.0, mirocup_cos(2.0 * error));
    return wheels_for(forward, 9.0 * error);
  }

  // Returns `wheels`, slower if the robot would push an opponent without playing the ball.
  Wheels without_pushing(const Robot& robot, Wheels wheels) const {
    const Point here = position(robot);
    const double forward = forward_of(wheels);
    const Point direction = (forward < 0.0 ? -1.0 : 1.0) * nose(robot);
    const Point to_ball = ball - here;
    if (length(to_ball) < 0.09) return wheels;
    const bool ball_ahead =
        dot(to_ball, direction) > 0.0 && std::abs(cross(to_ball, direction)) < 0.055;
    double allowed = std::abs(forward);
    for (int j = 0; j < now->robots; ++j) {
      const Point to = position(now->opponent[j]) - here;
      if (dot(to, direction) <= 0.0 || std::abs(cross(to, direction)) > 0.09) continue;
      const double nearer = is_stuck(1.0) && length(to_ball) < 0.2 ? 0.04 : 0.0;
      if (ball_ahead && dot(to_ball, direction) < dot(to, direction) + nearer) continue;
      const double gap = length(to) - 0.1;
      allowed = std::min(allowed, gap > 0.0 ? 0.1 + 4.0 * gap : -0.2);
    }
    if (allowed == std::abs(forward)) return wheels;
    return wheels_for(forward < 0.0 ? -allowed : allowed, turn_of(wheels));
  }

  // Returns `wheels` or, in and near the own goal area, speeds for the shortest way out.
  Wheels out_of_area(const Robot& robot, Wheels wheels) const {
    const double arc = std::abs(robot.y) < setup().goal_area_half_width / 2.0 ? 0.05 : 0.0;
    const double front = -setup().half_length + setup().goal_area_depth + arc + 0.04;
    const double side = setup().goal_area_half_width + 0.04;
    const double soon_x = robot.x + 0.1 * robot.vx;
    const double soon_y = robot.y + 0.1 * robot.vy;
    if (soon_x > front || std::abs(soon_y) > side) return wheels;
    const bool is_near_front = front - robot.x < side - std::abs(robot.y);
    const double beside = robot.y > 0.0 ? side + 0.1 : -side - 0.1;
    return drive_to(robot, is_near_front ? Point{front + 0.1, robot.y} : Point{robot.x, beside});
  }

  bool rolls_into_own_goal(Point from, Point rolling, double margin) const {
    if (rolling.x > -0.05) return false;
    const double seconds = (-setup().half_length - from.x) / rolling.x;
    return std::abs(from.y + seconds * rolling.y) < setup().goal_half_width + margin;
  }

  bool would_turn_ball_in(const Robot& robot) const {
    const Point coming = velocity - Point{robot.vx, robot.vy};
    const Point along = unit(coming);
    const Point to = position(robot) - ball;
    const double ahead = dot(to, along);
    if (ahead < 0.0 || ahead > 0.4 * length(coming) + 0.06) return false;
    if (std::abs(cross(along, to)) > 0.08) return false;
    for (int face = 0; face < 4; ++face) {
      const double heading = robot.heading + face * pi / 2.0;
      const Point normal{mirocup_cos(heading), mirocup_sin(heading)};
      const double closing = -dot(coming, normal);
      if (closing < 0.2 * length(coming)) continue;
      const Point off = velocity + (1.4 * closing) * normal;
      if (rolls_into_own_goal(position(robot) + 0.06 * normal, off, 0.05)) return true;
    }
    return false;
  }

  // If the ball would rebound from a robot into the own goal, turns the robot square or moves it.
  void avoid_own_goals(Command& command) const {
    if (ball.x > 0.0 || length(velocity) < 0.25) return;
    if (rolls_into_own_goal(ball, velocity, -0.02)) return;
    for (int i = 1; i < now->robots; ++i) {
      const Robot& robot = now->own[i];
      if (!would_turn_ball_in(robot)) continue;
      const double error = squared(robot.heading) - robot.heading;
      if (std::abs(error) > 0.15) {
        const double turns_on = robot.turn * (setup().control_period + setup().motor_time_constant);
        command.wheels[i] = wheels_for(0.0, 16.0 * (error - turns_on));
      } else {
        const Point along = unit(velocity);
        const Point to = position(robot) - ball;
        const Point aside = unit(to - dot(to, along) * along);
        const double way = dot(nose(robot), aside + 0.7 * along) < 0.0 ? -1.0 : 1.0;
        command.wheels[i] = wheels_for(way * 1.5, 9.0 * error);
      }
    }
  }
};

}  // namespace mirocup::drill_teams
