// SPDX-License-Identifier: MIT
//
// The referee of one match: clock, phase, score, and the laws in their order.
//
// It is asked once a tick while play is on and answers with at most one decision. It knows ends,
// not colours; who defends which end is the match's business, and so are the coins: whoever starts
// a phase says who won the toss.
#pragma once

#include "core/referee/law_book.hpp"

namespace mirocup::referee {

// Penalty attempts of the shoot-out, and who wins if lots have to be drawn.
struct ShootOut {
  ByEnd<int> taken{};
  ByEnd<int> scored{};
  End lots = End::left;
};

// How far a match has come. The default is its begin.
struct LegProgress {
  Stage stage = Stage::group;
  Phase phase = Phase::FIRST_HALF;
  bool is_second_extra_half = false;
  double clock = 0.0;  // s, of the current phase
  ByEnd<int> score{};
  ShootOut shoot_out{};
  End first = End::left;  // who begins the phase: kicks off, takes the first attempt
  ByEnd<int> time_outs_taken{};
  ByEnd<int> substitutions_made{};  // while play was on
};

// What the referee counts about one team, for those who want to know before the whistle. Seconds
// are those of the laws' limits.
struct TeamCounts {
  int defenders = 0;  // in its own goal area, and for how long that is too many
  double two_defenders_s = 0.0;
  int area_defenders = 0;  // in its own penalty area
  double four_defenders_s = 0.0;
  int attackers = 0;  // in the opponents' goal area
  double two_attackers_s = 0.0;
  double keeper_hold_s = 0.0;      // the ball is uncontested in its goal area
  int keeper = -1;                 // its robot that counts as keeper, -1: none
  bool advantage_against = false;  // it fouled; a goal of the others comes first, or the call
};

struct PendingCounts {
  double stalemate_s = 0.0;  // the ball gets nowhere
  double advantage_s = 0.0;  // the time a foul has waited, if one does
  ByEnd<TeamCounts> teams;
};

class Referee {
 public:
  // `pitch` and what it points to outlive the referee.
  Referee(const Pitch& pitch, const LegProgress& progress);

  Phase phase() const { return now_.phase; }
  double clock() const { return now_.clock; }  // s, of the current phase
  const ByEnd<int>& score() const { return now_.score; }
  const ShootOut& shoot_out() const { return now_.shoot_out; }
  const std::optional<RobotId>& last_touch() const { return last_touch_; }
  const LegProgress& progress() const { return now_; }
  PendingCounts pending_counts() const;

  // The restart that opens the phase.
  Decision opening() const;

  // Judges one tick of play. The situation's begin and last_touch are filled in by the referee.
  Judgement judge(Situation situation);

  // What follows from a decision in the same tick: the end of the match after a goal too many, the
  // end of a half whose time was over, a time-out that was asked for.
  std::optional<Decision> follow_up(const Decision& decision);

  // The restart of a decision has been placed and play goes on: every count begins anew. `since`:
  // of a situation that is looked at later, for how long play has gone on, s.
  void resume(const Decision& restart, double since = 0.0);

  // After HALF_END: ends are swapped and the other team kicks off.
  void start_half(Phase phase);

  // After PHASE: `first` won the toss. `lots` wins if the shoot-out ends in a draw of lots.
  void start_extra_time(End first);
  void start_shoot_out(End first, End lots);

  // A team wants a pause. Granted at the next stoppage, or rejected at once: the decision.
  std::optional<Decision> ask_for_time_out(End team);
  int time_outs_left(End team) const;

  // A team wants another robot in the place of this one: in a time-out, which is asked for with it
  // if none is. The decision if it is rejected.
  std::optional<Decision> ask_for_substitution(const RobotId& robot);
  int substitutions_left(End team) const;

  // The same in the break between the halves, where everybody may.
  Decision substitute_in_break(const RobotId& robot) const;

 private:
  Judgement judge_attempt(const Situation& situation);
  bool is_time_up(const Situation& situation, const std::optional<Decision>& goal);
  Decision end_of_phase(const Situation& situation);
  Decision attempt_over(const Situation& situation, bool scored, std::string reason);
  std::optional<Decision> shoot_out_end(const Decision& attempt) const;
  std::optional<Decision> grant_time_out(const Decision& stoppage);
  std::optional<Decision> end_after(const Decision& decision);
  Decision reject(Law law, End team, std::string reason) const;
  double phase_length() const;

  Pitch pitch_;
  LegProgress now_;
  LawBook book_;
  std::optional<RobotId> last_touch_;
  ByEnd<int> time_outs_wanted_{};
  ByEnd<RobotSet> to_replace_;  // in the next time-out of the team
};

}  // namespace mirocup::referee
