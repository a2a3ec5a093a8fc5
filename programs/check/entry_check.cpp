// SPDX-License-Identifier: MIT
#include "programs/check/entry_check.hpp"

#include "core/field/field.hpp"
#include "plugins/host/sandbox/probe.hpp"
#include "plugins/host/team_host.hpp"
#include "plugins/host/team_log.hpp"
#include "programs/check/examination.hpp"
#include "system/locations.hpp"
#include "system/memory.hpp"
#include "system/printable.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>
#include <utility>

namespace mirocup::app {

namespace {

// A larger share of a leg's time is told.
constexpr double told_leg_share = 0.6;

// Play that is told: own goals in a leg; the share of the speed that its touches gave the ball
// towards its own end, and the least such speed, m/s; the fastest wheel, rad/s; shares of play.
constexpr int told_own_goals = 3;
constexpr double told_own_share = 0.75;
constexpr double told_given_speed = 10.0;
constexpr double told_wheel = 5.0;
constexpr double told_standing = 0.9;
constexpr double told_turning = 0.6;
constexpr double told_backwards = 0.8;

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

// Tells what the whole legs show of a team that means to play well.
void note_play(Examination& e) {
  const auto note = [&](const char* code, std::string text) {
    e.report.notes.push_back({code, std::move(text)});
  };
  unsigned told_left = 0;
  unsigned told_right = 0;
  double fastest = 0.0;
  double still = 0.0;
  LegStory worst;  // of each share, the larger one
  std::string colours;
  for (const LegStory& leg : e.report.legs) {
    told_left |= leg.told_left;
    told_right |= leg.told_right;
    fastest = std::max(fastest, leg.fastest_wheel);
    worst.standing = std::max(worst.standing, leg.standing);
    worst.turning = std::max(worst.turning, leg.turning);
    still = std::max(still, leg.standing + leg.turning);
    worst.backwards = std::max(worst.backwards, leg.backwards);
    const bool scores_for_them = leg.own_goals >= told_own_goals &&
                                 leg.own_goals > 2 * leg.score[0] &&
                                 4 * leg.own_goals >= leg.score[1];
    const bool plays_for_them =
        leg.given_speed > told_given_speed && leg.towards_own_end > told_own_share;
    if (leg.standing > told_standing || (!scores_for_them && !plays_for_them)) continue;
    colours += (colours.empty() ? "" : " and ") + std::string(to_string(leg.team));
  }
  if (!colours.empty()) {
    note("own_goals", "as " + colours +
                          " it plays the ball towards its own goal: you attack +x in both colours "
                          "and in both halves, and your own goal is at -x");
  }
  if (e.report.legs.empty()) return;
  if (fastest == 0.0) return note("never_moved", "it never turned a wheel");
  const auto percent = [](double share) { return std::to_string(std::lround(100.0 * share)); };
  if (fastest < told_wheel) {
    note("slow_wheels", "no command turned a wheel faster than " +
                            std::to_string(fastest).substr(0, 4) +
                            " rad/s: speeds of wheels are in rad/s, and not in m/s");
  } else if (worst.turning > told_turning || still > told_standing) {
    note("turns",
         "its robots stood in " + percent(worst.standing) + " % of play and turned in place in " +
             percent(worst.turning) +
             " %: look at angles, which are in radians and have to be wrapped to -pi..pi, and at "
             "places, which are in metres");
  }
  if (worst.backwards > told_backwards) {
    note("backwards", "its robots drove backwards in " + percent(worst.backwards) +
                          " % of play: look at the order of the wheels, left and then right, and "
                          "at signs");
  }
  for (int i = 0; i < field::make_field(e.setup.league).robots_per_team; ++i) {
    const unsigned bit = 1U << static_cast<unsigned>(i);
    if ((told_left & told_right & bit) != 0) continue;
    const bool is_silent = ((told_left | told_right) & bit) == 0;
    const char* wheel = is_silent ? "a" : (told_left & bit) == 0 ? "its left" : "its right";
    note("silent_robot",
         "robot " + std::to_string(i) + " never got a command to turn " + wheel + " wheel");
  }
}

// Tells what is allowed but hardly meant.
void warn(Examination& e) {
  const auto warn_if = [&](bool holds, const char* code, std::string text) {
    if (holds) e.report.notes.push_back({code, std::move(text)});
  };
  warn_if(e.report.bad_values > 0, "bad_values",
          std::to_string(e.report.bad_values) +
              " values of its commands were not finite or too large, and were zeroed or clamped");
  warn_if(e.report.moved_placements > 0, "moved_placements",
          std::to_string(e.report.moved_placements) +
              " of its placements were not legal: robots were moved; the decisions of a record say "
              "which and why");
  const bool is_cut = e.report.log.find(plugins::TeamLog::left_out_here) != std::string::npos;
  warn_if(is_cut, "long_log",
          "it logs so much that the middle of the log is left out: 64 KiB of a leg are kept");
  warn_if(e.report.leg_share > told_leg_share, "slow",
          "it takes most of the processor time that a team has in a leg; leave room for slower "
          "machines");
  warn_if(e.grown > told_growth, "memory",
          "it took " + system::mebibytes(e.grown) +
              " of memory while a leg was played, of 1 GiB that a team has in all: free what it "
              "does not need any more");
  const auto oldest = std::string(to_string(e.terms.processor));
  const std::array<const char*, 4> sets{"", "SSE4", "AVX", "AVX-512"};
  warn_if(
      e.needs > e.terms.processor, "processor",
      std::string("it has instructions of ") + sets[static_cast<std::size_t>(e.needs)] +
          ", which are for processors of " + std::string(to_string(e.needs)) +
          ": on a computer of " + oldest +
          ", such as the oldest of its league may be, they end the team. Build it with -march=" +
          oldest + " in place of a newer -march or native, and without target attributes");
  std::set<std::string> told;
  std::istringstream lines(e.requests);
  for (std::string line; std::getline(lines, line);) {
    // Run-time libraries ask for variables of their own.
    if (line.rfind("variable OMP_", 0) == 0 || line.rfind("variable GOMP_", 0) == 0) continue;
    if (told.insert(line).second)
      warn_if(true, "request",
              "it asked for a " + system::printable(line) + ", which no team gets");
  }
  std::istringstream log(e.report.log);
  constexpr std::string_view mark = plugins::line_of_host;
  for (std::string line; std::getline(log, line);) {
    if (line.starts_with(mark) && told.insert(line).second)
      warn_if(true, "told", system::printable(line.substr(mark.size())));
  }
  note_play(e);
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
  e.report.used_seconds = e.plan.used();
  return std::move(e.report);
}

}  // namespace mirocup::app
