// SPDX-License-Identifier: MIT
#include "core/field/field.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirocup::field {

namespace {

// Returns the radius of the circle whose arc over a chord has the given height.
double radius_of_arc(double chord, double height) {
  return (chord * chord / 4.0 + height * height) / (2.0 * height);
}

// An area as the rule book draws it, in metres: a rectangle at the goal line, and an arc over the
// middle of its front line.
struct AreaDrawing {
  double depth;
  double half_width;
  double arc_chord = 0.0;  // on the front line; 0: no arc
  double arc_height = 0.0;
};

// The numbers of a league, in metres; the sources are named in the header. The penalty area of the
// small league has depth 0: it has none.
struct Dimensions {
  int robots_per_team;
  double half_length, half_width;
  double goal_half_width, goal_depth;
  double centre_circle_radius;
  AreaDrawing goal_area, penalty_area;
  double penalty_mark_x;
  double free_ball_mark_x, free_ball_mark_y;
  double free_ball_offset;
};

constexpr double corner_leg = 0.07;  // in all leagues

// In the order of RobotLeague.
constexpr std::array<Dimensions, 3> dimensions{{
    {.robots_per_team = 3,
     .half_length = 0.75,
     .half_width = 0.65,
     .goal_half_width = 0.20,
     .goal_depth = 0.10,
     .centre_circle_radius = 0.20,
     .goal_area = {.depth = 0.15, .half_width = 0.35, .arc_chord = 0.20, .arc_height = 0.05},
     .penalty_area = {.depth = 0.0, .half_width = 0.0},
     .penalty_mark_x = 0.375,
     .free_ball_mark_x = 0.375,
     .free_ball_mark_y = 0.40,
     .free_ball_offset = 0.20},
    {.robots_per_team = 5,
     .half_length = 1.10,
     .half_width = 0.90,
     .goal_half_width = 0.20,
     .goal_depth = 0.15,
     .centre_circle_radius = 0.25,
     .goal_area = {.depth = 0.15, .half_width = 0.25},
     .penalty_area = {.depth = 0.35, .half_width = 0.40, .arc_chord = 0.25, .arc_height = 0.05},
     .penalty_mark_x = 0.725,
     .free_ball_mark_x = 0.55,
     .free_ball_mark_y = 0.60,
     .free_ball_offset = 0.25},
    {.robots_per_team = 11,
     .half_length = 2.00,
     .half_width = 1.40,
     .goal_half_width = 0.30,
     .goal_depth = 0.15,
     .centre_circle_radius = 0.75,
     .goal_area = {.depth = 0.25, .half_width = 0.425},
     .penalty_area = {.depth = 0.70, .half_width = 0.60, .arc_chord = 0.447214, .arc_height = 0.10},
     .penalty_mark_x = 1.50,
     .free_ball_mark_x = 1.00,
     .free_ball_mark_y = 2.80 / 3.0,
     .free_ball_offset = 0.30},
}};

Area area_of(const AreaDrawing& drawing, double half_length) {
  Area area{.depth = drawing.depth, .half_width = drawing.half_width};
  if (drawing.arc_chord == 0.0) return area;
  area.arc_radius = radius_of_arc(drawing.arc_chord, drawing.arc_height);
  area.arc_centre = half_length - (area.depth + drawing.arc_height - area.arc_radius);
  return area;
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
  const double x = -attack_sign(end) * point.x();  // seen from the right end
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

Field make_field(RobotLeague league) {
  const Dimensions& d = dimensions[static_cast<std::size_t>(league)];
  Field f{.league = league,
          .robots_per_team = d.robots_per_team,
          .half_length = d.half_length,
          .half_width = d.half_width,
          .corner_leg = corner_leg,
          .goal_half_width = d.goal_half_width,
          .goal_depth = d.goal_depth,
          .centre_circle_radius = d.centre_circle_radius,
          .goal_area = area_of(d.goal_area, d.half_length),
          .penalty_area = {},
          .penalty_mark_x = d.penalty_mark_x,
          .free_ball_mark = {d.free_ball_mark_x, d.free_ball_mark_y},
          .free_ball_offset = d.free_ball_offset,
          .walls = {},
          .posts = {}};
  if (d.penalty_area.depth > 0.0) f.penalty_area = area_of(d.penalty_area, d.half_length);
  add_walls(f);
  return f;
}

}  // namespace mirocup::field
