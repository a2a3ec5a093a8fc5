// SPDX-License-Identifier: MIT
#include "core/referee/law_book.hpp"

#include <utility>

namespace mirocup::referee {

namespace {

// Lets a foul wait for a goal. A second foul in the same tick becomes a note; later ones are
// dropped while the first waits.
void wait_for_goal(std::optional<Decision> foul, Advantage& advantage, Judgement& judgement) {
  if (!foul) return;
  if (!advantage.foul) {
    advantage = {std::move(foul), 0.0};
  } else if (advantage.for_s == 0.0) {
    judgement.note(*std::move(foul));
  }
}

// True if the ball, at its present velocity, could cross the goal line of that end within the time
// of the advantage.
bool may_come_in(const JudgedField& pitch, const TickFacts& s, End end) {
  if (s.duration <= 0.0) return false;
  const double out = -attack_sign(end);
  const double distance = pitch.field.half_length + pitch.ball_radius - out * s.ball.x();
  const double speed = out * (s.ball.x() - s.ball_before.x()) / s.duration;
  return speed * pitch.rules.advantage_s >= distance;
}

}  // namespace

void Judgement::call(std::optional<Decision> called) {
  if (!called) return;
  if (decision || called->verdict == Verdict::NONE) {
    note(*std::move(called));
  } else {
    decision = std::move(called);
  }
}

void Judgement::note(Decision noted) {
  noted.verdict = Verdict::NONE;
  noted.restart = Restart::none;
  notes.push_back(std::move(noted));
}

Decision advantage_is_over(const TickFacts& s, Advantage& advantage) {
  Decision foul = *std::exchange(advantage.foul, std::nullopt);
  if (advantage.for_s > 0.0) {
    foul.reason += "; no goal came in the " + fixed(advantage.for_s, 2) + " s after it";
  }
  foul.clock = s.begin + s.duration;
  foul.ball = s.ball;
  return foul;
}

Judgement judge_attackers(const JudgedField& pitch, const TickFacts& s,
                          const std::optional<Decision>& goal, LawBook& book) {
  const std::optional<End> goal_at = goal ? std::optional(opposite(*goal->team)) : std::nullopt;
  Judgement judgement;
  judgement.call(judge_keeper_charge(pitch, s, book.occupancy, book.keeper_charge));
  judgement.call(judge_keeper_push_in(pitch, s, book.occupancy, goal_at, book.keeper_push_in));
  for (const CrowdingLaw law : {CrowdingLaw::two_attackers, CrowdingLaw::four_attackers}) {
    judgement.call(judge_crowding(law, pitch, s, book.occupancy, goal_at, book.crowding));
  }
  if (judgement.decision && goal && goal->team == judgement.decision->team) {
    judgement.decision->goal_cancelled = true;
    judgement.decision->reason += "; the goal does not count";
  }
  return judgement;
}

Judgement judge_play(const JudgedField& pitch, const TickFacts& s,
                     const std::optional<Decision>& goal, LawBook& book) {
  Advantage& advantage = book.advantage;
  advantage.for_s += s.duration;

  Judgement judgement = judge_attackers(pitch, s, goal, book);
  // The earlier foul of the defenders counts: the attackers had their advantage and spoilt it.
  if (judgement.decision && advantage.foul) {
    Decision earlier = advantage_is_over(s, advantage);
    earlier.goal_cancelled = judgement.decision->goal_cancelled;
    judgement.note(*std::exchange(judgement.decision, std::move(earlier)));
  }
  if (goal && !(judgement.decision && judgement.decision->goal_cancelled)) judgement.call(goal);
  judgement.call(judge_kick_off(pitch, s, book.kick_off));

  for (const CrowdingLaw law : {CrowdingLaw::two_defenders, CrowdingLaw::four_defenders}) {
    wait_for_goal(judge_crowding(law, pitch, s, book.occupancy, std::nullopt, book.crowding),
                  advantage, judgement);
  }
  auto push = judge_push(pitch, s, book.occupancy, book.push);
  // A crowd of defenders always waits for the advantage, a push only if the ball may reach the
  // goal.
  if (push && push->law == Law::push && may_come_in(pitch, s, *push->team)) {
    wait_for_goal(std::exchange(push, std::nullopt), advantage, judgement);
  }
  if (advantage.foul && advantage.for_s + s.duration / 2.0 >= pitch.rules.advantage_s) {
    judgement.call(advantage_is_over(s, advantage));
  }
  judgement.call(judge_keeper_hold(pitch, s, book.keeper_hold));
  judgement.call(judge_hand(pitch, s));
  judgement.call(judge_keeper_block(pitch, s, book.occupancy, book.keeper_block));
  judgement.call(std::move(push));
  judgement.call(judge_collision(pitch, s, book.collision));
  judgement.call(judge_keeper_catch(pitch, s, book.occupancy, book.keeper_catch));
  judgement.call(judge_holding(pitch, s, book.occupancy, book.holding));
  judgement.call(judge_wall_push(pitch, s, book.wall_push));
  judgement.call(judge_fallen(pitch, s));
  judgement.call(judge_stalemate(pitch, s, book.stalemate));
  return judgement;
}

}  // namespace mirocup::referee
