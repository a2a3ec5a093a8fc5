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

// Returns by how many spreads the legs are better than those of a rung: those against its team, or
// if there are none, those against `striker`.
double lead_over(const Rung& rung, const std::vector<LegStory>& legs, RobotLeague league) {
  const bool have_met =
      std::ranges::find(legs, std::string(rung.team), &LegStory::opponent) != legs.end();
  const std::string team = have_met ? rung.team : "striker";
  const double usual = have_met ? 0.0 : rung.lead[static_cast<std::size_t>(league)];
  double lead = 0.0;
  double goals = 1.0;
  for (const LegStory& leg : legs) {
    if (leg.opponent != team) continue;
    lead += leg.lead() - usual * leg.minutes;
    goals += leg.score[0] + leg.score[1];
  }
  return lead / (spread * std::sqrt(goals));
}

}  // namespace

Strength strength_of(const std::vector<LegStory>& legs, RobotLeague league) {
  double minutes = 0.0;
  for (const LegStory& leg : legs) minutes += leg.minutes;
  if (minutes < least_minutes) return {};
  const Rung* like = nullptr;
  const Rung* weakest = nullptr;
  const Rung* strongest = nullptr;
  double nearest = 1e9;
  for (const Rung& rung : ladder) {
    const double lead = std::abs(lead_over(rung, legs, league));
    if (lead < nearest) nearest = lead, like = &rung;
    if (lead > likely) continue;
    if (weakest == nullptr) weakest = &rung;
    strongest = &rung;
  }
  if (lead_over(ladder.front(), legs, league) < -likely)
    return {"weaker than `idle`: it loses more than a team that stands", true, true};
  if (lead_over(ladder.back(), legs, league) > likely) return {"stronger than `planner`"};
  std::string text = system::formatted("about as strong as `%s`", like->team);
  if (weakest != strongest)
    text +=
        system::formatted(", and probably between `%s` and `%s`", weakest->team, strongest->team);
  return {.text = text, .may_be_idle = weakest == &ladder.front()};
}

}  // namespace mirocup::app
