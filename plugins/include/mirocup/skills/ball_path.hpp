// SPDX-License-Identifier: MIT
//
// The path of the ball if no robot touches it: the ball brakes along its path and rebounds from
// walls and corners. The speed between two walls has a closed form, so a path costs some ten square
// roots.
//
// A path answers frequent questions about the ball alone. For a ball that meets robots use the
// Simulator of predict.hpp. If the ball meets no robot, path and Simulator agree to 1e-6 m.
//
//   rolled       the ball after some seconds
//   BallPath     the ball at many times, for a team that asks often: finds each wall only once
//   time_at_x    when and where the ball reaches a line across the field
//
// The goals are open: a ball that passes between the posts rolls on to the wall behind them. Posts
// count as points of the end wall. Frames and units are those of strategy.h.
#pragma once

#include "mirocup/strategy.hpp"

namespace mirocup::strategy {

// The floor and the walls of a match: ds/dt = -constant - linear * s for the speed s.
struct Rolling {
  double constant;  // m/s^2
  double linear;    // 1/s
  double bounce;    // part of the speed towards a wall that a rebound keeps
};

inline Rolling rolling_of(const Setup& setup) {
  // The formulas below divide by both constants, so neither may be 0.
  constexpr double least = 1e-5;
  return {math::max(setup.rolling_resistance * 9.81 / 1.4, least),
          math::max(setup.viscous_friction / (1.4 * setup.ball_mass), least),
          setup.ball_wall_restitution};
}

// A moving ball.
struct MovingBall {
  Point at;        // m
  Point velocity;  // m/s
};

inline MovingBall moving_ball(const Observation& now) {
  return {ball(now), ball_velocity(now)};
}

// Returns how far a ball of speed `speed` (m/s) rolls in `seconds`, m.
inline double rolled_distance(const Rolling& floor, double speed, double seconds) {
  const double top = speed + floor.constant / floor.linear;
  return (top * (1.0 - math::exp(-floor.linear * seconds)) - floor.constant * seconds) /
         floor.linear;
}

// Returns the seconds in which a ball of speed `speed` (m/s) comes to rest.
inline double rolling_time(const Rolling& floor, double speed) {
  return math::log1p(floor.linear * speed / floor.constant) / floor.linear;
}

// A wall that a ball will meet.
struct WallAhead {
  Point normal;     // of length 1, into the field
  double distance;  // m, along the path of the ball's middle
};

// Returns the first wall on a straight path from `at` along `along` (of length 1).
inline WallAhead wall_ahead(const Setup& setup, Point at, Point along) {
  WallAhead first{{0.0, 0.0}, 1e9};
  const auto meet = [&](Point normal, double offset, bool has_goal) {
    const double closing = -dot(along, normal);
    if (closing <= 1e-12) return;
    const double distance =
        math::max(0.0, (dot(at, normal) - offset - setup.ball_radius) / closing);
    if (distance >= first.distance) return;
    if (has_goal && std::abs(at.y + distance * along.y) < setup.goal_half_width) return;
    first = {normal, distance};
  };
  meet({0.0, 1.0}, -setup.half_width, false);
  meet({0.0, -1.0}, -setup.half_width, false);
  for (const double side : {1.0, -1.0}) {
    meet({side, 0.0}, -setup.half_length, true);
    meet({side, 0.0}, -setup.half_length - setup.goal_depth, false);
  }
  const double k = std::sqrt(0.5);
  const double corner = -k * (setup.half_length + setup.half_width - setup.corner_leg);
  // Behind the goal line the corners are not walls.
  if (std::abs(at.x) < setup.half_length) {
    for (const Point normal : {Point{k, k}, Point{k, -k}, Point{-k, k}, Point{-k, -k}}) {
      meet(normal, corner, false);
    }
  }
  return first;
}

// Returns the ball after `seconds` on a floor. The ball stays where it rebounds the eighth time.
inline MovingBall rolled(const Setup& setup, MovingBall ball, double seconds,
                         const Rolling& floor) {
  for (int rebounds = 0; rebounds < 8; ++rebounds) {
    const double speed = length(ball.velocity);
    if (speed < 1e-6 || seconds <= 0.0) return ball;
    const Point along = unit(ball.velocity);
    const double rest_time = rolling_time(floor, speed);
    const double time = math::min(seconds, rest_time);
    const WallAhead wall = wall_ahead(setup, ball.at, along);
    const double top = speed + floor.constant / floor.linear;
    const auto speed_after = [&](double t) {
      return math::max(0.0, top * math::exp(-floor.linear * t) - floor.constant / floor.linear);
    };
    if (rolled_distance(floor, speed, time) < wall.distance) {
      ball.at = ball.at + rolled_distance(floor, speed, time) * along;
      ball.velocity = speed_after(time) * along;
      return ball;
    }
    // Newton's method from below; it does not overshoot, because the distance is concave in time.
    double t = wall.distance / speed;
    for (int i = 0; i < 4; ++i) {
      t += (wall.distance - rolled_distance(floor, speed, t)) / math::max(speed_after(t), 1e-3);
    }
    t = math::min(t, time);
    ball.at = ball.at + wall.distance * along;
    ball.velocity = speed_after(t) * along;
    const double towards = dot(ball.velocity, wall.normal);
    ball.velocity = ball.velocity - ((1.0 + floor.bounce) * towards) * wall.normal;
    seconds -= t;
  }
  return ball;
}

// Returns the ball after `seconds` on the floor of this leg.
inline MovingBall rolled(const Setup& setup, const MovingBall& ball, double seconds) {
  return rolled(setup, ball, seconds, rolling_of(setup));
}

// The path of a ball, up to its sixth wall.
class BallPath {
 public:
  BallPath(const Setup& setup, const MovingBall& ball) : BallPath(setup, ball, rolling_of(setup)) {}
  BallPath(const Setup& setup, MovingBall ball, const Rolling& floor) : floor_(floor) {
    double begin = 0.0;
    for (Piece& piece : pieces_) {
      const double speed = length(ball.velocity);
      piece = {begin, ball.at, unit(ball.velocity), speed, speed < 1e-6 ? 0.0 : 1e9};
      ++count_;
      if (speed < 1e-6) return;
      const WallAhead wall = wall_ahead(setup, ball.at, piece.along);
      const double rest = rolling_time(floor, speed);
      if (count_ == most_pieces || rolled_distance(floor, speed, rest) < wall.distance) {
        piece.most = rest;
        return;
      }
      double t = wall.distance / speed;
      for (int i = 0; i < 3; ++i) {
        const double error = wall.distance - rolled_distance(floor, speed, t);
        t += error / math::max(speed_after(speed, t), 1e-3);
      }
      piece.most = math::min(t, rest);
      const double there = speed_after(speed, piece.most);
      const double towards = there * dot(piece.along, wall.normal);
      ball.at = ball.at + wall.distance * piece.along;
      ball.velocity = there * piece.along - ((1.0 + floor.bounce) * towards) * wall.normal;
      begin += piece.most;
    }
  }

  // Returns the ball after `seconds`.
  MovingBall after(double seconds) const {
    int i = 0;
    while (i + 1 < count_ && pieces_[i + 1].begin <= seconds) ++i;
    const Piece& piece = pieces_[i];
    const double t = math::min(seconds - piece.begin, piece.most);
    return {piece.at + rolled_distance(floor_, piece.speed, t) * piece.along,
            speed_after(piece.speed, t) * piece.along};
  }

 private:
  struct Piece {         // from one wall to the next
    double begin = 0.0;  // s
    Point at;
    Point along;
    double speed = 0.0;
    double most = 0.0;  // s: after this time the ball is at the next wall or at rest
  };

  double speed_after(double speed, double t) const {
    const double top = speed + floor_.constant / floor_.linear;
    return math::max(0.0, top * math::exp(-floor_.linear * t) - floor_.constant / floor_.linear);
  }

  Rolling floor_;
  static constexpr int most_pieces = 6;
  Piece pieces_[most_pieces];
  int count_ = 0;
};

// The point at which the ball crosses a line across the field.
struct Crossing {
  bool is_ahead = false;  // false: the ball does not cross the line within `most_s`
  double seconds = 0.0;
  double y = 0.0;  // m
};

// Returns the point at which the ball, coming from greater x, first reaches the line x = `x` within
// `most_s` seconds.
inline Crossing time_at_x(const Setup& setup, const MovingBall& from, double x,
                          double most_s = 1.5) {
  const double step = 1.0 / 30.0;  // s
  MovingBall before = from;
  if (before.at.x <= x) return {};
  for (double t = step; t <= most_s; t += step) {
    const MovingBall after = rolled(setup, before, step);
    if (after.at.x <= x) {
      const double part = (before.at.x - x) / (before.at.x - after.at.x);
      return {true, t - step + part * step, before.at.y + part * (after.at.y - before.at.y)};
    }
    before = after;
  }
  return {};
}

}  // namespace mirocup::strategy
