// SPDX-License-Identifier: MIT
#include "web/svg_path.hpp"

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

SvgPath& SvgPath::polygon(const std::vector<Vec2>& corners) {
  for (const Vec2& corner : corners) add(&corner == corners.data() ? 'M' : 'L', corner);
  text_ += "Z";
  return *this;
}

}  // namespace mirocup::web
