// SPDX-License-Identifier: MIT
//
// The two ends of the pitch, poses, and the frame of a team.
//
// The field's frame has its origin at the centre of the pitch, x towards the right goal and y
// towards the upper wall. The frame of a team is the field's frame for the team that defends the
// left end, and the field's frame turned by 180 degrees, not mirrored, for the other team. So every
// team sees itself attack +x. Units: m; headings are unit vectors.
#pragma once

#include "core/base/heading.hpp"
#include "core/base/names.hpp"
#include "core/base/vec2.hpp"

#include <array>
#include <string_view>

namespace mirocup {

// The end that a team defends. Left is x < 0; its defender attacks +x.
enum class End { left, right };

template <>
inline constexpr std::array<std::string_view, 2> enum_names<End>{"left", "right"};

constexpr End opposite(End end) {
  return end == End::left ? End::right : End::left;
}
constexpr int index_of(End end) {
  return static_cast<int>(end);
}
inline constexpr std::array<End, 2> both_ends{End::left, End::right};

// Returns the sign of x in the direction of attack: +1 for the defender of left, -1 for the
// defender of right. A vector of the field's frame times this sign is in the team's frame.
constexpr double attack_sign(End defended) {
  return defended == End::left ? 1.0 : -1.0;
}

// The position and heading of a robot: metres and a unit vector.
struct Pose {
  Vec2 position{0.0, 0.0};
  Heading heading;
};

// Converts from the field's frame to the frame of the team that defends `end`. The conversion is
// exact to the last bit and its own inverse, so the same functions convert back.
inline Vec2 team_frame(End end, const Vec2& v) {
  return attack_sign(end) * v;
}
inline Heading team_frame(End end, const Heading& h) {
  return end == End::left ? h : h.half_turned();
}
inline Pose team_frame(End end, const Pose& p) {
  return {team_frame(end, p.position), team_frame(end, p.heading)};
}

}  // namespace mirocup
