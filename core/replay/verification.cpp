// SPDX-License-Identifier: MIT
#include "core/replay/verification.hpp"

#include "core/replay/recorded.hpp"

#include <algorithm>

namespace mirocup::replay {

namespace {

std::string score_text(const match::ByTeam<int>& score) {
  return std::to_string(score[0]) + ":" + std::to_string(score[1]);
}

std::optional<Divergence> compare_decision(const match::LoggedDecision& recorded,
                                           const match::LoggedDecision& again) {
  const auto text = [](const match::LoggedDecision& d) {
    return std::string(to_string(d.decision.verdict)) + " (" + d.decision.reason + ") at tick " +
           std::to_string(d.tick);
  };
  if (text(recorded) == text(again) && recorded.team == again.team) return std::nullopt;
  return Divergence{std::min(recorded.tick, again.tick),
                    "the record says " + text(recorded) + ", the replay says " + text(again)};
}

std::optional<Divergence> compare_decisions(const Recording& recording, const match::Match& again) {
  const auto& recorded = recording.decisions;
  const auto& replayed = again.decisions();
  for (std::size_t i = 0; i < std::min(recorded.size(), replayed.size()); ++i) {
    if (auto difference = compare_decision(recorded[i], replayed[i])) return difference;
  }
  if (recorded.size() == replayed.size()) return std::nullopt;
  return Divergence{again.tick(), "the record has " + std::to_string(recorded.size()) +
                                      " decisions, the replay " + std::to_string(replayed.size())};
}

std::optional<Divergence> compare_result(const Recording& recording, const match::Match& again) {
  const match::Result& recorded = recording.result;
  const match::Result& replayed = again.result();
  if (recorded.end == replayed.end && recorded.score == replayed.score &&
      recorded.winner == replayed.winner && recording.state_hash == again.state_hash()) {
    return std::nullopt;
  }
  return Divergence{again.tick(),
                    "the record ends " + std::string(to_string(recorded.end)) + " " +
                        score_text(recorded.score) + " with hash " + to_hex(recording.state_hash) +
                        ", the replay " + std::string(to_string(replayed.end)) + " " +
                        score_text(replayed.score) + " with hash " + to_hex(again.state_hash())};
}

}  // namespace

std::optional<Divergence> verify(const Recording& recording) {
  match::Match again(recording.setup);
  Recorded blue(recording, Team::blue);
  Recorded yellow(recording, Team::yellow);
  while (!again.is_over()) {
    const std::uint32_t tick = again.tick();
    if (tick > recording.ticks.size()) {
      return Divergence{tick, "the record ends here, the replay goes on"};
    }
    again.advance(blue, yellow);
    if (again.log().size() <= tick) break;  // ended before anything moved
    if (tick >= recording.ticks.size()) {
      return Divergence{tick, "the record ends here, the replay goes on"};
    }
    const std::uint64_t expected = recording.ticks[tick].hash;
    if (again.log()[tick].hash != expected) {
      return Divergence{tick, "the state differs: the record's hash is " + to_hex(expected) +
                                  ", the replay's " + to_hex(again.log()[tick].hash)};
    }
  }
  if (auto difference = compare_decisions(recording, again)) return difference;
  if (again.log().size() != recording.ticks.size()) {
    return Divergence{again.tick(), "the replay ends here, the record goes on"};
  }
  return compare_result(recording, again);
}

}  // namespace mirocup::replay
