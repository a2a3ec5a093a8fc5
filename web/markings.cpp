// SPDX-License-Identifier: MIT
#include "web/markings.hpp"

#include <cmath>

namespace mirocup::web {

std::string millimetres(double metres) {
  const long long tenths = std::llround(metres * 1e4);
  const long long size = std::abs(tenths);
  std::string text = (tenths < 0 ? "-" : "") + std::to_string(size / 10);
  if (size % 10 != 0) text += "." + std::to_string(size % 10);
  return text;
}

SvgPath& SvgPath::add(char command, const Vec2& point) {
  text_ += command;
  text_ += millimetres(point.x()) + " " + millimetres(-point.y());
  return *this;
}

SvgPath& SvgPath::arc_to(double radius, const Vec2& point, bool counter_clockwise) {
  const std::string r = millimetres(radius);
  text_ += "A" + r + " " + r + " 0 0 " + (counter_clockwise ? "0 " : "1 ") +
           millimetres(point.x()) + " " + millimetres(-point.y());
  return *this;
}

SvgPath& SvgPath::circle(const Vec2& centre, double radius) {
  const Vec2 right = centre + Vec2{radius, 0.0};
  const Vec2 left = centre - Vec2{radius, 0.0};
  return move_to(right).arc_to(radius, left, true).arc_to(radius, right, true);
}

SvgPath& SvgPath::lines(const std::vector<Vec2>& points) {
  for (const Vec2& point : points) add(&point == points.data() ? 'M' : 'L', point);
  return *this;
}

SvgPath& SvgPath::polygon(const std::vector<Vec2>& corners) {
  lines(corners);
  text_ += "Z";
  return *this;
}

namespace {

constexpr double spot_radius = 0.008;  // m

// A point that is given for the right end, or its half-turn for the left end.
Vec2 at_end(End end, double x, double y) {
  return -attack_sign(end) * Vec2{x, y};
}

std::string ground(const field::Field& f) {
  const double x = f.half_length;
  const double y = f.half_width;
  const double back = x + f.goal_depth;
  const double mouth = f.goal_half_width;
  const std::vector<Vec2> right{{x - f.corner_leg, -y}, {x, f.corner_leg - y}, {x, -mouth},
                                {back, -mouth},         {back, mouth},         {x, mouth},
                                {x, y - f.corner_leg},  {x - f.corner_leg, y}};
  std::vector<Vec2> outline = right;
  for (const Vec2& corner : right) outline.push_back(-corner);
  return SvgPath().polygon(outline).text();
}

// The corners of a rectangle at the goal line of an end, with its other side at `front`.
std::vector<Vec2> corners(const field::Field& f, End end, double front, double half_width) {
  return {at_end(end, f.half_length, -half_width), at_end(end, front, -half_width),
          at_end(end, front, half_width), at_end(end, f.half_length, half_width)};
}

std::vector<Vec2> corners(const field::Field& f, End end, const field::Area& area) {
  return corners(f, end, f.half_length - area.depth, area.half_width);
}

std::string goal(const field::Field& f, End end) {
  return SvgPath().polygon(corners(f, end, f.half_length + f.goal_depth, f.goal_half_width)).text();
}

void add_area(SvgPath& path, const field::Field& f, const field::Area& area, End end) {
  path.lines(corners(f, end, area));
  if (area.arc_radius == 0.0) return;
  const double front = f.half_length - area.depth;
  const double beyond = front - area.arc_centre;
  const double half_chord = std::sqrt(area.arc_radius * area.arc_radius - beyond * beyond);
  path.move_to(at_end(end, front, half_chord))
      .arc_to(area.arc_radius, at_end(end, front, -half_chord), true);
}

std::string lines(const field::Field& f) {
  SvgPath path;
  path.move_to({0.0, -f.half_width}).line_to({0.0, f.half_width});
  path.circle({0.0, 0.0}, f.centre_circle_radius);
  for (const End end : both_ends) {
    path.move_to(at_end(end, f.half_length, -f.half_width + f.corner_leg))
        .line_to(at_end(end, f.half_length, f.half_width - f.corner_leg));
    add_area(path, f, f.goal_area, end);
    if (f.penalty_area) add_area(path, f, *f.penalty_area, end);
  }
  return path.text();
}

std::string zone(const field::Field& f, End end) {
  SvgPath path;
  path.polygon(corners(f, end, f.goal_area));
  if (f.penalty_area) path.polygon(corners(f, end, *f.penalty_area));
  return path.text();
}

std::string spots(const field::Field& f) {
  SvgPath path;
  path.circle({0.0, 0.0}, spot_radius);
  for (const double side : {-1.0, 1.0}) {
    path.circle({side * f.penalty_mark_x, 0.0}, spot_radius);
    for (const double half : {-1.0, 1.0}) {
      const Vec2 mark{side * f.free_ball_mark.x(), half * f.free_ball_mark.y()};
      for (const double offset : {-f.free_ball_offset, 0.0, f.free_ball_offset}) {
        path.circle(mark + Vec2{offset, 0.0}, spot_radius);
      }
    }
  }
  return path.text();
}

}  // namespace

Markings markings(const field::Field& field) {
  return {.ground = ground(field),
          .goals = {goal(field, End::left), goal(field, End::right)},
          .lines = lines(field),
          .zones = {zone(field, End::left), zone(field, End::right)},
          .spots = spots(field)};
}

}  // namespace mirocup::web
