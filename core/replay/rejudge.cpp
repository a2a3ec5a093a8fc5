// SPDX-License-Identifier: MIT
#include "core/replay/rejudge.hpp"

#include "core/replay/recorded.hpp"

#include <utility>

namespace mirocup::replay {

namespace {

using match::LoggedDecision;
using referee::Decision;

// The first decision about play among those from an index on.
std::optional<LoggedDecision> decision_since(const match::Match& match, std::size_t from) {
  using referee::Verdict;
  for (std::size_t i = from; i < match.decisions().size(); ++i) {
    const LoggedDecision& logged = match.decisions()[i];
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

bool is_same(const LoggedDecision& a, const LoggedDecision& b) {
  return a.decision.verdict == b.decision.verdict && a.decision.law == b.decision.law &&
         a.decision.goal_cancelled == b.decision.goal_cancelled && a.team == b.team &&
         a.taker == b.taker;
}

// The second referee.
class Onlooker {
 public:
  Onlooker(const match::Match& match, const referee::Rules& rules)
      : match_(match),
        pitch_{match.field(), rules, match.setup().parameters.ball_radius,
               match.setup().parameters.robot_side},
        referee_(std::in_place, pitch_, match.referee().progress()) {
    referee_->resume(match.restart());
  }

  // After a tick of the match, before which it had so many decisions and this team at the left end.
  std::optional<Difference> look(std::uint32_t tick, std::size_t decisions_before, Team left) {
    Difference difference;
    difference.tick = tick;
    difference.given = decision_since(match_, decisions_before);
    std::optional<Decision> would_be;
    if (match_.judged()) would_be = referee_->judge(*match_.judged()).decision;
    // A phase that is over for it goes on in the match: to say so once is enough.
    const bool ends_phase = would_be && would_be->restart == referee::Restart::none;
    if (ends_phase && std::exchange(said_phase_is_over_, true)) would_be.reset();
    if (would_be) difference.would_be = logged(*would_be, tick, left);

    if (difference.given) {
      referee_.emplace(pitch_, match_.referee().progress());
      referee_->resume(match_.restart());
      if (difference.given->decision.restart == referee::Restart::none) said_phase_is_over_ = false;
    } else if (would_be) {
      referee_->resume(Decision{});
    } else if (match_.scene().state == match::State::READY) {
      referee_->resume(match_.restart());  // a team may have moved the ball
    }
    const bool both = difference.given && difference.would_be;
    if (!difference.given && !difference.would_be) return std::nullopt;
    if (both && is_same(*difference.given, *difference.would_be)) return std::nullopt;
    return difference;
  }

 private:
  const match::Match& match_;
  referee::Pitch pitch_;
  std::optional<referee::Referee> referee_;  // made anew at every stoppage
  bool said_phase_is_over_ = false;
};

}  // namespace

std::vector<Difference> appeal(const Recording& recording, const referee::Rules& rules) {
  match::Match again(recording.setup);
  Onlooker onlooker(again, rules);
  std::vector<Difference> differences;
  while (!again.is_over() && again.tick() < recording.ticks.size()) {
    const std::uint32_t tick = again.tick();
    const std::size_t decisions = again.decisions().size();
    const Team left = again.scene().left;
    again.advance(recorded_answers(recording, tick));
    if (auto difference = onlooker.look(tick, decisions, left)) {
      differences.push_back(*std::move(difference));
    }
  }
  return differences;
}

}  // namespace mirocup::replay
