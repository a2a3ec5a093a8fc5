// SPDX-License-Identifier: MIT
#include "core/replay/verification.hpp"

#include <algorithm>

namespace mirocup::replay {

namespace {

std::string name_of(const std::optional<Team>& team) {
  return team ? std::string(to_string(*team)) : "no team";
}

std::string score_text(const match::ByTeam<int>& score) {
  return std::to_string(score[0]) + ":" + std::to_string(score[1]);
}

bool agree(const match::LoggedDecision& a, const match::LoggedDecision& b) {
  const referee::Decision& x = a.decision;
  const referee::Decision& y = b.decision;
  return a.tick == b.tick && a.team == b.team && a.robots == b.robots && a.credit == b.credit &&
         a.parties == b.parties && a.score == b.score && x.verdict == y.verdict && x.law == y.law &&
         x.reason == y.reason && x.clock == y.clock && x.ball == y.ball && x.restart == y.restart &&
         (x.restart == referee::Restart::none || a.taker == b.taker);
}

std::string decision_text(const match::LoggedDecision& d) {
  return std::string(to_string(d.decision.verdict)) + " at tick " + std::to_string(d.tick) +
         " (clock " + std::to_string(d.decision.clock) + " s, " + name_of(d.team) + ", for " +
         name_of(d.parties.gainer) + ", against " + name_of(d.parties.offender) + ", law " +
         std::string(to_string(d.decision.law)) + ", ball at " +
         std::to_string(d.decision.ball.x()) + ", " + std::to_string(d.decision.ball.y()) + ": " +
         d.decision.reason + ")";
}

std::optional<Divergence> compare_decisions(const Recording& recording, const match::Leg& again) {
  const auto& recorded = recording.decisions;
  const auto& replayed = again.decisions();
  for (std::size_t i = 0; i < std::min(recorded.size(), replayed.size()); ++i) {
    if (agree(recorded[i], replayed[i])) continue;
    return Divergence{std::min(recorded[i].tick, replayed[i].tick),
                      "the record says " + decision_text(recorded[i]) + ", the replay says " +
                          decision_text(replayed[i])};
  }
  if (recorded.size() == replayed.size()) return std::nullopt;
  return Divergence{again.tick(), "the record has " + std::to_string(recorded.size()) +
                                      " decisions, the replay " + std::to_string(replayed.size())};
}

// Returns an outcome without the words of faults, which may be others when the teams play again.
std::string outcome_text(const match::Outcome& outcome, std::uint64_t hash) {
  std::string text = std::string(to_string(outcome.kind)) + " " + score_text(outcome.score);
  if (outcome.played != outcome.score) text += ", played " + score_text(outcome.played);
  if (outcome.shoot_out) text += ", shoot-out " + score_text(*outcome.shoot_out);
  text += ", winner " + name_of(outcome.winner);
  for (const Team team : both_teams) {
    for (const match::TeamFault& f : outcome.faults) {
      if (f.team == team) text += ", " + name_of(team) + " " + std::string(to_string(f.fault.code));
    }
  }
  return text + ", with hash " + to_hex(hash);
}

std::optional<Divergence> compare_outcomes(const Recording& recording, const match::Leg& again) {
  const std::string recorded = outcome_text(recording.outcome, recording.state_hash);
  const std::string replayed = outcome_text(again.outcome(), again.state_hash());
  if (recorded == replayed) return std::nullopt;
  return Divergence{again.tick(), "the record ends " + recorded + ", the replay " + replayed};
}

}  // namespace

std::optional<Divergence> verify(const Recording& recording, std::uint64_t* found) {
  Playback again(recording);
  while (again.advance()) {
  }
  if (found != nullptr) *found = again.leg().state_hash();
  const auto& state = again.divergence();
  if (!state) return compare_results(recording, again.leg());
  const auto decision = compare_decisions(recording, again.leg());
  return decision && decision->tick <= state->tick ? decision : state;
}

std::optional<Divergence> compare_results(const Recording& recording, const match::Leg& again) {
  const auto decision = compare_decisions(recording, again);
  return decision ? decision : compare_outcomes(recording, again);
}

}  // namespace mirocup::replay
