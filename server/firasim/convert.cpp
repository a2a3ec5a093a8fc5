// SPDX-License-Identifier: MIT
#include "server/firasim/convert.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirocup::firasim {

namespace {

constexpr double degrees = 3.14159265358979323846 / 180.0;

// Faster than any wheel, and small enough for every product.
constexpr double most_rad_s = 1e6;

SeenRobot to_seen(const match::ObservedRobot& robot) {
  return {.x = robot.position.x(),
          .y = robot.position.y(),
          .orientation = robot.heading,
          .vx = robot.velocity.x(),
          .vy = robot.velocity.y(),
          .turn = robot.turn};
}

FieldSizes sizes_of(const field::Field& field) {
  const field::Area& area = field.penalty_area ? *field.penalty_area : field.goal_area;
  return {.width = 2.0 * field.half_width,
          .length = 2.0 * field.half_length,
          .goal_width = 2.0 * field.goal_half_width,
          .goal_depth = field.goal_depth,
          .center_radius = field.centre_circle_radius,
          .penalty_width = 2.0 * area.half_width,
          .penalty_depth = area.depth,
          .penalty_point = field.penalty_mark_x};
}

Foul foul_of(referee::Restart restart) {
  constexpr std::array fouls{Foul::STOP,         Foul::KICKOFF,   Foul::GOAL_KICK,
                             Foul::PENALTY_KICK, Foul::FREE_BALL, Foul::FREE_KICK};
  static_assert(fouls.size() == enum_names<referee::Restart>.size());
  return fouls[static_cast<std::size_t>(restart)];
}

int half_of(const referee::LegProgress& progress) {
  if (progress.phase == referee::Phase::EXTRA) return progress.is_second_extra_half ? 4 : 3;
  if (progress.phase == referee::Phase::SHOOT_OUT) return 5;
  return progress.phase == referee::Phase::FIRST_HALF ? 1 : 2;
}

// Quadrant 1 is at the upper right on the wire; the next ones follow counter-clockwise.
int quadrant_of(const Vec2& spot) {
  if (spot.y() >= 0.0) return spot.x() >= 0.0 ? 1 : 2;
  return spot.x() < 0.0 ? 3 : 4;
}

}  // namespace

Vision to_vision(const match::Leg& leg) {
  const int robots = leg.field().robots_per_team;
  const match::Observation seen = match::observe(leg.view(), Team::blue, robots);
  Vision vision;
  vision.step = static_cast<std::uint32_t>(std::nearbyint(seen.time * 1000.0));
  vision.ball_x = seen.ball.x();
  vision.ball_y = seen.ball.y();
  vision.ball_z = leg.setup().parameters.ball_radius;
  vision.ball_vx = seen.ball_velocity.x();
  vision.ball_vy = seen.ball_velocity.y();
  vision.robots_per_team = robots;
  for (int i = 0; i < robots; ++i) {
    vision.robots[index_of(Team::blue)][i] = to_seen(seen.own[i]);
    vision.robots[index_of(Team::yellow)][i] = to_seen(seen.opponent[i]);
  }
  vision.field = sizes_of(leg.field());
  vision.goals = {static_cast<std::uint32_t>(seen.own_score),
                  static_cast<std::uint32_t>(seen.opponent_score)};
  return vision;
}

simulator::WheelSpeeds to_wheels(double left, double right,
                                 const simulator::Parameters& parameters) {
  const double l = std::clamp(left, -most_rad_s, most_rad_s);
  const double r = std::clamp(right, -most_rad_s, most_rad_s);
  const double forward = wheel_radius * (l + r) / 2.0;  // m/s
  const double turn = wheel_radius * (r - l) / track;   // rad/s
  const double half_track = parameters.wheel_distance / 2.0;
  simulator::WheelSpeeds wheels{(forward - turn * half_track) / parameters.wheel_radius,
                                (forward + turn * half_track) / parameters.wheel_radius};
  const double most = std::max(std::abs(wheels.left), std::abs(wheels.right));
  if (most <= parameters.wheel_speed_limit) return wheels;
  wheels.left *= parameters.wheel_speed_limit / most;
  wheels.right *= parameters.wheel_speed_limit / most;
  // Rounding must not make it a command that is out of range.
  wheels.left =
      std::clamp(wheels.left, -parameters.wheel_speed_limit, parameters.wheel_speed_limit);
  wheels.right =
      std::clamp(wheels.right, -parameters.wheel_speed_limit, parameters.wheel_speed_limit);
  return wheels;
}

match::PlacementRequest to_request(const TeamPlacement& placement,
                                   const match::Observation& observation) {
  match::PlacementRequest request = match::unchanged_request(observation);
  const End wire_end = placement.team == Team::blue ? End::left : End::right;
  for (const PlacedRobot& robot : placement.robots) {
    if (robot.id >= static_cast<std::uint32_t>(observation.robots)) continue;
    const Vec2 position = team_frame(wire_end, Vec2{robot.x, robot.y});
    const double turned = placement.team == Team::blue ? 0.0 : 180.0;
    request.robots[robot.id] = {position.x(), position.y(), (robot.orientation + turned) * degrees};
  }
  return request;
}

RefereeCommand to_command(const match::Leg& leg, const match::LoggedDecision& restart) {
  RefereeCommand command = to_command(leg, foul_of(restart.decision.restart));
  if (restart.decision.restart == referee::Restart::FREE_BALL) {
    command.quadrant = quadrant_of(team_frame(leg.end_of(Team::blue), restart.decision.spot));
  } else if (restart.decision.restart != referee::Restart::none) {
    command.colour = restart.taker == Team::blue ? Colour::BLUE : Colour::YELLOW;
  }
  return command;
}

RefereeCommand to_command(const match::Leg& leg, Foul foul) {
  return {.foul = foul,
          .colour = Colour::NONE,
          .quadrant = 0,
          .timestamp = leg.referee().clock(),
          .half = half_of(leg.referee().progress())};
}

}  // namespace mirocup::firasim
