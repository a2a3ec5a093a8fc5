// SPDX-License-Identifier: MIT
#include "core/referee/referee.hpp"

#include "core/referee/laws/goal.hpp"
#include "core/referee/laws/mercy.hpp"

#include <utility>

namespace mirocup::referee {

Referee::Referee(const Pitch& pitch, End kick_off) : pitch_(pitch), first_kick_off_(kick_off) {}

Decision Referee::opening() const {
  Decision d;
  d.verdict = Verdict::KICK_OFF;
  d.law = phase_ == Phase::FIRST_HALF ? Law::toss : Law::half_time;
  d.clock = clock_;
  // The ends are swapped and the other team kicks off: the same end as in the first half.
  d.taker = first_kick_off_;
  d.team = d.taker;
  d.restart = Restart::KICK_OFF;
  d.reason =
      phase_ == Phase::FIRST_HALF ? "won the toss" : "the other team kicked off the first half";
  return d;
}

std::optional<Decision> Referee::judge(Situation situation) {
  situation.begin = clock_;
  if (situation.last_touch) last_touch_ = situation.last_touch;
  situation.last_touch = last_touch_;
  clock_ += situation.duration;
  return judge_laws(situation);
}

// The order inside one tick: a goal before the half's end counts, then the half's end, then fouls,
// then stalemate.
std::optional<Decision> Referee::judge_laws(const Situation& s) {
  const Rules& rules = pitch_.rules;
  std::optional<Decision> goal = judge_goal(pitch_, s);
  if (goal && goal->clock <= rules.half_s) {
    ++score_[index_of(*goal->team)];
    return goal;
  }
  if (std::optional<Decision> end = judge_half_end(s)) return end;
  if (std::optional<Decision> d = judge_kick_off(pitch_, s, kick_off_)) return d;
  if (std::optional<Decision> d = judge_keeper_hold(pitch_, s, keeper_hold_)) return d;
  return judge_stalemate(pitch_, s, stalemate_);
}

std::optional<Decision> Referee::judge_half_end(const Situation& s) const {
  if (clock_ < pitch_.rules.half_s) return std::nullopt;
  const bool last = phase_ == Phase::SECOND_HALF;
  Decision d = decide(last ? Verdict::MATCH_END : Verdict::HALF_END, Law::half_time, s,
                      "the half is over after " + fixed(pitch_.rules.half_s, 0) + " s");
  return d;
}

std::optional<Decision> Referee::follow_up(const Decision& decision) const {
  if (decision.verdict != Verdict::GOAL) return std::nullopt;
  return judge_mercy(pitch_, score_, decision);
}

void Referee::resume(const Decision& restart) {
  stalemate_ = {};
  keeper_hold_ = {};
  kick_off_ = {};
  last_touch_.reset();
  if (restart.restart == Restart::KICK_OFF) {
    kick_off_.is_pending = true;
    kick_off_.taker = restart.taker;
    kick_off_.spot = restart.spot;
  }
}

void Referee::start_second_half() {
  phase_ = Phase::SECOND_HALF;
  clock_ = 0.0;
  std::swap(score_[0], score_[1]);
}

}  // namespace mirocup::referee
