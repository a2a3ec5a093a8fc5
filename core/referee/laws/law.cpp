// SPDX-License-Identifier: MIT
#include "core/referee/laws/law.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

namespace mirocup::referee {

std::array<End, 2> ends_from_ball(const Situation& s) {
  const double side = s.ball.x() != 0.0 ? s.ball.x() : s.ball.y();
  const End first = side < 0.0 ? End::left : End::right;
  return {first, opposite(first)};
}

bool is_contested(const Pitch& pitch, const Situation& s, End owner) {
  const double reach = pitch.rules.contested_m;
  for (int i = 0; i < pitch.field.robots_per_team; ++i) {
    const Vec2 away = s.robots[index_of(opposite(owner))][i].position - s.ball;
    if (away.squaredNorm() <= reach * reach) return true;
  }
  return false;
}

bool drives_at(const Pitch& pitch, const Situation& s, const RobotId& a, const RobotId& b) {
  const Vec2 way = s.pose(b).position - s.pose(a).position;
  const Vec2& commanded = s.commanded[index_of(a.end)][a.index];
  return commanded.dot(way) >= pitch.rules.drive_mps * std::sqrt(way.squaredNorm()) &&
         way.squaredNorm() > 0.0;
}

bool ball_in_zone(const Pitch& pitch, const Situation& s, End end) {
  const field::Field& field = pitch.field;
  if (field.penalty_area) return field.inside(*field.penalty_area, end, s.ball);
  return field.inside(field.goal_area, end, s.ball, pitch.rules.zone_margin_m);
}

bool ball_in_half(const Situation& s, End end) {
  return attack_sign(end) * s.ball.x() < 0.0;
}

Decision decide(Verdict verdict, Law law, const Situation& s, std::string reason) {
  Decision decision;
  decision.verdict = verdict;
  decision.law = law;
  decision.clock = s.begin + s.duration;
  decision.ball = s.ball;
  decision.reason = std::move(reason);
  return decision;
}

Decision against(Decision decision, End offender, Restart restart) {
  decision.team = offender;
  decision.restart = restart;
  decision.taker = opposite(offender);
  return decision;
}

Quarter quarter_of(const Vec2& point) {
  return {point.x() > 0.0 ? 1.0 : -1.0, point.y() > 0.0 ? 1.0 : -1.0};
}

void give_free_ball(const Pitch& pitch, const Vec2& where, Decision& decision) {
  const Quarter quarter = quarter_of(where);
  const Vec2& mark = pitch.field.free_ball_mark;
  decision.restart = Restart::FREE_BALL;
  decision.spot = {quarter.x * mark.x(), quarter.y * mark.y()};
  decision.taker = quarter.x > 0.0 ? End::right : End::left;
}

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string name_of(const RobotId& robot) {
  return std::string(to_string(robot.end)) + " robot " + std::to_string(robot.index);
}

}  // namespace mirocup::referee
