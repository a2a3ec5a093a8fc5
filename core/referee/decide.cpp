// SPDX-License-Identifier: MIT
#include "core/referee/decide.hpp"

#include <cstdio>
#include <utility>

namespace mirocup::referee {

Decision decide(Verdict verdict, Law law, const TickFacts& s, std::string reason) {
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

void give_free_ball(const JudgedField& pitch, const Vec2& where, Decision& decision) {
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
