// SPDX-License-Identifier: MIT
#include "programs/check/trial_leg.hpp"

#include "plugins/host/host_program.hpp"
#include "server/pace/pacer.hpp"
#include "system/locations.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <memory>
#include <unistd.h>

namespace mirocup::app {

namespace {

using Seats = std::array<std::unique_ptr<plugins::ProcessController>, 2>;

// The bank of a trial leg, as a multiple of a match's. How much a whole leg takes is reckoned from
// the time that was used. So a team that is too slow is told by how much, and a careful process,
// which looks at memory in each tick, has enough.
constexpr double larger_bank = 50.0;

// Stricter than in a match where the team computes for ever, so that its author learns it soon. Its
// wall time is that of a match: on a busy machine a good team may need long to start.
plugins::Budget trial_budget() {
  plugins::Budget budget;
  budget.start_cpu = CheckPlan::most_start;
  budget.bank *= larger_bank;
  budget.bank_per_tick *= larger_bank;
  budget.bank_per_place *= larger_bank;
  return budget;
}

Result<Seats> start_teams(const plugins::SealedEntry& entry, const match::Leg& leg,
                          const TrialTerms& terms) {
  plugins::ProcessTerms process_terms;
  process_terms.isolation = terms.isolation;
  Seats seats;
  for (const Team team : both_teams) {
    const bool is_own = team == terms.team;
    process_terms.budget = is_own ? trial_budget() : plugins::Budget();
    process_terms.surroundings = is_own ? terms.surroundings : plugins::Surroundings();
    const plugins::SealedEntry& played = is_own ? entry : *terms.opponent;
    MIROCUP_TRY(const auto program,
                plugins::host_program(played, is_own && terms.is_careful ? plugins::Care::watched
                                                                         : plugins::Care::none));
    MIROCUP_TRY(seats[index_of(team)],
                plugins::ProcessController::start(
                    program, played, leg.briefing(team),
                    is_own ? terms.parameters : match::TeamParameters(), process_terms));
  }
  return seats;
}

// Returns the time for which this process and those of the teams were runnable without a
// processor, s.
double delay_of(const Seats& seats) {
  double sum = plugins::Child::processor_delay(getpid()).value_or(0.0);
  for (const auto& seat : seats) sum += seat->processor_delay().value_or(0.0);
  return sum;
}

// Measures what a leg uses, as CheckPlan counts it.
class Meter {
 public:
  Meter() : own_before_(own_seconds()), delay_before_(own_delay()) {}

  // Returns the processor time of this process and of the teams so far, s.
  double processor(const Seats& seats) const {
    return own_seconds() - own_before_ + seats[0]->cpu_seconds() + seats[1]->cpu_seconds();
  }

  // Returns for how long the entry slept while it was loaded, s. Its teams have just started. All
  // delays are subtracted, also those at the same time, because a busy machine is not its fault.
  double slept_to_start(const plugins::ProcessController& own, const Seats& seats) const {
    return std::max(0.0,
                    own.start_seconds() - own.cpu_seconds() - (delay_of(seats) - delay_before_));
  }

  // Returns for how long the entry slept while it played, s. The controller subtracts all delay of
  // this process, including that of the legs before.
  double slept(const plugins::ProcessController& own) const {
    const auto slept = own.slept_seconds();
    return slept ? std::max(0.0, *slept + delay_before_) : 0.0;
  }

 private:
  static double own_delay() { return plugins::Child::processor_delay(getpid()).value_or(0.0); }
  static double own_seconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }

  double own_before_;
  double delay_before_;
};

int moved_placements(const match::Leg& leg, Team team) {
  return static_cast<int>(std::count_if(
      leg.decisions().begin(), leg.decisions().end(), [team](const match::LoggedDecision& logged) {
        return logged.decision.verdict == referee::Verdict::PLACEMENT_FIXED && logged.team == team;
      }));
}

std::set<MetRestart> met_restarts(const match::Leg& leg, Team team) {
  std::set<MetRestart> met;
  for (const match::LoggedDecision& logged : leg.decisions())
    met.insert({logged.decision.restart, logged.taker == team});
  return met;
}

}  // namespace

Result<TrialLeg> play_trial(const plugins::SealedEntry& entry, const TrialTerms& terms) {
  const Meter meter;
  match::Leg leg(terms.setup);
  MIROCUP_TRY(const Seats seats, start_teams(entry, leg, terms));
  plugins::ProcessController& own = *seats[index_of(terms.team)];

  std::optional<match::Fault> fault;
  for (const auto& seat : seats) {
    const auto ready = seat->wait_until_ready();
    if (ready) continue;
    if (const auto* failure = std::get_if<match::HostFailure>(&ready.error()))
      return fail(Errc::host, failure->text);
    if (seat.get() != &own) return fail(Errc::host, std::get<match::Fault>(ready.error()).text);
    fault = std::get<match::Fault>(ready.error());
  }
  const std::size_t memory_at_start = own.peak_memory();
  const double slept_to_start = meter.slept_to_start(own, seats);
  const double used_to_start = meter.processor(seats) + slept_to_start;
  pace::SteadyWallClock clock;
  const double start = clock.now();
  // An entry that slept has taken at least as long on the clock, so that is looked at first.
  const auto is_over_time = [&] {
    const double used = meter.processor(seats) - (used_to_start - slept_to_start);
    return used > terms.max_seconds ||
           (clock.now() - start > terms.max_seconds && used + meter.slept(own) > terms.max_seconds);
  };
  LegWatch watch(leg, terms.team);
  const bool has_begun = !fault && terms.max_ticks > 0;
  while (!fault && !leg.is_over() && leg.tick() < terms.max_ticks && !is_over_time()) {
    leg.advance(*seats[0], *seats[1]);
    watch.look();
  }
  if (leg.is_over()) {
    if (leg.outcome().kind == match::OutcomeKind::void_)
      return fail(Errc::host, leg.outcome().why_void);
    for (const match::TeamFault& of_a_team : leg.outcome().faults) {
      if (of_a_team.team != terms.team) return fail(Errc::host, of_a_team.fault.text);
      fault = of_a_team.fault;
    }
  }

  TrialLeg played;
  played.requests = own.requests();
  if (fault) played.fault = FaultEvidence{*fault, own.exit_report(), played.requests};
  played.has_begun = has_begun;
  played.log = leg.log();
  if (leg.is_over() && terms.is_recorded) played.recording = replay::record(leg);
  played.story = watch.story();
  played.bad_values = leg.bad_values()[index_of(terms.team)];
  played.moved_placements = moved_placements(leg, terms.team);
  played.start_seconds = own.start_seconds();
  played.playing_seconds = own.playing_seconds();
  played.slowest_tick_ms = own.slowest_tick_ms();
  played.places = own.placements_asked();
  played.slept_seconds = meter.slept(own);
  played.used_seconds = meter.processor(seats) + slept_to_start + played.slept_seconds;
  played.used_to_start = used_to_start;
  played.is_whole = leg.is_over();
  played.restarts = met_restarts(leg, terms.team);
  played.memory_at_start = memory_at_start;
  played.peak_memory = own.peak_memory();
  played.output = own.output();
  played.asked_parameters = own.asked_parameters();
  return played;
}

}  // namespace mirocup::app
