// SPDX-License-Identifier: MIT
#include "core/replay/verification.hpp"

#include <algorithm>
#include <cstring>

namespace mirocup::replay {

namespace {

std::string name_of(const std::optional<Team>& team) {
  return team ? std::string(to_string(*team)) : "no team";
}

std::string score_text(const match::ByTeam<int>& score) {
  return std::to_string(score[0]) + ":" + std::to_string(score[1]);
}

// Returns a reason without the words that name a team, and without spaces.
std::string without_teams(std::string text) {
  for (const char* word : {"left", "right", "blue", "yellow", " "}) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word)) {
      text.erase(at, std::strlen(word));
    }
  }
  return text;
}

// Records from before 25 November 2026 name the ends where reasons now name the colours.
bool is_same_reason(const std::string& recorded, const std::string& again) {
  if (recorded == again) return true;
  const auto says = [&recorded](const char* word) {
    return recorded.find(word) != std::string::npos;
  };
  const bool is_old = says("left") || says("right") || (!says("blue") && !says("yellow"));
  return is_old && without_teams(recorded) == without_teams(again);
}

// Records of earlier versions do not say which team scored in an attempt of a shoot-out.
bool have_same_parties(const match::LoggedDecision& a, const match::LoggedDecision& b) {
  const bool is_old_attempt =
      a.decision.verdict == referee::Verdict::ATTEMPT_END && !a.parties.gainer;
  return (is_old_attempt || a.parties.gainer == b.parties.gainer) &&
         a.parties.offender == b.parties.offender;
}

// `a` is recorded, `b` played again.
bool agree(const match::LoggedDecision& a, const match::LoggedDecision& b) {
  const referee::Decision& x = a.decision;
  const referee::Decision& y = b.decision;
  // A goal that was recorded without a scorer was told from an own goal by the last touch alone.
  const bool is_old_goal = x.verdict == referee::Verdict::GOAL && !a.credit;
  return a.tick == b.tick && a.team == b.team && a.robots == b.robots && x.verdict == y.verdict &&
         (is_old_goal ||
          (x.law == y.law && is_same_reason(x.reason, y.reason) && a.credit == b.credit)) &&
         x.clock == y.clock && x.ball == y.ball && x.restart == y.restart &&
         have_same_parties(a, b) && (!a.score || a.score == b.score) &&
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
