// SPDX-License-Identifier: MIT
#include "core/referee/referee.hpp"

#include "core/base/assert.hpp"
#include "core/referee/laws/goal.hpp"
#include "core/referee/laws/mercy.hpp"

#include <utility>

namespace mirocup::referee {

namespace {

std::string score_text(const ByEnd<int>& score) {
  return "left " + std::to_string(score[0]) + " : " + std::to_string(score[1]) + " right";
}

std::optional<End> leader(const ByEnd<int>& score) {
  if (score[0] == score[1]) return std::nullopt;
  return score[0] > score[1] ? End::left : End::right;
}

bool is_length(double seconds) {
  return seconds > 0.0 && seconds != off;
}

}  // namespace

Referee::Referee(const JudgedField& pitch, const LegProgress& progress)
    : pitch_(pitch), now_(progress) {}

Decision Referee::opening() const {
  Decision d;
  d.clock = now_.clock;
  d.taker = now_.first;
  d.team = d.taker;
  if (now_.phase == Phase::SHOOT_OUT) {
    d.verdict = Verdict::PENALTY_KICK;
    d.law = Law::shoot_out;
    d.restart = Restart::PENALTY_KICK;
    d.reason = "won the toss and takes the first attempt";
    return d;
  }
  const bool by_toss =
      now_.phase == Phase::FIRST_HALF || (now_.phase == Phase::EXTRA && !now_.is_second_extra_half);
  d.verdict = Verdict::KICK_OFF;
  d.law = by_toss ? Law::toss : Law::half_time;
  d.restart = Restart::KICK_OFF;
  d.reason = by_toss ? "won the toss" : "the other team kicked off the first half";
  return d;
}

Judgement Referee::judge(TickFacts s) {
  s.begin = now_.clock;
  if (s.last_touch) last_touch_ = s.last_touch;
  s.last_touch = last_touch_;
  now_.clock += s.duration;
  update_occupancy(pitch_, s, book_.occupancy);
  if (now_.phase == Phase::SHOOT_OUT) return judge_attempt(s);

  const std::optional<Decision> goal = judge_goal(pitch_, s);
  if (is_time_up(s, goal)) {
    Judgement judgement;
    judgement.call(end_of_phase(s));
    return judgement;
  }
  Judgement judgement = judge_play(pitch_, s, goal, book_);
  if (judgement.decision && judgement.decision->verdict == Verdict::GOAL) {
    ++now_.score[index_of(*judgement.decision->team)];
  }
  return judgement;
}

double Referee::phase_length() const {
  const Rules& rules = pitch_.rules;
  if (now_.phase != Phase::EXTRA) return rules.half_s;
  return is_length(rules.golden_goal_s) ? rules.golden_goal_s : rules.extra_halves_s;
}

// A goal counts if the ball crossed the line before the end, and a penalty given before the end is
// still taken. A new foul of the defenders then gives another penalty, but a phase is prolonged by
// the length of one attempt at most.
bool Referee::is_time_up(const TickFacts& s, const std::optional<Decision>& goal) {
  const bool prolonged = book_.attempt.is_on;
  if (prolonged) {
    const bool still = is_stalemate(pitch_, book_.stalemate, s.duration);
    if (judge_penalty_attempt(pitch_, s, book_.occupancy, still, book_.attempt)) {
      book_.attempt.is_on = false;
    }
  }
  if (now_.clock < phase_length()) return false;
  const bool may_be_longer = now_.clock < phase_length() + pitch_.rules.attempt_s;
  if (prolonged) return !goal && !(book_.attempt.is_on && may_be_longer);
  return !goal || goal->clock > phase_length();
}

Decision Referee::end_of_phase(const TickFacts& s) {
  const Rules& rules = pitch_.rules;
  if (book_.advantage.foul && book_.advantage.foul->verdict == Verdict::PENALTY_KICK) {
    return advantage_is_over(s, book_.advantage);
  }
  const std::string reason = "the time of " + fixed(phase_length(), 0) + " s is over";
  const std::string score = " at " + score_text(now_.score);
  const bool golden = is_length(rules.golden_goal_s);
  if (now_.phase == Phase::FIRST_HALF ||
      (now_.phase == Phase::EXTRA && !golden && !now_.is_second_extra_half)) {
    Decision d = decide(Verdict::HALF_END, Law::half_time, s, reason + score);
    d.phase = now_.phase == Phase::FIRST_HALF ? Phase::SECOND_HALF : Phase::EXTRA;
    return d;
  }
  const std::optional<End> winner = leader(now_.score);
  if (winner || now_.stage == Stage::group) {
    const Law law = now_.phase == Phase::EXTRA ? Law::extra_time : Law::half_time;
    Decision d = decide(Verdict::MATCH_END, law, s, reason + score);
    d.team = winner;
    return d;
  }
  const bool extra =
      now_.phase == Phase::SECOND_HALF && (golden || is_length(rules.extra_halves_s));
  Decision d = decide(Verdict::PHASE, extra ? Law::extra_time : Law::shoot_out, s,
                      reason + ", level" + score + (extra ? ": extra time" : ": a shoot-out"));
  d.phase = extra ? Phase::EXTRA : Phase::SHOOT_OUT;
  return d;
}

Judgement Referee::judge_attempt(const TickFacts& s) {
  const std::optional<Decision> goal = judge_goal(pitch_, s);
  Judgement judgement = judge_attackers(pitch_, s, goal, book_);
  // Called for its count only: in an attempt it does not decide.
  judge_stalemate(pitch_, s, book_.stalemate);
  const bool still = is_stalemate(pitch_, book_.stalemate, s.duration);
  const auto over = judge_penalty_attempt(pitch_, s, book_.occupancy, still, book_.attempt);
  if (judgement.decision) {
    const std::string why = judgement.decision->reason;
    judgement.note(*std::exchange(judgement.decision, std::nullopt));
    judgement.decision = attempt_over(s, false, why);
  } else if (goal) {
    const bool scored = *goal->team == book_.attempt.taker;
    judgement.decision = attempt_over(s, scored, goal->reason);
  } else if (over) {
    judgement.decision = attempt_over(s, false, *over);
  }
  return judgement;
}

Decision Referee::attempt_over(const TickFacts& s, bool scored, std::string reason) {
  const End taker = book_.attempt.taker;
  ++now_.shoot_out.taken[index_of(taker)];
  now_.shoot_out.scored[index_of(taker)] += scored ? 1 : 0;
  Decision d = decide(Verdict::ATTEMPT_END, Law::penalty_attempt, s, std::move(reason));
  d.team = taker;
  d.scored = scored;
  d.restart = Restart::PENALTY_KICK;
  d.taker = opposite(taker);
  return d;
}

std::optional<Decision> Referee::shoot_out_end(const Decision& attempt) const {
  const ShootOut& shots = now_.shoot_out;
  const int rounds = shots.taken[0];
  if (rounds != shots.taken[1] || rounds < pitch_.rules.shoot_out_rounds) return std::nullopt;
  std::optional<End> winner = leader(shots.scored);
  const bool by_lots = !winner && rounds >= pitch_.rules.shoot_out_most_rounds;
  if (by_lots) winner = shots.lots;
  if (!winner) return std::nullopt;
  Decision d = attempt;
  d.verdict = Verdict::MATCH_END;
  d.law = by_lots ? Law::lots : Law::shoot_out;
  d.team = winner;
  d.restart = Restart::none;
  d.scored = false;
  d.reason = score_text(shots.scored) + " after " + std::to_string(rounds) + " attempts each" +
             (by_lots ? ": lots were drawn" : "");
  return d;
}

std::optional<Decision> Referee::follow_up(const Decision& decision) {
  if (decision.verdict == Verdict::ATTEMPT_END) return shoot_out_end(decision);
  if (decision.verdict == Verdict::GOAL) {
    if (auto d = judge_mercy(pitch_, now_.score, decision)) return d;
    if (now_.phase == Phase::EXTRA && is_length(pitch_.rules.golden_goal_s)) {
      Decision d = decision;
      d.verdict = Verdict::MATCH_END;
      d.law = Law::golden_goal;
      d.restart = Restart::none;
      d.reason = "the first goal of extra time ends the match at " + score_text(now_.score);
      return d;
    }
  }
  if (auto d = grant_time_out(decision)) return d;
  return end_after(decision);
}

// Ends the phase after a decision made when time was up, unless it is a penalty, which is still
// taken.
std::optional<Decision> Referee::end_after(const Decision& decision) {
  if (now_.phase == Phase::SHOOT_OUT || decision.restart == Restart::none ||
      decision.restart == Restart::PENALTY_KICK || now_.clock < phase_length()) {
    return std::nullopt;
  }
  book_.advantage = {};
  TickFacts at;
  at.begin = now_.clock;
  at.ball = decision.ball;
  return end_of_phase(at);
}

std::optional<Decision> Referee::grant_time_out(const Decision& stoppage) {
  if (stoppage.restart == Restart::none) return std::nullopt;
  for (const End end : {stoppage.taker, opposite(stoppage.taker)}) {
    const int e = index_of(end);
    if (time_outs_wanted_[e] == 0) continue;
    --time_outs_wanted_[e];
    ++now_.time_outs_taken[e];
    Decision d = stoppage;
    d.verdict = Verdict::TIME_OUT;
    d.law = Law::time_out;
    d.team = end;
    d.robots = {};
    d.reason = "asked for; " + std::to_string(time_outs_left(end)) + " left";
    if (to_replace_[e].any()) {
      d.law = Law::substitution;
      d.robots[e] = std::exchange(to_replace_[e], {});
      now_.substitutions_made[e] += static_cast<int>(d.robots[e].count());
      d.reason += ", " + std::to_string(substitutions_left(end)) + " substitutions left";
    }
    return d;
  }
  return std::nullopt;
}

int Referee::time_outs_left(End team) const {
  return pitch_.rules.time_outs - now_.time_outs_taken[index_of(team)];
}

int Referee::substitutions_left(End team) const {
  return pitch_.rules.substitutions - now_.substitutions_made[index_of(team)];
}

Decision Referee::reject(Law law, End team, std::string reason) const {
  Decision d;
  d.verdict = Verdict::REJECTED;
  d.law = law;
  d.clock = now_.clock;
  d.team = team;
  d.reason = std::move(reason);
  return d;
}

std::optional<Decision> Referee::ask_for_time_out(End team) {
  const int asked_for = now_.time_outs_taken[index_of(team)] + time_outs_wanted_[index_of(team)];
  if (now_.phase == Phase::SHOOT_OUT) {
    return reject(Law::time_out, team, "there are no time-outs in a shoot-out");
  }
  if (asked_for >= pitch_.rules.time_outs) {
    return reject(Law::time_out, team,
                  "the team has had its " + std::to_string(asked_for) + " time-outs");
  }
  ++time_outs_wanted_[index_of(team)];
  return std::nullopt;
}

std::optional<Decision> Referee::ask_for_substitution(const RobotId& robot) {
  RobotSet& to_replace = to_replace_[index_of(robot.end)];
  const int wanted = static_cast<int>(to_replace.count());
  if (wanted >= substitutions_left(robot.end)) {
    return reject(
        Law::substitution, robot.end,
        "the team has had its " + std::to_string(pitch_.rules.substitutions) + " substitutions");
  }
  if (time_outs_wanted_[index_of(robot.end)] == 0) {
    if (auto rejected = ask_for_time_out(robot.end)) {
      rejected->law = Law::substitution;
      rejected->reason += ", and a substitution needs one";
      return rejected;
    }
  }
  to_replace.set(robot.index);
  return std::nullopt;
}

Decision Referee::substitute_in_break(const RobotId& robot) const {
  Decision d;
  d.verdict = Verdict::SUBSTITUTION;
  d.law = Law::substitution;
  d.clock = now_.clock;
  d.team = robot.end;
  d.add_robot(robot);
  d.reason = "in the break between the halves there may be any number";
  return d;
}

void Referee::resume(const Decision& restart, double since) {
  book_ = {};
  last_touch_.reset();
  if (restart.restart == Restart::KICK_OFF) {
    book_.kick_off.is_pending = true;
    book_.kick_off.taker = restart.taker;
    book_.kick_off.spot = restart.spot;
    book_.kick_off.waited_s = since;
  }
  if (restart.restart == Restart::PENALTY_KICK) {
    book_.attempt.is_on = true;
    book_.attempt.taker = restart.taker;
    book_.attempt.for_s = since;
  }
}

void Referee::start_half(Phase phase) {
  MIROCUP_ASSERT(phase == Phase::SECOND_HALF || phase == Phase::EXTRA);
  now_.is_second_extra_half = phase == Phase::EXTRA;
  now_.phase = phase;
  now_.clock = 0.0;
  // The ends are swapped and the other team kicks off, so the same end kicks off as before.
  std::swap(now_.score[0], now_.score[1]);
  std::swap(now_.time_outs_taken[0], now_.time_outs_taken[1]);
  std::swap(time_outs_wanted_[0], time_outs_wanted_[1]);
  std::swap(now_.substitutions_made[0], now_.substitutions_made[1]);
  std::swap(to_replace_[0], to_replace_[1]);
}

void Referee::start_extra_time(End first) {
  now_.phase = Phase::EXTRA;
  now_.is_second_extra_half = false;
  now_.clock = 0.0;
  now_.first = first;
}

void Referee::start_shoot_out(End first, End lots) {
  now_.phase = Phase::SHOOT_OUT;
  now_.clock = 0.0;
  now_.first = first;
  now_.shoot_out = {};
  now_.shoot_out.lots = lots;
}

PendingCounts Referee::pending_counts() const {
  PendingCounts pending;
  pending.stalemate_s = book_.stalemate.still_s;
  if (book_.advantage.foul) pending.advantage_s = book_.advantage.for_s;
  const Occupancy& occupancy = book_.occupancy;
  for (const End end : both_ends) {
    const int e = index_of(end);
    const int other = index_of(opposite(end));
    TeamCounts& team = pending.teams[e];
    const auto count = [](const RobotSet& set) { return static_cast<int>(set.count()); };
    team.defenders = count(not_pushed(occupancy, occupancy.goal_area, end, end));
    team.two_defenders_s = book_.crowding.of(CrowdingLaw::two_defenders)[e].for_s;
    team.area_defenders = count(not_pushed(occupancy, occupancy.penalty_area, end, end));
    team.four_defenders_s = book_.crowding.of(CrowdingLaw::four_defenders)[e].for_s;
    team.attackers = count(not_pushed(occupancy, occupancy.goal_area, opposite(end), end));
    team.two_attackers_s = book_.crowding.of(CrowdingLaw::two_attackers)[other].for_s;
    team.keeper_hold_s = book_.keeper_hold.held[e].for_s;
    team.keeper = occupancy.keeper[e] ? occupancy.keeper[e]->index : -1;
    team.advantage_against = book_.advantage.foul && book_.advantage.foul->team == end;
  }
  return pending;
}

}  // namespace mirocup::referee
