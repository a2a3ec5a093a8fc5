// SPDX-License-Identifier: MIT
#include "core/referee/laws/law.hpp"

#include <cstdio>
#include <utility>

namespace mirocup::referee {

bool is_contested(const Pitch& pitch, const Situation& s, End owner) {
  const double reach = pitch.rules.contested_m;
  for (int i = 0; i < pitch.field.robots_per_team; ++i) {
    const Vec2 away = s.robots[index_of(opposite(owner))][i].position - s.ball;
    if (away.squaredNorm() <= reach * reach) return true;
  }
  return false;
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

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

}  // namespace mirocup::referee
