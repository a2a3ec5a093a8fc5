// SPDX-License-Identifier: MIT
//
// The referee of one leg: clock, phase, score, and the laws in their order.
//
// It is called once a tick while play is on and returns at most one decision. It knows ends, not
// colours, and tosses no coin: the leg decides which team defends which end and which team wins a
// toss, and tells the referee when a phase starts. See core/referee/README.md.
//
// Threads: none of its own; one thread at a time may call it.
#pragma once

#include "core/referee/law_book.hpp"

namespace mirocup::referee {

// The attempts of the shoot-out, and the winner if lots are drawn.
struct ShootOut {
  ByEnd<int> taken{};
  ByEnd<int> scored{};
  End lots = End::left;
};

// The progress of a leg. The default is its start.
struct LegProgress {
  Stage stage = Stage::group;
  Phase phase = Phase::FIRST_HALF;
  bool is_second_extra_half = false;
  double clock = 0.0;  // s, of the current phase
  ByEnd<int> score{};
  ShootOut shoot_out{};
  End first = End::left;  // the team that kicks off the phase, or takes the first attempt
  ByEnd<int> time_outs_taken{};
  ByEnd<int> substitutions_made{};  // while play was on
};

// The referee's counts about one team, published so that a team knows of a call before it comes.
// Each time runs towards the limit of its law, in seconds.
struct TeamCounts {
  int defenders = 0;               // its robots in its own goal area
  double two_defenders_s = 0.0;    // how long these robots have been too many
  int area_defenders = 0;          // its robots in its own penalty area
  double four_defenders_s = 0.0;   // how long these robots have been too many
  int attackers = 0;               // its robots in the opponents' goal area
  double two_attackers_s = 0.0;    // how long these robots have been too many
  double keeper_hold_s = 0.0;      // how long the ball has been uncontested in its goal area
  int keeper = -1;                 // the index of its keeper, -1: none
  bool advantage_against = false;  // its foul is called unless the opponents score
};

// The counts that may lead to a call.
struct PendingCounts {
  double stalemate_s = 0.0;  // how long the ball has been getting nowhere
  double advantage_s = 0.0;  // how long a foul has waited for a goal, 0 if none does
  ByEnd<TeamCounts> teams;
};

class Referee {
 public:
  // The field and the rules of `pitch` outlive the referee.
  Referee(const JudgedField& pitch, const LegProgress& progress);

  Phase phase() const { return now_.phase; }
  double clock() const { return now_.clock; }  // s, of the current phase
  const ByEnd<int>& score() const { return now_.score; }
  const ShootOut& shoot_out() const { return now_.shoot_out; }
  const std::optional<RobotId>& last_touch() const { return last_touch_; }
  const LegProgress& progress() const { return now_; }
  PendingCounts pending_counts() const;
  double stalemate_s() const { return book_.stalemate.still_s; }  // as in pending_counts()

  // Returns the decision with the restart that opens the current phase.
  Decision opening() const;

  // Judges one tick of play and advances the clock by it. The referee sets the situation's `begin`
  // and, if nobody touched the ball in this tick, its `last_touch`: the last robot that did.
  Judgement judge(TickFacts situation);

  // Returns the decision that follows from this one in the same tick: the end of the match after
  // the goal that decides it, the end of a half whose time is over, or a time-out that was asked
  // for.
  std::optional<Decision> follow_up(const Decision& decision);

  // Resets every count, because the restart of a decision has been placed. `since` is how long play
  // has been on already, s: 0 in a leg; a recorded trace may start later.
  void resume(const Decision& restart, double since = 0.0);

  // Starts the half after HALF_END: SECOND_HALF or EXTRA. The ends are swapped and the other team
  // kicks off.
  void start_half(Phase phase);

  // Start extra time or the shoot-out after PHASE. `first` won the toss; `lots` wins the shoot-out
  // if lots decide it.
  void start_extra_time(End first);
  void start_shoot_out(End first, End lots);

  // Asks for a time-out, which is granted at the next stoppage. Returns a decision only if the
  // request is rejected.
  std::optional<Decision> ask_for_time_out(End team);
  int time_outs_left(End team) const;

  // Asks to replace a robot in the team's next time-out; asks for a time-out as well if the team
  // has not done so. Returns a decision only if the request is rejected.
  std::optional<Decision> ask_for_substitution(const RobotId& robot);
  int substitutions_left(End team) const;

  // Replaces a robot in the break between the halves, where any number may be replaced.
  Decision substitute_in_break(const RobotId& robot) const;

 private:
  Judgement judge_attempt(const TickFacts& situation);
  bool is_time_up(const TickFacts& situation, const std::optional<Decision>& goal);
  Decision end_of_phase(const TickFacts& situation);
  Decision attempt_over(const TickFacts& situation, bool scored, std::string reason);
  std::optional<Decision> shoot_out_end(const Decision& attempt) const;
  std::optional<Decision> grant_time_out(const Decision& stoppage);
  std::optional<Decision> end_after(const Decision& decision);
  Decision reject(Law law, End team, std::string reason) const;
  double phase_length() const;

  JudgedField pitch_;
  LegProgress now_;
  LawBook book_;
  std::optional<RobotId> last_touch_;
  ByEnd<int> time_outs_wanted_{};
  ByEnd<RobotSet> to_replace_;  // robots to replace in the team's next time-out
};

}  // namespace mirocup::referee
