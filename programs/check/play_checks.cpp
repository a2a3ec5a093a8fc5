// SPDX-License-Identifier: MIT
//
// The checks in which the entry plays: a first answer, whole legs, a knock-out leg.
#include "core/field/field.hpp"
#include "programs/check/examination.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <utility>

namespace mirocup::app {

namespace {

constexpr std::uint32_t first_ticks = 100;
// A team that needs this long for the first ticks waits or computes too long in each, s.
constexpr double max_first_seconds = 2.0;
constexpr double first_half = 10.0;  // s; longer than the first ticks

// An entry is refused if it would use this many times the processor time that its leg gives. The
// time that a team uses changes by less than that on a busy machine.
constexpr double refused_leg_share = 1.25;

// A restart that no other leg had is played for this many ticks: past the whistle, and into play.
// So is what follows a goal.
constexpr std::uint32_t restart_ticks = 60;

// The ball of a goal that falls in the first tick: m before the goal line, m/s.
constexpr double sure_goal_distance = 0.02;
constexpr double sure_goal_speed = 2.0;

std::string seconds(double s) {
  return system::formatted("%.0f", s);
}

std::string milliseconds(double ms) {
  return system::formatted("%.3f ms", ms);
}

// Reckons what a leg of full length would take. The cheapest of the legs counts: what disturbs a
// measurement only adds to it.
void note_time(Examination& e, const TrialLeg& leg) {
  const plugins::Budget budget;
  const double played = leg.ticks() * e.setup.control_period;
  const double legs = std::max(1.0, 2.0 * e.setup.rules.half_s / played);
  const double needed = legs * leg.playing_seconds;
  const double share = needed / budget.bank_after(static_cast<std::uint32_t>(legs * leg.ticks()),
                                                  static_cast<std::uint32_t>(legs * leg.places));
  e.slept = std::max(e.slept, legs * leg.slept_seconds);
  if (e.report.leg_seconds > 0.0 && share >= e.report.leg_share) return;
  e.report.leg_seconds = needed;
  e.report.leg_share = share;
}

// A team that would lose each of its legs by its budget is told so now.
bool judge_time(Examination& e) {
  const double most_sleep = plugins::Budget().sleep;
  if (e.slept > most_sleep)
    return fail_with(e, {.what = sentence("too_much_sleep", seconds(e.slept), seconds(most_sleep)),
                         .cure = sentence("hang slept")});
  const std::string text = system::formatted(
      "a leg with halves of %g s would take %.1f s of processor time, %.0f %% of the %.1f s that a "
      "team has",
      e.setup.rules.half_s, e.report.leg_seconds, 100.0 * e.report.leg_share,
      e.report.leg_seconds / e.report.leg_share);
  if (e.report.leg_share > refused_leg_share)
    return fail_with(
        e, {.what = text, .cure = sentence(e.entry->is_python() ? "python budget" : "budget")});
  return pass(e, text);
}

// Returns starts from what no leg may have had so far: a restart, and a goal for each team.
std::vector<match::Start> missing_moments(const Examination& e) {
  using referee::Restart;
  std::vector<match::Start> starts;
  for (const Restart kind :
       {Restart::GOAL_KICK, Restart::PENALTY_KICK, Restart::FREE_KICK, Restart::FREE_BALL}) {
    for (const Team taker : both_teams) {
      if (e.restarts.count({kind, taker == Team::blue}) == 0)
        starts.emplace_back().restart = match::RestartStart{kind, taker, {}};
    }
  }
  const double line = field::make_field(e.setup.league).half_length;
  for (const double side : {-1.0, 1.0})
    starts.emplace_back().ball = simulator::BallState{{side * (line - sure_goal_distance), 0.0},
                                                      {side * sure_goal_speed, 0.0}};
  return starts;
}

// Plays restart_ticks from each as blue against idle, as long as time for the legs that are
// repeated is left. Returns false after a fault, which is added.
Result<bool> play_missing_moments(Examination& e) {
  TrialTerms terms = trial(e, Team::blue, *e.idle);
  terms.max_ticks = restart_ticks;
  const double tick = 1e-3 * e.report.mean_tick_ms;
  for (const match::Start& start : missing_moments(e)) {
    if (!e.plan.has_room_for(restart_ticks * tick, repeated_legs, tick)) break;
    terms.setup.start = start;
    MIROCUP_TRY(const auto leg, play(e, terms));
    if (leg.fault) return judge(e, leg, terms, "");
  }
  return true;
}

}  // namespace

Result<bool> load_and_answer(Examination& e) {
  TrialTerms terms = trial(e, Team::blue, *e.idle);
  terms.max_ticks = 0;
  MIROCUP_TRY(const auto loaded, play(e, terms));
  const auto is_loaded =
      judge(e, loaded, terms,
            "loads and creates its team in " + milliseconds(1e3 * loaded.start_seconds));
  if (!is_loaded || !*is_loaded) return is_loaded;

  // The legs of a test league may be over sooner.
  terms.setup.rules.half_s = std::max(e.setup.rules.half_s, first_half);
  terms.max_ticks = first_ticks;
  terms.max_seconds = max_first_seconds;
  MIROCUP_TRY(const auto first, play(e, terms));
  if (!first.fault && first.ticks() < first_ticks) {
    note_use(e, first, terms);
    const std::string by_clock = milliseconds(1e3 * max_first_seconds / first.ticks());
    return fail_with(e,
                     {.what = sentence("one_tick", by_clock, milliseconds(e.report.mean_tick_ms)),
                      .cure = sentence("hang slept")});
  }
  return judge(e, first, terms, "answers " + std::to_string(first_ticks) + " observations");
}

Result<bool> play_whole_legs(Examination& e) {
  for (const Team team : both_teams) {
    TrialTerms terms = whole_leg_terms(e, team);
    terms.is_recorded = true;
    terms.max_seconds = e.plan.share_of(team == Team::blue ? 5 : 4);  // two legs, and what follows
    MIROCUP_TRY(auto leg, play(e, terms));
    if (leg.recording && (team == Team::blue || leg.fault)) {
      e.report.gate_leg = std::move(leg.recording);
      e.report.gate_colour = team;
    }
    leg.story.opponent = "striker";
    const auto passed =
        judge(e, leg, terms,
              "plays " + seconds(leg.ticks() * e.setup.control_period) + " s of a leg" +
                  (leg.is_whole ? "" : ", shortened since it takes more than 1 ms in a tick") +
                  ": " + text_of(leg.story));
    if (leg.ticks() > 0) e.report.legs.push_back(leg.story);
    if (!passed || !*passed) return passed;
    note_time(e, leg);
    e.grown = std::max(e.grown, leg.peak_memory - std::min(leg.peak_memory, leg.memory_at_start));
    e.restarts.merge(leg.restarts);
    if (team == Team::blue) e.blue = std::move(leg);
  }
  return judge_time(e);
}

Result<bool> play_knockout(Examination& e) {
  TrialTerms terms = knockout_terms(e);
  terms.max_seconds = e.plan.share_of(1 + repeated_legs);
  MIROCUP_TRY(auto leg, play(e, terms));
  e.restarts.merge(leg.restarts);
  e.knockout = std::move(leg);
  if (!e.knockout.fault) {
    const auto passed = play_missing_moments(e);
    if (!passed || !*passed) return passed;
  }
  return judge(e, e.knockout, terms,
               e.knockout.is_whole
                   ? "plays extra time and a shoot-out"
                   : "plays " + seconds(e.knockout.ticks() * e.setup.control_period) +
                         " s of a knock-out leg");
}

}  // namespace mirocup::app
