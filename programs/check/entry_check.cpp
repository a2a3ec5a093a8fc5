// SPDX-License-Identifier: MIT
#include "programs/check/entry_check.hpp"

#include "plugins/host/team_host.hpp"
#include "plugins/host/team_log.hpp"
#include "programs/check/examination.hpp"
#include "system/locations.hpp"
#include "system/memory.hpp"
#include "system/printable.hpp"

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

// Returns the line of the entry's own file and the tick in which it failed.
std::string place_of(const TrialLeg& leg, const TrialTerms& terms) {
  const int line = leg.fault->line;
  const std::string place = line > 0 ? "line " + std::to_string(line) + " of the file, " : "";
  if (leg.start_seconds == 0.0) return place + "before the first tick";
  return place + "tick " + std::to_string(leg.ticks()) + " of a leg as " +
         std::string(to_string(terms.team));
}

// Compares an entry that has passed with the house teams.
Result<void> judge_strength(Examination& e) {
  std::vector<LegStory> legs = e.report.legs;
  for (std::size_t i = 0; e.terms.ladder && i < 2 * ladder.size(); ++i) {
    MIROCUP_TRY(const auto opponent,
                plugins::SealedEntry::open(system::house_team(ladder[i / 2].team)));
    MIROCUP_TRY(auto leg, play(e, {e.setup, &opponent, both_teams[i % 2], ladder_ticks}));
    leg.story.opponent = ladder[i / 2].team;
    e.report.ladder.push_back(leg.story);
    legs.push_back(std::move(leg.story));
  }
  e.report.strength = strength_of(legs, e.setup.league);
  return note_play(e);
}

// Tells what is allowed but hardly meant.
void warn(Examination& e) {
  for (const std::size_t kind : {0u, 1u}) {
    const auto& [count, first] = e.report.bad_speeds[kind];
    if (count > 0) note(e, kind == 0 ? "not_finite" : "too_large", std::to_string(count), first);
  }
  if (e.report.moved_placements > 0)
    note(e, "moved_placements", std::to_string(e.report.moved_placements));
  if (e.report.log.find(plugins::TeamLog::left_out_here) != std::string::npos) note(e, "long_log");
  if (e.report.leg_share > told_leg_share) note(e, "slow");
  const std::size_t grown = std::max(e.whole[0].grown, e.whole[1].grown);
  if (grown > told_growth) note(e, "memory", system::mebibytes(grown));
  constexpr const char* sets[] = {"", "SSE4", "AVX", "AVX-512"};
  const auto needs =
      e.library.exports_entry ? plugins::processor_for(e.entry->bytes()) : system::Processor::v1;
  if (needs > e.terms.processor)
    note(e, "processor", sets[static_cast<std::size_t>(needs)],
         std::string(to_string(e.terms.processor)));
  std::set<std::string> told;
  const auto tell_lines = [&](const std::string& text, std::string_view mark, const char* code) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      // Run-time libraries ask for variables of their own.
      if (line.starts_with("variable OMP_") || line.starts_with("variable GOMP_")) continue;
      if (line.starts_with(mark) && told.insert(line).second)
        note(e, code, system::printable(line.substr(mark.size())));
    }
  };
  tell_lines(e.requests, "", "request");
  tell_lines(e.report.log, plugins::line_of_host, "told");
}

}  // namespace

Check passed(std::string finding) {
  return {.passed = true, .text = std::move(finding)};
}

Check failed(const std::string& what, const std::string& cure, const std::string& where) {
  const std::string text = what + (cure.empty() ? "" : ": " + cure);
  return {.passed = false, .text = text, .what = what, .where = where, .cure = cure};
}

Result<Check> judge(Examination& e, const TrialLeg& leg, const TrialTerms& terms,
                    std::string finding) {
  note_use(e, leg, terms);
  if (!leg.fault) return passed(std::move(finding));
  const bool is_python = e.entry->is_python();
  std::string mistake;
  if (leg.fault->code == match::FaultCode::crash && !terms.is_careful && !is_python) {
    // Before the crash the team may have made a mistake, which shows where its memory is watched.
    TrialTerms careful = terms;
    careful.is_careful = true;
    e.plan.look_for_causes();
    careful.max_seconds = e.plan.share_of(1);
    MIROCUP_TRY(const auto again, play(e, careful));
    if (is_memory_mistake(again)) mistake = sentence("watched", again.fault->text);
  }
  const std::string cure = advice_on({*leg.fault, leg.words, e.requests, is_python}) + mistake;
  Check check = failed(described(*leg.fault), cure, place_of(leg, terms));
  check.cause = leg.fault->cause;
  return check;
}

void note_use(Examination& e, const TrialLeg& leg, const TrialTerms& terms) {
  e.report.start_ms = 1e3 * leg.start_seconds;
  e.report.peak_memory = std::max(e.report.peak_memory, leg.peak_memory);
  e.report.log = leg.output;
  e.report.unknown_parameters = plugins::not_asked_for(e.terms.parameters, leg.asked_parameters);
  e.report.moved_placements += leg.story.moved_placements;
  for (const std::size_t kind : {0u, 1u}) {
    auto& [count, first] = e.report.bad_speeds[kind];
    if (count == 0) first = leg.story.bad_speeds[kind].first;
    count += leg.story.bad_speeds[kind].count;
  }
  if (leg.ticks() == 0 || terms.is_careful) return;  // a careful process takes longer
  e.report.slowest_tick_ms = std::max(e.report.slowest_tick_ms, leg.slowest_tick_ms);
  e.report.mean_tick_ms = 1e3 * leg.playing_seconds / leg.ticks();
}

void note(Examination& e, const char* code, const std::string& first, const std::string& second) {
  e.report.notes.push_back({code, sentence(code, first, second)});
}

std::string described(const match::Fault& fault) {
  return fault.text + " (" + std::string(to_string(fault.code)) + ")";
}

bool is_memory_mistake(const TrialLeg& leg) {
  return leg.fault && (leg.fault->cause == "memory" || leg.fault->cause == "command");
}

const Check* EntryReport::failure() const {
  const auto found = std::ranges::find(checks, std::optional(false), &Check::passed);
  return found == checks.end() ? nullptr : &*found;
}

Result<EntryReport> check_entry(const std::string& path, const EntryTerms& terms,
                                const OnCheck& on_check, const OnStep& on_step) {
  Examination e{.path = path, .terms = terms};
  e.setup.league = terms.league;
  e.setup.rules = terms.rules;
  e.setup.control_period = match::control_period_of(e.setup.rules.preset);
  e.setup.rules.mercy_goal_diff = 0;  // so that the second half is played, whatever the score
  std::vector<Step> steps(file_checks.begin(), file_checks.end());
  steps.insert(steps.end(), play_checks.begin(), play_checks.end());
  steps.insert(steps.end(), repeat_checks.begin(), repeat_checks.end());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto& [name, run] = steps[i];
    Check check{.text = "not tried"};
    if (e.report.failure() == nullptr) {
      if (on_step) on_step(static_cast<int>(i) + 1, static_cast<int>(steps.size()), name);
      MIROCUP_TRY(check, run(e));
      if (check.passed == false)
        check.where = std::string(name) + (check.where.empty() ? "" : ", ") + check.where;
    }
    check.name = name;
    if (on_check && check.passed) on_check(check);
    e.report.checks.push_back(std::move(check));
  }
  warn(e);
  if (e.report.failure() == nullptr) MIROCUP_TRY_VOID(judge_strength(e));
  e.report.used_seconds = e.plan.used();
  return std::move(e.report);
}

}  // namespace mirocup::app
