// SPDX-License-Identifier: MIT
//
// Lines and arcs of the field as the path data of SVG, which browsers take for pictures and canvases
// alike. Points go in in metres of the field's frame; the text is in millimetres with y downwards.
#pragma once

#include "core/base/vec2.hpp"

#include <string>
#include <vector>

namespace mirocup::web {

// Metres as millimetres, rounded to a tenth, the same text everywhere.
std::string millimetres(double metres);

class SvgPath {
 public:
  SvgPath& move_to(const Vec2& point) { return add('M', point); }
  SvgPath& line_to(const Vec2& point) { return add('L', point); }

  // Along the shorter arc of that radius, seen by who looks at the field from above.
  SvgPath& arc_to(double radius, const Vec2& point, bool counter_clockwise);

  SvgPath& circle(const Vec2& centre, double radius);
  SvgPath& polygon(const std::vector<Vec2>& corners);

  const std::string& text() const { return text_; }

 private:
  SvgPath& add(char command, const Vec2& point);

  std::string text_;
};

}  // namespace mirocup::web
