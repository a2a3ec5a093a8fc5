// SPDX-License-Identifier: MIT
#include "core/referee/placement_rules.hpp"

#include "core/field/coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirocup::referee {

namespace {

constexpr double tolerance = 1e-6;       // m, of every comparison
constexpr double line_tolerance = 2e-3;  // m, for "touches the line"
constexpr double mark_tolerance = 0.01;  // m, for "stands on the mark"

// Returns how far the body reaches from its centre along x and along y, m.
double reach_of(const JudgedField& pitch, const Pose& robot) {
  return pitch.robot_side / 2.0 * (std::abs(robot.heading.cos) + std::abs(robot.heading.sin));
}

// Returns the position in the team's frame.
Vec2 seen(End team, const Pose& robot) {
  return team_frame(team, robot.position);
}

bool in_own_half(const JudgedField& pitch, End team, const Pose& robot) {
  return seen(team, robot).x() + reach_of(pitch, robot) <= tolerance;
}

std::array<Vec2, 4> corners(const JudgedField& pitch, const Pose& robot) {
  const double h = pitch.robot_side / 2.0;
  return {robot.position + robot.heading.to_world({h, h}),
          robot.position + robot.heading.to_world({-h, h}),
          robot.position + robot.heading.to_world({-h, -h}),
          robot.position + robot.heading.to_world({h, -h})};
}

bool in_own_half_or_circle(const JudgedField& pitch, End team, const Pose& robot) {
  const double radius = pitch.field.centre_circle_radius + tolerance;
  const auto allowed = [&](const Vec2& p) {
    return team_frame(team, p).x() <= tolerance || p.squaredNorm() <= radius * radius;
  };
  const auto all = corners(pitch, robot);
  return std::all_of(all.begin(), all.end(), allowed);
}

// Tests the point of the robot that is nearest to the centre of the field.
bool outside_circle(const JudgedField& pitch, const Pose& robot) {
  const double h = pitch.robot_side / 2.0;
  const Vec2 centre = robot.heading.to_body(-robot.position);
  const Vec2 nearest{std::clamp(centre.x(), -h, h), std::clamp(centre.y(), -h, h)};
  const double radius = pitch.field.centre_circle_radius - tolerance;
  return (centre - nearest).squaredNorm() >= radius * radius;
}

bool outside_area(const JudgedField& pitch, End owner, const Pose& robot) {
  const field::Field& field = pitch.field;
  const field::Area& area = field.penalty_area ? *field.penalty_area : field.goal_area;
  return field::covered_part(field, area, owner, robot, pitch.robot_side) <= tolerance;
}

bool in_goal_area(const JudgedField& pitch, End owner, const Pose& robot) {
  const field::Field& field = pitch.field;
  return field::covered_part(field, field.goal_area, owner, robot, pitch.robot_side) > 0.5;
}

bool outside_quarter(const JudgedField& pitch, const Vec2& mark, const Pose& robot) {
  const Quarter q = quarter_of(mark);
  const double reach = reach_of(pitch, robot) - tolerance;
  return q.x * robot.position.x() <= -reach || q.y * robot.position.y() <= -reach;
}

bool near(const Pose& robot, const Pose& place) {
  return (robot.position - place.position).squaredNorm() <= mark_tolerance * mark_tolerance;
}

bool on_goal_line(const JudgedField& pitch, End team, const Pose& robot) {
  const Vec2 p = seen(team, robot);
  const double gap = p.x() - reach_of(pitch, robot) + pitch.field.half_length;
  return std::abs(gap) <= line_tolerance && std::abs(p.y()) <= pitch.field.goal_half_width;
}

bool behind_ball(const PlacementRules& rules, End team, const Pose& robot) {
  return seen(team, robot).x() + reach_of(rules.pitch, robot) <= team_frame(team, rules.ball).x();
}

// True if the robot stands on one of the default places of the team's wall at a free kick, no
// matter which robot's place it is.
bool on_wall_mark(const PlacementRules& rules, End team, const Pose& robot) {
  for (int i = 0; i < rules.pitch.field.robots_per_team; ++i) {
    if (i != keeper && near(robot, rules.defaults.robots[index_of(team)][i])) return true;
  }
  return false;
}

}  // namespace

bool is_inside_walls(const JudgedField& pitch, const Pose& robot) {
  if (!std::isfinite(robot.position.x()) || !std::isfinite(robot.position.y())) return false;
  if (!std::isfinite(robot.heading.cos) || !std::isfinite(robot.heading.sin)) return false;
  if (pitch.field.clearance(robot.position) < pitch.robot_side / 2.0 - tolerance) return false;
  const auto all = corners(pitch, robot);
  return std::all_of(all.begin(), all.end(), [&](const Vec2& corner) {
    return pitch.field.clearance(corner) >= -tolerance;
  });
}

bool may_stand(const PlacementRules& rules, End team, const Pose& robot) {
  const bool takes = team == rules.taker;
  switch (rules.restart) {
    case Restart::none:
      return true;
    case Restart::KICK_OFF:
      return takes ? in_own_half_or_circle(rules.pitch, team, robot)
                   : in_own_half(rules.pitch, team, robot) && outside_circle(rules.pitch, robot);
    case Restart::PENALTY_KICK:
      return in_own_half(rules.pitch, rules.taker, robot);
    case Restart::GOAL_KICK:
      return takes ? outside_area(rules.pitch, team, robot) : in_own_half(rules.pitch, team, robot);
    case Restart::FREE_KICK:
      return takes ? in_own_half(rules.pitch, team, robot) : on_wall_mark(rules, team, robot);
    case Restart::FREE_BALL:
      return outside_quarter(rules.pitch, rules.ball, robot);
  }
  return false;
}

bool has_special_place(const PlacementRules& rules, End team, const Pose& robot) {
  const bool takes = team == rules.taker;
  switch (rules.restart) {
    case Restart::none:
    case Restart::KICK_OFF:
      return false;
    case Restart::PENALTY_KICK:
      if (takes) return behind_ball(rules, team, robot) && !in_own_half(rules.pitch, team, robot);
      return on_goal_line(rules.pitch, team, robot) ||
             (rules.roles == Roles::fixed && in_goal_area(rules.pitch, team, robot));
    case Restart::GOAL_KICK:
      return takes && in_goal_area(rules.pitch, team, robot);
    case Restart::FREE_KICK:
      return takes ? behind_ball(rules, team, robot) && !in_own_half(rules.pitch, team, robot)
                   : in_goal_area(rules.pitch, team, robot);
    case Restart::FREE_BALL:
      return near(robot, rules.defaults.robots[index_of(team)][kicker]);
  }
  return false;
}

int holder_of_special_place(const PlacementRules& rules, End team) {
  const bool takes = team == rules.taker;
  switch (rules.restart) {
    case Restart::none:
    case Restart::KICK_OFF:
      return -1;
    case Restart::PENALTY_KICK:
    case Restart::FREE_KICK:
      return takes ? kicker : keeper;
    case Restart::GOAL_KICK:
      return takes ? keeper : -1;
    case Restart::FREE_BALL:
      return kicker;
  }
  return -1;
}

}  // namespace mirocup::referee
