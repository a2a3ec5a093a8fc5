// SPDX-License-Identifier: MIT
//
// Estimates the present and the next places of all bodies from the pictures of a camera. Under the
// conditions `camera` a team sees positions with noise, a tick late, and now and then not at all;
// velocities are differences of two such positions. A filter estimates positions and velocities
// better, since it remembers earlier pictures and the team's commands.
//
//   Filter::see    the scene at the moment when the answer to an observation will be driven
//   Filter::sent   tells the filter the answer to that observation
//
//   Filter filter_{setup()};
//   void decide(const Observation& seen, Command& command) override {
//     const Observation now = filter_.see(seen);
//     ...
//     filter_.sent(command);
//   }
//
// Each body has a Kalman filter: a prediction of its motion, which each new picture corrects. The
// more certain the prediction, the smaller the correction. The filter predicts own robots with the
// motors' law from the team's commands, opponents at constant speed and turn, the ball as in
// ball_path.hpp. If a picture is far from the prediction, the body has hit something, and its
// filter starts anew. A body that is not seen (`..._age_ticks`) is predicted from its last picture.
//
// Kalman, A New Approach to Linear Filtering and Prediction Problems, 1960. Frames and units are
// those of strategy.h. An observation without delay is exact, and is not filtered.
#pragma once

#include "mirocup/skills/ball_path.hpp"

#include <algorithm>

namespace mirocup::strategy {

// The filter's trust in its pictures and its predictions. Between pictures a velocity becomes less
// certain: its variance grows by `..._push` in a second (m^2/s^3). The variance of an angular
// velocity grows by `..._turn` (rad^2/s^3).
struct FilterSettings {
  double see_m = 0.0015;         // standard deviation of a position along x and y
  double see_rad = 0.017;        // standard deviation of a heading
  double ball_push = 0.002;      // m^2/s^3
  double own_push = 0.01;        // m^2/s^3: less than an opponent's, as own commands are known
  double opponent_push = 2.0;    // m^2/s^3
  double own_turn = 0.5;         // rad^2/s^3
  double opponent_turn = 200.0;  // rad^2/s^3
  double surprise = 5.0;         // standard deviations; a picture farther from prediction: a hit
};

// The uncertainty of a position and its velocity: the variances and the covariance of a Kalman
// filter, the same along x and y.
struct Uncertainty {
  double place = 0.0;  // m^2
  double both = 0.0;   // m^2/s
  double speed = 0.0;  // m^2/s^2

  // Returns the uncertainty after two pictures, if their difference gives the velocity.
  static Uncertainty of_two_pictures(double variance, double seconds) {
    return {variance, variance / seconds, 2.0 * variance / (seconds * seconds)};
  }
  void grow(double seconds, double push) {
    place += seconds * (2.0 * both + seconds * (speed + seconds * push / 3.0));
    both += seconds * (speed + seconds * push / 2.0);
    speed += seconds * push;
  }
  struct Gain {
    double place, speed;  // correction / (picture - predicted position); of `speed`: 1/s
  };
  // Reduces the uncertainty by a new picture.
  Gain shrink(double variance) {
    const Gain gain{place / (place + variance), both / (place + variance)};
    speed -= gain.speed * both;
    both *= 1.0 - gain.place;
    place *= 1.0 - gain.place;
    return gain;
  }
};

// Returns a robot after `seconds` in which its motors follow `wheels`, without slip.
inline Robot driven(const Setup& setup, Robot robot, Wheels wheels, double seconds) {
  const double tau = setup.motor_time_constant;
  // The part of the difference to the motors' target that is left after `seconds`.
  const double left = math::exp(-seconds / tau);
  const double forward = robot.vx * math::cos(robot.heading) + robot.vy * math::sin(robot.heading);
  const double aim = setup.wheel_radius * (wheels.right + wheels.left) / 2.0;
  const double aim_turn = setup.wheel_radius * (wheels.right - wheels.left) / setup.wheel_distance;
  const double way = aim * seconds + (forward - aim) * tau * (1.0 - left);
  const double angle = aim_turn * seconds + (robot.turn - aim_turn) * tau * (1.0 - left);
  const double middle = robot.heading + angle / 2.0;
  robot.x += way * math::cos(middle);
  robot.y += way * math::sin(middle);
  robot.heading = wrapped(robot.heading + angle);
  robot.turn = aim_turn + (robot.turn - aim_turn) * left;
  const double speed = aim + (forward - aim) * left;
  robot.vx = speed * math::cos(robot.heading);
  robot.vy = speed * math::sin(robot.heading);
  return robot;
}

// Returns a robot after `seconds` at constant forward speed and angular velocity.
inline Robot coasted(Robot robot, double seconds) {
  const double forward = robot.vx * math::cos(robot.heading) + robot.vy * math::sin(robot.heading);
  const double angle = robot.turn * seconds;
  const double middle = robot.heading + angle / 2.0;
  robot.x += forward * seconds * math::cos(middle);
  robot.y += forward * seconds * math::sin(middle);
  robot.heading = wrapped(robot.heading + angle);
  robot.vx = forward * math::cos(robot.heading);
  robot.vy = forward * math::sin(robot.heading);
  return robot;
}

class Filter {
 public:
  explicit Filter(const Setup& setup, const FilterSettings& settings = {})
      : setup_(setup), settings_(settings) {}

  // Returns the observation with all bodies at their places `ticks_ahead` ticks later: 1 is the
  // start of the tick in which the answer is driven, 0 is now. Call this once in every tick.
  Observation see(const Observation& seen, int ticks_ahead = 1) {
    Observation now = seen;
    const bool stands = seen.state != MIROCUP_PLAY;
    const bool is_new = stands || seen.tick != tick_ + 1;
    tick_ = seen.tick;
    if (stands) stood_ = tick_;
    see_ball(seen, seen.ball_age_ticks, is_new);
    const double ball_s = (seen.ball_age_ticks + ticks_ahead) * setup_.control_period;
    const MovingBall then = rolled(setup_, ball_.at, is_new ? 0.0 : ball_s);
    now.ball_x = then.at.x;
    now.ball_y = then.at.y;
    now.ball_vx = then.velocity.x;
    now.ball_vy = then.velocity.y;
    for (int i = 0; i < seen.robots; ++i) {
      see_robot(own_[i], stands ? at_rest(seen.own[i]) : seen.own[i], seen.own_age_ticks[i], is_new,
                i);
      see_robot(opponent_[i], stands ? at_rest(seen.opponent[i]) : seen.opponent[i],
                seen.opponent_age_ticks[i], is_new, -1);
      if (is_new) continue;
      now.own[i] = moved(own_[i], i, tick_ + static_cast<unsigned>(ticks_ahead));
      now.opponent[i] = moved(opponent_[i], -1, tick_ + static_cast<unsigned>(ticks_ahead));
    }
    return now;
  }

  // Remembers the answer to the last observation of see().
  void sent(const Command& command) { commands_[(tick_ + 1) % remembered] = {tick_ + 1, command}; }

 private:
  static constexpr unsigned remembered = 32;  // ticks

  struct Tracked {
    Robot at{};               // pose at the tick of the last picture
    std::uint32_t tick = 0;   // the tick of the last picture
    Uncertainty place, turn;  // `turn`: of the heading and the angular velocity, in rad
  };
  struct TrackedBall {
    MovingBall at;
    std::uint32_t tick = 0;
    Uncertainty place;
  };
  struct Sent {
    std::uint32_t tick = 0;  // the tick in which the command is driven; 0: no command
    Command command{};
  };

  void see_ball(const Observation& seen, int age, bool is_new) {
    const std::uint32_t pictured = tick_ - static_cast<std::uint32_t>(age);
    if (!is_new && age > 0 && pictured == ball_.tick) return;  // the same picture as before
    const double variance = settings_.see_m * settings_.see_m;
    const bool stands = seen.state != MIROCUP_PLAY;
    const MovingBall picture{strategy::ball(seen), stands ? Point{} : ball_velocity(seen)};
    const double seconds = (pictured - ball_.tick) * setup_.control_period;
    ball_.tick = pictured;
    if (!is_new && age > 0) {
      ball_.at = rolled(setup_, ball_.at, seconds);
      ball_.place.grow(seconds, settings_.ball_push);
      const Point off = picture.at - ball_.at.at;
      if (!is_surprise(dot(off, off), ball_.place.place + variance)) {
        const Uncertainty::Gain gain = ball_.place.shrink(variance);
        ball_.at.at = ball_.at.at + gain.place * off;
        ball_.at.velocity = ball_.at.velocity + gain.speed * off;
        return;
      }
    }
    ball_.at = picture;
    ball_.place = Uncertainty::of_two_pictures(variance, setup_.control_period);
  }

  void see_robot(Tracked& robot, const Robot& picture, int age, bool is_new, int own) {
    const std::uint32_t pictured = tick_ - static_cast<std::uint32_t>(age);
    if (!is_new && age > 0 && pictured == robot.tick) return;
    const double variance = settings_.see_m * settings_.see_m;
    const double turn_variance = settings_.see_rad * settings_.see_rad;
    const double seconds = (pictured - robot.tick) * setup_.control_period;
    if (!is_new && age > 0) {
      robot.at = moved(robot, own, pictured);
      robot.place.grow(seconds, own >= 0 ? settings_.own_push : settings_.opponent_push);
      robot.turn.grow(seconds, own >= 0 ? settings_.own_turn : settings_.opponent_turn);
      robot.tick = pictured;
      const Point off = position(picture) - position(robot.at);
      const double turned = wrapped(picture.heading - robot.at.heading);
      if (!is_surprise(dot(off, off), robot.place.place + variance) &&
          !is_surprise(turned * turned, robot.turn.place + turn_variance)) {
        correct(robot.at, off, turned, robot.place.shrink(variance),
                robot.turn.shrink(turn_variance));
        return;
      }
    }
    robot.tick = pictured;
    robot.at = picture;
    robot.place = Uncertainty::of_two_pictures(variance, setup_.control_period);
    robot.turn = Uncertainty::of_two_pictures(turn_variance, setup_.control_period);
  }

  static void correct(Robot& robot, Point off, double turned, Uncertainty::Gain place,
                      Uncertainty::Gain turn) {
    robot.x += place.place * off.x;
    robot.y += place.place * off.y;
    robot.vx += place.speed * off.x;
    robot.vy += place.speed * off.y;
    robot.heading = wrapped(robot.heading + turn.place * turned);
    robot.turn += turn.speed * turned;
  }

  bool is_surprise(double squared, double variance) const {
    return squared > settings_.surprise * settings_.surprise * variance;
  }

  // Returns the robot at a later tick. `own`: the number of an own robot, or -1 for an opponent.
  Robot moved(const Tracked& robot, int own, std::uint32_t until) const {
    Robot at = robot.at;
    for (std::uint32_t t = std::max(robot.tick, stood_ + 1); t < until; ++t) {
      const Sent& sent = commands_[t % remembered];
      const bool is_known = own >= 0 && sent.tick == t;
      at = is_known ? driven(setup_, at, clamped(sent.command.wheels[own]), setup_.control_period)
                    : coasted(at, setup_.control_period);
    }
    return at;
  }

  static Robot at_rest(Robot robot) {
    robot.vx = robot.vy = robot.turn = 0.0;
    return robot;
  }

  Wheels clamped(Wheels wheels) const {
    const double limit = setup_.wheel_speed_limit;
    return {math::clamp(wheels.left, -limit, limit), math::clamp(wheels.right, -limit, limit)};
  }

  Setup setup_;
  FilterSettings settings_;
  std::uint32_t tick_ = 0;
  std::uint32_t stood_ = 0;  // the last tick before the whistle
  TrackedBall ball_;
  Tracked own_[MIROCUP_MAX_ROBOTS];
  Tracked opponent_[MIROCUP_MAX_ROBOTS];
  Sent commands_[remembered];
};

}  // namespace mirocup::strategy
