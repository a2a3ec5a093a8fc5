// SPDX-License-Identifier: MIT
//
// Builds SVG path data, which browsers accept for pictures and for canvases. Points are in metres
// in the frame of the field; the path data is in millimetres with y downwards.
#pragma once

#include "core/base/vec2.hpp"

#include <string>
#include <vector>

namespace mirocup::web {

// Returns a length (m) as text in millimetres, rounded to a tenth; the text is equal on every
// machine.
std::string millimetres(double metres);

class SvgPath {
 public:
  SvgPath& move_to(const Vec2& point) { return add('M', point); }
  SvgPath& line_to(const Vec2& point) { return add('L', point); }

  // Follows the shorter arc of a radius (m) to the point. `counter_clockwise`: as seen from above.
  SvgPath& arc_to(double radius, const Vec2& point, bool counter_clockwise);

  SvgPath& circle(const Vec2& centre, double radius);
  SvgPath& polygon(const std::vector<Vec2>& corners);

  const std::string& text() const { return text_; }

 private:
  SvgPath& add(char command, const Vec2& point);

  std::string text_;
};

}  // namespace mirocup::web
