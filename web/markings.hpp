// SPDX-License-Identifier: MIT
//
// The outline of a field and its markings as SVG path data, for pictures, replay pages and live
// pages.
#pragma once

#include "core/base/vec2.hpp"
#include "core/field/field.hpp"

#include <array>
#include <string>
#include <vector>

namespace mirocup::web {

// Builds SVG path data, which browsers accept for pictures and for canvases. Points are in metres
// in the frame of the field; the path data is in millimetres with y downwards.
class SvgPath {
 public:
  SvgPath& move_to(const Vec2& point) { return add('M', point); }
  SvgPath& line_to(const Vec2& point) { return add('L', point); }

  // Follows the shorter arc of a radius (m) to the point. `counter_clockwise`: as seen from above.
  SvgPath& arc_to(double radius, const Vec2& point, bool counter_clockwise);

  SvgPath& circle(const Vec2& centre, double radius);
  SvgPath& lines(const std::vector<Vec2>& points);
  SvgPath& polygon(const std::vector<Vec2>& corners);

  const std::string& text() const { return text_; }

 private:
  SvgPath& add(char command, const Vec2& point);

  std::string text_;
};

// Returns a length (m) as text in millimetres, rounded to a tenth; the text is equal on every
// machine.
std::string millimetres(double metres);

struct Markings {
  std::string ground;                // the outline of the floor with cut corners and goals
  std::array<std::string, 2> goals;  // the floor of each goal, indexed by index_of(End)
  std::string lines;                 // path of lines and circles
  // Goal area and penalty area of each end (index_of(End)), without arcs.
  std::array<std::string, 2> zones;
  std::string spots;  // centre, penalty and free-ball marks, as filled discs
};

Markings markings(const field::Field& field);

}  // namespace mirocup::web
