// SPDX-License-Identifier: MIT
//
// Who and where: teams have a colour for the whole match, ends change at half-time.
#pragma once

#include "core/base/heading.hpp"
#include "core/base/names.hpp"
#include "core/base/vec2.hpp"

#include <array>
#include <string_view>

namespace mirocup {

enum class Team { blue, yellow };

template <>
inline constexpr std::array<std::string_view, 2> enum_names<Team>{"blue", "yellow"};

constexpr Team opponent_of(Team team) {
  return team == Team::blue ? Team::yellow : Team::blue;
}
constexpr int index_of(Team team) {
  return static_cast<int>(team);
}
inline constexpr std::array<Team, 2> both_teams{Team::blue, Team::yellow};

// The end that a team defends: left is x < 0. Who defends left attacks +x.
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

// +1 for the defender of left, -1 for the defender of right. A team's own frame is the field's
// frame times this sign, which is a half-turn (never a mirror), so every team sees itself attack
// +x.
constexpr double attack_sign(End defended) {
  return defended == End::left ? 1.0 : -1.0;
}

// Where a robot stands: metres and a unit vector.
struct Pose {
  Vec2 position{0.0, 0.0};
  Heading heading;
};

// From the field's frame to the frame of the team that defends `end`, and back: it is its own
// inverse.
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
