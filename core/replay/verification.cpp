// SPDX-License-Identifier: MIT
#include "core/replay/verification.hpp"

#include <algorithm>
#include <cstring>

namespace mirocup::replay {

namespace {

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
         (x.restart == referee::Restart::none || a.taker == b.taker);
}

std::string decision_text(const match::LoggedDecision& d) {
  return std::string(to_string(d.decision.verdict)) + " at tick " + std::to_string(d.tick) +
         " (clock " + std::to_string(d.decision.clock) + " s, " +
         (d.team ? std::string(to_string(*d.team)) : "no team") + ", law " +
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

std::optional<Divergence> compare_outcomes(const Recording& recording, const match::Leg& again) {
  const match::Outcome& recorded = recording.outcome;
  const match::Outcome& replayed = again.outcome();
  if (recorded.kind == replayed.kind && recorded.score == replayed.score &&
      recorded.played == replayed.played && recorded.winner == replayed.winner &&
      recorded.shoot_out == replayed.shoot_out && recording.state_hash == again.state_hash()) {
    return std::nullopt;
  }
  return Divergence{again.tick(),
                    "the record ends " + std::string(to_string(recorded.kind)) + " " +
                        score_text(recorded.score) + " with hash " + to_hex(recording.state_hash) +
                        ", the replay " + std::string(to_string(replayed.kind)) + " " +
                        score_text(replayed.score) + " with hash " + to_hex(again.state_hash())};
}

}  // namespace

std::optional<Divergence> verify(const Recording& recording, std::uint64_t* found) {
  Playback again(recording);
  while (again.advance()) {
  }
  if (found != nullptr) *found = again.leg().state_hash();
  const auto decision = compare_decisions(recording, again.leg());
  const auto& state = again.divergence();
  if (state && (!decision || state->tick < decision->tick)) return state;
  if (decision) return decision;
  return compare_outcomes(recording, again.leg());
}

}  // namespace mirocup::replay
