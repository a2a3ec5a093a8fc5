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
  const Rung* below = nullptr;     // the strongest that is clearly weaker
  std::vector<const Rung*> equal;  // those that may be as strong
  double nearest = 1e9;
  for (const Rung& rung : ladder) {
    const double lead = lead_over(rung, legs, league);
    if (std::abs(lead) < nearest) nearest = std::abs(lead), like = &rung;
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
  return {.text = text, .is_below_keeper = lead_over(ladder[1], legs, league) < -likely};
}

}  // namespace mirocup::app
