// SPDX-License-Identifier: MIT
#include "core/referee/judged_field.hpp"

namespace mirocup::referee {

Quarter quarter_of(const Vec2& point) {
  return {point.x() > 0.0 ? 1.0 : -1.0, point.y() > 0.0 ? 1.0 : -1.0};
}

}  // namespace mirocup::referee
