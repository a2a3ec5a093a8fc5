// SPDX-License-Identifier: MIT
#include "core/replay/rejudge.hpp"

#include "core/replay/verification.hpp"

#include <utility>

namespace mirocup::replay {

namespace {

using match::LoggedDecision;
using referee::Decision;

// Returns the first decision about play, starting at an index.
std::optional<LoggedDecision> decision_since(const match::Leg& leg, std::size_t from) {
  using referee::Verdict;
  for (std::size_t i = from; i < leg.decisions().size(); ++i) {
    const LoggedDecision& logged = leg.decisions()[i];
    const Verdict verdict = logged.decision.verdict;
    if (verdict != Verdict::NONE && verdict != Verdict::PLACEMENT_FIXED) return logged;
  }
  return std::nullopt;
}

LoggedDecision logged(const Decision& decision, std::uint32_t tick, Team left) {
  const auto team_at = [left](End end) { return end == End::left ? left : opponent_of(left); };
  LoggedDecision result;
  result.tick = tick;
  result.decision = decision;
  if (decision.team) result.team = team_at(*decision.team);
  result.taker = team_at(decision.taker);
  for (const End end : both_ends) {
    result.robots[index_of(team_at(end))] = decision.robots[index_of(end)];
  }
  return result;
}

bool is_same_call(const LoggedDecision& a, const LoggedDecision& b) {
  // Whose goal it is, is not the referee's to say.
  const bool same_law =
      a.decision.law == b.decision.law || a.decision.verdict == referee::Verdict::GOAL;
  return a.decision.verdict == b.decision.verdict && same_law &&
         a.decision.goal_cancelled == b.decision.goal_cancelled && a.team == b.team &&
         a.taker == b.taker;
}

// The second referee, which judges the situations of a leg without acting on it.
class SecondReferee {
 public:
  SecondReferee(const match::Leg& leg, const referee::Rules& rules)
      : leg_(leg),
        pitch_{.field = leg.field(),
               .rules = rules,
               .ball_radius = leg.pitch().ball_radius,
               .robot_side = leg.pitch().robot_side},
        referee_(std::in_place, pitch_, leg.referee().progress()) {
    referee_->resume(leg.restart());
  }

  // Compares the two referees after a tick. Before the tick the leg had `decisions_before`
  // decisions and the team `left` at the left end.
  std::optional<Difference> compare_tick(std::uint32_t tick, std::size_t decisions_before,
                                         Team left) {
    Difference difference;
    difference.tick = tick;
    difference.given = decision_since(leg_, decisions_before);
    std::optional<Decision> would_be;
    if (leg_.judged()) would_be = referee_->judge(*leg_.judged()).decision;
    // A phase that it has ended goes on in the leg: that is reported once.
    const bool ends_phase = would_be && would_be->restart == referee::Restart::none;
    if (ends_phase && std::exchange(said_phase_is_over_, true)) would_be.reset();
    if (would_be) difference.would_be = logged(*would_be, tick, left);

    if (difference.given) {
      referee_.emplace(pitch_, leg_.referee().progress());
      referee_->resume(leg_.restart());
      if (difference.given->decision.restart == referee::Restart::none) said_phase_is_over_ = false;
    } else if (would_be) {
      referee_->resume(Decision{});
    } else if (leg_.snapshot().state == match::State::READY) {
      referee_->resume(leg_.restart());  // a team may have moved the ball
    }
    const bool both = difference.given && difference.would_be;
    if (!difference.given && !difference.would_be) return std::nullopt;
    if (both && is_same_call(*difference.given, *difference.would_be)) return std::nullopt;
    return difference;
  }

 private:
  const match::Leg& leg_;
  referee::JudgedField pitch_;
  std::optional<referee::Referee> referee_;  // replaced at every stoppage
  bool said_phase_is_over_ = false;
};

}  // namespace

tl::expected<std::vector<Difference>, Divergence> rejudge(const Recording& recording,
                                                          const referee::Rules& rules) {
  Playback playback(recording);
  const match::Leg& again = playback.leg();
  SecondReferee second(again, rules);
  std::vector<Difference> differences;
  while (!again.is_over() && again.tick() < recording.ticks.size()) {
    const std::uint32_t tick = again.tick();
    const std::size_t decisions = again.decisions().size();
    const Team left = again.snapshot().left;
    if (!playback.advance()) break;
    if (auto difference = second.compare_tick(tick, decisions, left)) {
      differences.push_back(*std::move(difference));
    }
  }
  while (playback.advance()) {  // a fault after the last tick
  }
  if (playback.divergence()) return tl::unexpected(*playback.divergence());
  if (auto other = compare_results(recording, again)) return tl::unexpected(*std::move(other));
  return differences;
}

}  // namespace mirocup::replay
