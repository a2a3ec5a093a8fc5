// SPDX-License-Identifier: MIT
//
// One leg that an entry plays in the sandbox so that `mirocup check` can look at it.
#include "plugins/host/host_program.hpp"
#include "programs/check/examination.hpp"
#include "server/pace/pacer.hpp"

#include <algorithm>
#include <ctime>
#include <memory>
#include <unistd.h>

namespace mirocup::app {

namespace {

using Seats = std::array<std::unique_ptr<plugins::ProcessController>, 2>;

// A knock-out leg this short is level, so that extra time and shoot-out follow, s.
constexpr double knockout_half = 0.5;
constexpr double knockout_golden_goal = 1.0;

// The budget is stricter than in a match where the team computes for ever, so that its author
// learns it soon. Its wall time is that of a match: on a busy machine a good team may need long to
// start. The bank has no end, because a leg stops when it has used its share, and how much a whole
// leg takes is reckoned from the time that was used.
Result<Seats> start_teams(const Examination& e, const match::Leg& leg, const TrialTerms& terms) {
  plugins::ProcessTerms process_terms;
  process_terms.isolation = e.report.isolation;
  process_terms.budget.start_cpu = CheckPlan::most_start;
  process_terms.budget.bank = infinity;
  Seats seats;
  for (const Team team : both_teams) {
    const bool is_own = team == terms.team;
    process_terms.surroundings = is_own ? terms.surroundings : plugins::Surroundings();
    const plugins::SealedEntry& played = is_own ? *e.entry : *terms.opponent;
    const auto care = is_own && terms.is_careful ? plugins::Care::watched : plugins::Care::none;
    MIROCUP_TRY(const auto program, plugins::host_program(played, care));
    MIROCUP_TRY(seats[index_of(team)],
                plugins::ProcessController::start(
                    program, played, leg.briefing(team),
                    is_own ? e.terms.parameters : match::TeamParameters(), process_terms));
  }
  return seats;
}

}  // namespace

TrialTerms knockout_terms(const Examination& e, int legs) {
  TrialTerms terms{e.setup, &*e.idle};
  terms.max_seconds = e.plan.share_of(legs);
  terms.setup.stage = referee::Stage::knockout;
  terms.setup.rules.half_s = knockout_half;
  terms.setup.rules.golden_goal_s = knockout_golden_goal;
  return terms;
}

Result<TrialLeg> play(Examination& e, const TrialTerms& terms) {
  const auto own_seconds = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  const auto own_delay = [] { return plugins::Child::processor_delay(getpid()).value_or(0.0); };
  const double own_before = own_seconds();
  const double delay_before = own_delay();
  TrialLeg played;
  match::Leg leg(terms.setup);
  MIROCUP_TRY(const Seats seats, start_teams(e, leg, terms));
  plugins::ProcessController& own = *seats[index_of(terms.team)];

  for (const auto& seat : seats) {
    const auto ready = seat->wait_until_ready();
    if (ready) continue;
    if (const auto* failure = std::get_if<match::HostFailure>(&ready.error()))
      return fail(Errc::host, failure->text);
    if (seat.get() != &own) return fail(Errc::host, std::get<match::Fault>(ready.error()).text);
    played.fault = std::get<match::Fault>(ready.error());
  }
  const std::size_t memory_at_start = own.peak_memory();
  const auto processor = [&] {
    return own_seconds() - own_before + seats[0]->cpu_seconds() + seats[1]->cpu_seconds();
  };
  // The controller subtracts all delay of this process, including that of the legs before.
  const auto slept = [&] {
    const auto seconds = own.slept_seconds();
    return seconds ? std::max(0.0, *seconds + delay_before) : 0.0;
  };
  // All delays are subtracted, also those at the same time, because a busy machine is not the
  // entry's fault.
  double delay = own_delay() - delay_before;
  for (const auto& seat : seats) delay += seat->processor_delay().value_or(0.0);
  const double slept_to_start = std::max(0.0, own.start_seconds() - own.cpu_seconds() - delay);
  const double used_to_start = processor() + slept_to_start;
  pace::SteadyWallClock clock;
  const double start = clock.now();
  // An entry that slept has taken at least as long on the clock, so that is looked at first.
  const auto is_over_time = [&] {
    const double may_use = CheckPlan::most_use(terms.max_seconds, leg.tick(), terms.is_careful);
    const double used = own.playing_seconds();
    return used > may_use || (clock.now() - start > may_use && used + slept() > may_use);
  };
  WatchedTeam watched(own, leg, terms.team, terms.show);
  match::Controller& other = *seats[1 - index_of(terms.team)];
  while (!played.fault && !leg.is_over() && leg.tick() < terms.max_ticks && !is_over_time()) {
    terms.team == Team::blue ? leg.advance(watched, other) : leg.advance(other, watched);
    watched.look();
  }
  if (leg.is_over()) {
    if (leg.outcome().kind == match::OutcomeKind::void_)
      return fail(Errc::host, leg.outcome().why_void);
    for (const match::TeamFault& of_a_team : leg.outcome().faults) {
      if (of_a_team.team != terms.team) return fail(Errc::host, of_a_team.fault.text);
      played.fault = of_a_team.fault;
    }
  }

  e.requests += own.requests();
  played.words = own.exit_report();
  played.log = leg.log();
  if (leg.is_over()) played.recording = replay::record(leg);
  played.story = watched.story();
  played.start_seconds = own.start_seconds();
  played.playing_seconds = own.playing_seconds();
  played.slowest_tick_ms = own.slowest_tick_ms();
  played.places = own.placements_asked();
  played.slept_seconds = slept();
  e.plan.add(processor() + slept_to_start + played.slept_seconds, used_to_start);
  played.peak_memory = own.peak_memory();
  // The kernel's counters are not exact.
  if (!played.fault)
    played.grown = played.peak_memory - std::min(played.peak_memory, memory_at_start);
  played.output = own.output();
  played.asked_parameters = own.asked_parameters();
  return played;
}

}  // namespace mirocup::app
