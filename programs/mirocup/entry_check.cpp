// SPDX-License-Identifier: MIT
#include "programs/mirocup/entry_check.hpp"

#include "plugins/host/sandbox/probe.hpp"
#include "programs/mirocup/examination.hpp"
#include "system/locations.hpp"
#include "system/memory.hpp"
#include "system/printable.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

namespace mirocup::app {

namespace {

// A larger log, bytes, and a larger share of a leg's time are told.
constexpr std::size_t told_log = 60u << 10;
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

// Tells what is allowed but hardly meant.
void warn(Examination& e) {
  const auto warn_if = [&](bool holds, std::string text) {
    if (holds) e.report.warnings.push_back(std::move(text));
  };
  const bool has_played = e.blue.ticks() > 0;
  warn_if(has_played && !e.report.has_moved, "it never turned a wheel");
  warn_if(e.report.bad_values > 0,
          std::to_string(e.report.bad_values) +
              " values of its commands were not finite or too large, and were zeroed or clamped");
  warn_if(e.report.moved_placements > 0,
          std::to_string(e.report.moved_placements) +
              " of its placements were not legal: robots were moved; the decisions of a record say "
              "which and why");
  warn_if(e.report.log.size() > told_log,
          "it logs so much that the middle of the log is left out: 64 KiB of a leg are kept");
  warn_if(e.report.leg_share > told_leg_share,
          "it takes most of the time that a leg has; leave room for slower machines");
  warn_if(e.grown > told_growth,
          "it took " + system::mebibytes(e.grown) +
              " of memory while a leg was played, and may take 1 GiB in all: free what it does not "
              "need any more");
  std::set<std::string> told;
  std::istringstream lines(e.requests);
  for (std::string line; std::getline(lines, line);) {
    // Run-time libraries ask for variables of their own.
    if (line.rfind("variable OMP_", 0) == 0 || line.rfind("variable GOMP_", 0) == 0) continue;
    if (told.insert(line).second)
      warn_if(true, "it asked for a " + system::printable(line) + ", which no team gets");
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
  if (looks_well) {
    MIROCUP_TRY_VOID(examine_play(e));
  }
  while (e.report.checks.size() < check_names.size())
    e.report.checks.push_back({check_names[e.report.checks.size()], std::nullopt, "not tried"});
  warn(e);
  e.report.used_seconds = e.plan.used();
  return std::move(e.report);
}

}  // namespace mirocup::app
