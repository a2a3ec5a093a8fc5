// SPDX-License-Identifier: MIT
#include "programs/check/examination.hpp"

#include <algorithm>
#include <utility>

namespace mirocup::app {

namespace {

// A knock-out leg this short is level, so that extra time and shoot-out follow, s.
constexpr double knockout_half = 0.5;
constexpr double knockout_golden_goal = 1.0;

bool add(Examination& e, Check check) {
  e.report.checks.push_back(std::move(check));
  const Check& added = e.report.checks.back();
  if (e.on_check) e.on_check(added);
  if (*added.passed) tell_next(e);
  return *added.passed;
}

// Returns the line of the entry's own file and the tick in which it failed.
std::string place_of(const TrialLeg& leg, const TrialTerms& terms) {
  const int line = leg.fault->fault.line;
  const std::string place = line > 0 ? "line " + std::to_string(line) + " of the file, " : "";
  if (!leg.has_begun) return place + "before the first tick";
  return place + "tick " + std::to_string(leg.ticks()) + " of a leg as " +
         std::string(to_string(terms.team));
}

// Plays a leg that ended in a crash again where the team's memory is watched. Returns what was
// found there before the crash, or "".
Result<std::string> mistake_in_memory(Examination& e, const TrialTerms& terms,
                                      FaultEvidence& evidence) {
  TrialTerms careful = terms;
  careful.is_careful = true;
  e.plan.look_for_causes();
  careful.max_seconds = e.plan.share_of(1);
  MIROCUP_TRY(const auto again, play(e, careful));
  evidence.requests = again.requests;
  e.requests += again.requests;
  const bool is_found = again.fault && again.ticks() < careful.max_ticks;
  if (!is_found || !is_memory_mistake(again.fault->fault)) return std::string();
  return sentence("watched", again.fault->fault.text);
}

}  // namespace

void tell_next(const Examination& e) {
  const std::size_t next = e.report.checks.size();
  if (e.on_step && next < check_names.size())
    e.on_step(static_cast<int>(next) + 1, static_cast<int>(check_names.size()), check_names[next]);
}

bool pass(Examination& e, std::string text) {
  return add(
      e, {.name = check_names[e.report.checks.size()], .passed = true, .text = std::move(text)});
}

bool fail_with(Examination& e, Check failed) {
  failed.name = check_names[e.report.checks.size()];
  failed.passed = false;
  failed.text = failed.what + (failed.cure.empty() ? "" : ": " + failed.cure);
  failed.where = failed.where.empty() ? failed.name : failed.name + ", " + failed.where;
  return add(e, std::move(failed));
}

Result<bool> judge(Examination& e, const TrialLeg& leg, const TrialTerms& terms, std::string text) {
  note_use(e, leg, terms);
  if (!leg.fault) return pass(e, std::move(text));
  FaultEvidence evidence = *leg.fault;
  evidence.is_python = e.entry->is_python();
  std::string mistake;
  if (evidence.fault.code == match::FaultCode::crash && !terms.is_careful && !evidence.is_python) {
    MIROCUP_TRY(mistake, mistake_in_memory(e, terms, evidence));
  }
  return fail_with(
      e, {.what = evidence.fault.text + " (" + std::string(to_string(evidence.fault.code)) + ")",
          .where = place_of(leg, terms),
          .cure = advice_on(evidence) + mistake,
          .cause = evidence.fault.cause});
}

TrialTerms trial(const Examination& e, Team team, const plugins::SealedEntry& opponent) {
  return {.setup = e.setup,
          .opponent = &opponent,
          .team = team,
          .parameters = e.terms.parameters,
          .isolation = e.report.isolation};
}

TrialTerms whole_leg_terms(const Examination& e, Team team) {
  TrialTerms terms = trial(e, team, *e.striker);
  terms.setup.seed = team == Team::blue ? 1 : 2;
  return terms;
}

TrialTerms knockout_terms(const Examination& e) {
  TrialTerms terms = trial(e, Team::blue, *e.idle);
  terms.setup.stage = referee::Stage::knockout;
  terms.setup.rules.half_s = knockout_half;
  terms.setup.rules.golden_goal_s = knockout_golden_goal;
  return terms;
}

Result<TrialLeg> play(Examination& e, const TrialTerms& terms) {
  auto leg = play_trial(*e.entry, terms);
  if (leg) e.plan.add(leg->used_seconds, leg->used_to_start);
  return leg;
}

void note_use(Examination& e, const TrialLeg& leg, const TrialTerms& terms) {
  e.report.start_ms = 1e3 * leg.start_seconds;
  e.report.peak_memory = std::max(e.report.peak_memory, leg.peak_memory);
  e.report.log = leg.output;
  e.report.unknown_parameters = plugins::not_asked_for(e.terms.parameters, leg.asked_parameters);
  e.report.moved_placements += leg.moved_placements;
  for (const std::size_t kind : {0u, 1u}) {
    BadSpeeds& all = e.report.bad_speeds[kind];
    const BadSpeeds& more = leg.story.bad_speeds[kind];
    const int count = all.count + more.count;
    if (all.count == 0) all = more;
    all.count = count;
  }
  if (leg.ticks() == 0 || terms.is_careful) return;  // a careful process takes longer
  e.report.slowest_tick_ms = std::max(e.report.slowest_tick_ms, leg.slowest_tick_ms);
  e.report.mean_tick_ms = 1e3 * leg.playing_seconds / leg.ticks();
  // In a leg of full length the bank's fixed part hardly counts.
  e.report.bank_share = e.report.mean_tick_ms / (1e3 * plugins::Budget().bank_per_tick);
}

void note(Examination& e, const char* code, const std::string& first, const std::string& second) {
  e.report.notes.push_back({code, sentence(code, first, second)});
}

bool is_memory_mistake(const match::Fault& fault) {
  return fault.cause == "memory" || fault.cause == "command";
}

}  // namespace mirocup::app
