// SPDX-License-Identifier: MIT
#include "programs/check/strength.hpp"

#include "system/text.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::app {

namespace {

constexpr double spread = 1.25;        // of a lead in goals, as a multiple of the root of all goals
constexpr double likely = 2.0;         // spreads: 95 of 100 leads are nearer
constexpr double least_minutes = 4.0;  // shorter legs say nothing

}  // namespace

Strength strength_of(const std::vector<LegStory>& legs, RobotLeague league) {
  double minutes = 0.0, won_by = 0.0, goals = 1.0;
  for (const LegStory& leg : legs) {
    const Rung& met = *std::ranges::find(ladder, leg.opponent, &Rung::team);
    minutes += leg.minutes;
    won_by += leg.lead() + leg.minutes * met.lead[static_cast<std::size_t>(league)];
    goals += leg.score[0] + leg.score[1];
  }
  if (minutes < least_minutes) return {};
  // By how many spreads the legs are better than those of a house team. Leads add up: who wins by 1
  // against a team that wins by 2 against `striker` would win by 3 against `striker`.
  const auto lead_over = [&](const Rung& rung) {
    const double usual = minutes * rung.lead[static_cast<std::size_t>(league)];
    return (won_by - usual) / (spread * std::sqrt(goals));
  };
  const Rung* like = &ladder[0];
  const Rung* below = nullptr;     // the strongest that is clearly weaker
  std::vector<const Rung*> equal;  // those that may be as strong
  for (const Rung& rung : ladder) {
    const double lead = lead_over(rung);
    if (std::abs(lead) < std::abs(lead_over(*like))) like = &rung;
    if (lead > likely) below = &rung;
    if (std::abs(lead) <= likely) equal.push_back(&rung);
  }
  if (below == &ladder.back()) return {"stronger than `planner`"};
  if (below == nullptr && equal.empty())
    return {"weaker than `idle`: it loses more than a team that stands", true, true};
  std::string text = "about as strong as `" + std::string(like->team) + '`';
  if (equal.empty())
    text = system::formatted("stronger than `%s` and weaker than `%s`", below->team, below[1].team);
  if (equal.size() > 1)
    text += system::formatted(", and probably between `%s` and `%s`", equal.front()->team,
                              equal.back()->team);
  return {.text = text, .is_below_keeper = lead_over(ladder[1]) < -likely};
}

}  // namespace mirocup::app
