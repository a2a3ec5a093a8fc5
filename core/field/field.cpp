// SPDX-License-Identifier: MIT
#include "core/field/field.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::field {

namespace {

// Radius of the circle through the ends of a chord with the given height over it.
double radius_of_arc(double chord, double height) {
  return (chord * chord / 4.0 + height * height) / (2.0 * height);
}

void add_arc(Area& area, double half_length, double chord, double height) {
  area.arc_radius = radius_of_arc(chord, height);
  area.arc_centre = half_length - (area.depth + height - area.arc_radius);
}

Field dimensions(League league) {
  Field f;
  f.league = league;
  f.corner_leg = 0.07;
  switch (league) {
    case League::small:
      f.robots_per_team = 3;
      f.half_length = 0.75;
      f.half_width = 0.65;
      f.goal_half_width = 0.20;
      f.goal_depth = 0.10;
      f.centre_circle_radius = 0.20;
      f.goal_area = {.depth = 0.15, .half_width = 0.35};
      add_arc(f.goal_area, f.half_length, 0.20, 0.05);
      f.penalty_mark_x = 0.375;
      f.free_ball_mark = {0.375, 0.40};
      f.free_ball_offset = 0.20;
      break;
    case League::middle:
      f.robots_per_team = 5;
      f.half_length = 1.10;
      f.half_width = 0.90;
      f.goal_half_width = 0.20;
      f.goal_depth = 0.15;
      f.centre_circle_radius = 0.25;
      f.goal_area = {.depth = 0.15, .half_width = 0.25};
      f.penalty_area = Area{.depth = 0.35, .half_width = 0.40};
      add_arc(*f.penalty_area, f.half_length, 0.25, 0.05);
      f.penalty_mark_x = 0.725;
      f.free_ball_mark = {0.55, 0.60};
      f.free_ball_offset = 0.25;
      break;
    case League::large:
      f.robots_per_team = 11;
      f.half_length = 2.00;
      f.half_width = 1.40;
      f.goal_half_width = 0.30;
      f.goal_depth = 0.15;
      f.centre_circle_radius = 0.75;
      f.goal_area = {.depth = 0.25, .half_width = 0.425};
      f.penalty_area = Area{.depth = 0.70, .half_width = 0.60};
      add_arc(*f.penalty_area, f.half_length, 0.447214, 0.10);
      f.penalty_mark_x = 1.50;
      f.free_ball_mark = {1.00, 2.80 / 3.0};
      f.free_ball_offset = 0.30;
      break;
  }
  return f;
}

void add_walls(Field& f) {
  const double diagonal = std::sqrt(0.5);
  const double cut = (f.half_length + f.half_width - f.corner_leg) * diagonal;
  const double back = f.half_length + f.goal_depth;
  f.walls = {{
      {{0.0, -1.0}, -f.half_width},
      {{0.0, 1.0}, -f.half_width},
      {{-1.0, 0.0}, -back},
      {{1.0, 0.0}, -back},
      {{-diagonal, -diagonal}, -cut},
      {{diagonal, diagonal}, -cut},
      {{diagonal, -diagonal}, -cut},
      {{-diagonal, diagonal}, -cut},
  }};
  const double x = f.half_length;
  const double y = f.goal_half_width;
  f.posts = {{
      {{x, y}, {-1.0, 0.0}, {0.0, -1.0}},
      {{-x, -y}, {1.0, 0.0}, {0.0, 1.0}},
      {{-x, y}, {1.0, 0.0}, {0.0, -1.0}},
      {{x, -y}, {-1.0, 0.0}, {0.0, 1.0}},
  }};
}

}  // namespace

bool Field::inside(const Area& area, End end, const Vec2& point, double tolerance) const {
  const double x = -attack_sign(end) * point.x();  // as if at the right end
  const double y = std::abs(point.y());
  const double front = half_length - area.depth;
  if (x >= front - tolerance) {
    if (x <= half_length + tolerance) return y <= area.half_width + tolerance;
    return x <= half_length + goal_depth + tolerance && y <= goal_half_width + tolerance;
  }
  if (area.arc_radius == 0.0) return false;
  const double beyond = x - area.arc_centre;
  return std::sqrt(beyond * beyond + y * y) <= area.arc_radius + tolerance;
}

double Field::clearance(const Vec2& point) const {
  double nearest = HUGE_VAL;
  for (const Wall& wall : walls) nearest = std::min(nearest, wall.normal.dot(point) - wall.offset);
  for (const GoalPost& post : posts) {
    const Vec2 d = point - post.post;
    const double face = d.dot(post.face);
    const double side = d.dot(post.side);
    const bool beyond_corner = face > 0.0 && side > 0.0;
    nearest = std::min(nearest,
                       beyond_corner ? std::sqrt(face * face + side * side) : std::max(face, side));
  }
  return nearest;
}

Field make_field(League league) {
  Field f = dimensions(league);
  add_walls(f);
  return f;
}

}  // namespace mirocup::field
