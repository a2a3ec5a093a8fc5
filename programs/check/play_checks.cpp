// SPDX-License-Identifier: MIT
//
// The checks in which the entry plays: a first answer, whole legs, a knock-out leg.
#include "core/field/field.hpp"
#include "plugins/host/sandbox/probe.hpp"
#include "programs/check/examination.hpp"
#include "system/locations.hpp"
#include "system/text.hpp"

#include <algorithm>

namespace mirocup::app {

namespace {

constexpr std::uint32_t first_ticks = 100;
// A team that needs this long for the first ticks waits or computes too long in each, s.
constexpr double max_first_seconds = 2.0;
constexpr double first_half = 10.0;  // s; longer than the first ticks

// An entry is refused if it would use this many times the processor time that its leg gives. The
// time that a team uses changes by less than that on a busy machine.
constexpr double refused_leg_share = 1.25;

// A restart is played for this many ticks: past the whistle, and into play. So is what follows a
// goal.
constexpr std::uint32_t restart_ticks = 60;

// The ball of a goal that falls in the first tick: m before the goal line, m/s.
constexpr double sure_goal_distance = 0.02;
constexpr double sure_goal_speed = 2.0;

Result<Check> load(Examination& e) {
  MIROCUP_TRY(e.report.isolation, plugins::strongest_isolation());
  MIROCUP_TRY(e.idle, plugins::SealedEntry::open(system::house_team("idle")));
  MIROCUP_TRY(e.striker, plugins::SealedEntry::open(system::house_team("striker")));
  const TrialTerms terms{e.setup, &*e.idle, Team::blue, 0};
  MIROCUP_TRY(const auto leg, play(e, terms));
  return judge(e, leg, terms,
               system::formatted("loads and creates its team in %.3f ms", 1e3 * leg.start_seconds));
}

Result<Check> answer(Examination& e) {
  TrialTerms terms{e.setup, &*e.idle};
  // The legs of a test league may be over sooner.
  terms.setup.rules.half_s = std::max(e.setup.rules.half_s, first_half);
  terms.max_ticks = first_ticks;
  terms.max_seconds = max_first_seconds;
  MIROCUP_TRY(const auto leg, play(e, terms));
  if (leg.fault || leg.ticks() == first_ticks)
    return judge(e, leg, terms, "answers " + std::to_string(first_ticks) + " observations");
  note_use(e, leg, terms);
  const double by_clock = 1e3 * max_first_seconds / leg.ticks();
  return failed(sentence("one_tick", system::formatted("%.3f ms", by_clock),
                         system::formatted("%.3f ms", e.report.mean_tick_ms)),
                sentence("hang slept"));
}

template <Team team>
Result<Check> play_whole_leg(Examination& e) {
  TrialTerms terms{e.setup, &*e.striker, team};
  terms.setup.seed = 1 + index_of(team);
  terms.max_seconds = e.plan.share_of(5 - index_of(team));  // with the legs that follow
  TrialLeg& leg = e.whole[index_of(team)];
  MIROCUP_TRY(leg, play(e, terms));
  if (leg.recording && (team == Team::blue || leg.fault))
    e.report.gate_leg.emplace(team, *leg.recording);
  if (leg.ticks() > 0) e.report.legs.push_back(leg.story);
  const char* const length =
      leg.recording ? "" : ", shortened since it takes more than 1 ms in a tick";
  return judge(
      e, leg, terms,
      system::formatted("plays %.0f s of a leg%s: %s", leg.ticks() * e.setup.control_period, length,
                        text_of(leg.story).c_str()));
}

// Reckons what a leg of full length would take. The cheapest of the legs counts: what disturbs a
// measurement only adds to it. A team that would lose each of its legs by its budget is told so
// now.
Result<Check> judge_time(Examination& e) {
  const plugins::Budget budget;
  double slept = 0.0;
  for (const TrialLeg& leg : e.whole) {
    const double played = leg.ticks() * e.setup.control_period;
    const double legs = std::max(1.0, 2.0 * e.setup.rules.half_s / played);
    const double needed = legs * leg.playing_seconds;
    const double share = needed / budget.bank_after(static_cast<std::uint32_t>(legs * leg.ticks()),
                                                    static_cast<std::uint32_t>(legs * leg.places));
    slept = std::max(slept, legs * leg.slept_seconds);
    if (e.report.leg_seconds > 0.0 && share >= e.report.leg_share) continue;
    e.report.leg_seconds = needed;
    e.report.leg_share = share;
  }
  if (slept > budget.sleep)
    return failed(sentence("too_much_sleep", system::formatted("%.0f", slept),
                           system::formatted("%.0f", budget.sleep)),
                  sentence("hang slept"));
  const std::string text = system::formatted(
      "a leg with halves of %g s would take %.1f s of processor time, %.0f %% of the %.1f s that a "
      "team has",
      e.setup.rules.half_s, e.report.leg_seconds, 100.0 * e.report.leg_share,
      e.report.leg_seconds / e.report.leg_share);
  if (e.report.leg_share > refused_leg_share)
    return failed(text, sentence(e.entry->is_python() ? "python budget" : "budget"));
  return passed(text);
}

// Returns starts from what the legs may not have had: each restart, and a goal for each team.
std::vector<match::Start> rare_moments(const Examination& e) {
  using referee::Restart;
  std::vector<match::Start> starts;
  for (const Restart kind :
       {Restart::GOAL_KICK, Restart::PENALTY_KICK, Restart::FREE_KICK, Restart::FREE_BALL}) {
    for (const Team taker : both_teams)
      starts.emplace_back().restart = match::RestartStart{kind, taker, {}};
  }
  const double line = field::make_field(e.setup.league).half_length;
  for (const double side : {-1.0, 1.0})
    starts.emplace_back().ball = simulator::BallState{{side * (line - sure_goal_distance), 0.0},
                                                      {side * sure_goal_speed, 0.0}};
  return starts;
}

// Plays the knock-out leg, and restart_ticks from each rare moment as blue against idle, as long as
// time for the legs that are repeated is left.
Result<Check> play_knockout(Examination& e) {
  const TrialTerms terms = knockout_terms(e, 1 + repeated_legs);
  MIROCUP_TRY(e.knockout, play(e, terms));
  TrialTerms rare{e.setup, &*e.idle, Team::blue, restart_ticks};
  const double tick = 1e-3 * e.report.mean_tick_ms;
  for (const match::Start& start : rare_moments(e)) {
    if (e.knockout.fault || !e.plan.has_room_for(restart_ticks * tick, repeated_legs, tick)) break;
    rare.setup.start = start;
    MIROCUP_TRY(const auto leg, play(e, rare));
    if (leg.fault) return judge(e, leg, rare, "");
  }
  return judge(e, e.knockout, terms,
               e.knockout.recording
                   ? "plays extra time and a shoot-out"
                   : system::formatted("plays %.0f s of a knock-out leg",
                                       e.knockout.ticks() * e.setup.control_period));
}

}  // namespace

const std::vector<Step> play_checks{{"loads", load},
                                    {"ticks", answer},
                                    {"leg_blue", play_whole_leg<Team::blue>},
                                    {"leg_yellow", play_whole_leg<Team::yellow>},
                                    {"budget", judge_time},
                                    {"knockout", play_knockout}};

}  // namespace mirocup::app
