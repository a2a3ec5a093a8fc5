// SPDX-License-Identifier: MIT
#include "programs/check/entry_check.hpp"

#include "plugins/host/sandbox/probe.hpp"
#include "plugins/host/team_host.hpp"
#include "plugins/host/team_log.hpp"
#include "programs/check/examination.hpp"
#include "system/locations.hpp"
#include "system/memory.hpp"
#include "system/printable.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

namespace mirocup::app {

namespace {

// The length of the legs against each house team: two minutes.
constexpr std::uint32_t ladder_ticks = 3600;

// A larger share of a leg's time is told.
constexpr double told_leg_share = 0.6;

// A team that takes this much more memory in a leg than at its start is told, bytes.
constexpr std::size_t told_growth = 256u << 20;

Result<bool> examine_play(Examination& e) {
  MIROCUP_TRY(e.report.isolation, plugins::strongest_isolation());
  MIROCUP_TRY(e.idle, plugins::SealedEntry::open(system::house_team("idle")));
  MIROCUP_TRY(e.striker, plugins::SealedEntry::open(system::house_team("striker")));
  for (const auto step : {load_and_answer, play_whole_legs, play_knockout, repeat_elsewhere}) {
    const auto passed = step(e);
    if (!passed || !*passed) return passed;
  }
  return true;
}

// Compares an entry that has passed with the house teams.
Result<void> judge_strength(Examination& e) {
  if (e.report.failure() != nullptr) return {};
  for (const Rung& rung : ladder) {
    if (!e.terms.ladder) break;
    MIROCUP_TRY(const auto opponent, plugins::SealedEntry::open(system::house_team(rung.team)));
    for (const Team team : both_teams) {
      TrialTerms terms = trial(e, team, opponent);
      terms.max_ticks = ladder_ticks;
      MIROCUP_TRY(auto leg, play(e, terms));
      leg.story.opponent = rung.team;
      e.report.ladder.push_back(std::move(leg.story));
    }
  }
  std::vector<LegStory> legs = e.report.legs;
  legs.insert(legs.end(), e.report.ladder.begin(), e.report.ladder.end());
  e.report.strength = strength_of(legs, e.setup.league);
  return {};
}

// Tells what is allowed but hardly meant.
void warn(Examination& e) {
  for (const std::size_t kind : {0u, 1u}) {
    const auto& [count, robot, is_left, tick] = e.report.bad_speeds[kind];
    const std::string first = system::formatted("the %s wheel of robot %d in tick %u",
                                                is_left ? "left" : "right", robot, tick);
    if (count > 0) note(e, kind == 0 ? "not_finite" : "too_large", std::to_string(count), first);
  }
  if (e.report.moved_placements > 0)
    note(e, "moved_placements", std::to_string(e.report.moved_placements));
  if (e.report.log.find(plugins::TeamLog::left_out_here) != std::string::npos) note(e, "long_log");
  if (e.report.leg_share > told_leg_share) note(e, "slow");
  if (e.grown > told_growth) note(e, "memory", system::mebibytes(e.grown));
  constexpr const char* sets[] = {"", "SSE4", "AVX", "AVX-512"};
  if (e.needs > e.terms.processor)
    note(e, "processor", sets[static_cast<std::size_t>(e.needs)],
         std::string(to_string(e.terms.processor)));
  std::set<std::string> told;
  std::string line;
  for (std::istringstream lines(e.requests); std::getline(lines, line);) {
    // Run-time libraries ask for variables of their own.
    if (line.rfind("variable OMP_", 0) == 0 || line.rfind("variable GOMP_", 0) == 0) continue;
    if (told.insert(line).second) note(e, "request", system::printable(line));
  }
  constexpr std::string_view mark = plugins::line_of_host;
  for (std::istringstream log(e.report.log); std::getline(log, line);) {
    if (line.starts_with(mark) && told.insert(line).second)
      note(e, "told", system::printable(line.substr(mark.size())));
  }
}

}  // namespace

const Check* EntryReport::failure() const {
  const auto found = std::find_if(checks.begin(), checks.end(),
                                  [](const Check& check) { return check.passed == false; });
  return found == checks.end() ? nullptr : &*found;
}

Result<EntryReport> check_entry(const std::string& path, const EntryTerms& terms,
                                const OnCheck& on_check, const OnStep& on_step) {
  Examination e{.path = path, .terms = terms, .on_check = on_check, .on_step = on_step};
  e.setup.league = terms.league;
  e.setup.rules = terms.rules;
  e.setup.control_period = match::control_period_of(e.setup.rules.preset);
  e.setup.rules.mercy_goal_diff = 0;  // so that the second half is played, whatever the score
  tell_next(e);
  MIROCUP_TRY(const auto looks_well, examine_file(e));
  if (looks_well) MIROCUP_TRY_VOID(examine_play(e));
  while (e.report.checks.size() < check_names.size())
    e.report.checks.push_back({check_names[e.report.checks.size()], std::nullopt, "not tried"});
  warn(e);
  MIROCUP_TRY_VOID(judge_strength(e));
  MIROCUP_TRY_VOID(note_play(e));
  e.report.used_seconds = e.plan.used();
  return std::move(e.report);
}

}  // namespace mirocup::app
