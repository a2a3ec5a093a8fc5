// SPDX-License-Identifier: MIT
#include "core/referee/predicates.hpp"

#include <cmath>

namespace mirocup::referee {

std::array<End, 2> ends_from_ball(const TickFacts& s) {
  const double side = s.ball.x() != 0.0 ? s.ball.x() : s.ball.y();
  const End first = side < 0.0 ? End::left : End::right;
  return {first, opposite(first)};
}

bool ball_in_half(const TickFacts& s, End end) {
  return attack_sign(end) * s.ball.x() < 0.0;
}

bool ball_in_zone(const JudgedField& pitch, const TickFacts& s, End end) {
  const field::Field& field = pitch.field;
  if (pitch.rules.zone_depth_m > 0.0) {
    const double from_line = field.half_length + attack_sign(end) * s.ball.x();
    return from_line <= pitch.rules.zone_depth_m &&
           std::abs(s.ball.y()) <= pitch.rules.zone_half_width_m;
  }
  if (field.penalty_area) return field.inside(*field.penalty_area, end, s.ball);
  return field.inside(field.goal_area, end, s.ball, pitch.rules.zone_margin_m);
}

bool is_contested(const JudgedField& pitch, const TickFacts& s, End owner) {
  const double reach = pitch.rules.contested_m;
  for (int i = 0; i < pitch.field.robots_per_team; ++i) {
    const Vec2 offset = s.robots[index_of(opposite(owner))][i].position - s.ball;
    if (offset.squaredNorm() <= reach * reach) return true;
  }
  return false;
}

bool drives_at(const JudgedField& pitch, const TickFacts& s, const RobotId& a, const RobotId& b) {
  const Vec2 offset = s.pose(b).position - s.pose(a).position;
  const Vec2& commanded = s.commanded[index_of(a.end)][a.index];
  return commanded.dot(offset) >= pitch.rules.drive_mps * std::sqrt(offset.squaredNorm()) &&
         offset.squaredNorm() > 0.0;
}

}  // namespace mirocup::referee
