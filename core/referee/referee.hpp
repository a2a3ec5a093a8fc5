// SPDX-License-Identifier: MIT
//
// The referee of one match: clock, phase, score, and the laws in their order.
//
// It is asked once a tick while play is on and answers with at most one decision. It knows ends,
// not colours; who defends which end is the match's business.
#pragma once

#include "core/referee/laws/keeper_hold.hpp"
#include "core/referee/laws/kick_off.hpp"
#include "core/referee/laws/law.hpp"
#include "core/referee/laws/stalemate.hpp"

namespace mirocup::referee {

enum class Phase { FIRST_HALF, SECOND_HALF };

class Referee {
 public:
  // `pitch` and what it points to outlive the referee. `kick_off`: who takes the first one.
  Referee(const Pitch& pitch, End kick_off);

  Phase phase() const { return phase_; }
  double clock() const { return clock_; }  // s, of the current half
  const ByEnd<int>& score() const { return score_; }
  const std::optional<RobotId>& last_touch() const { return last_touch_; }

  // The restart that opens the match or the half.
  Decision opening() const;

  // Judges one tick of play. The situation's begin and last_touch are filled in by the referee.
  std::optional<Decision> judge(Situation situation);

  // What follows from a decision in the same tick: the end of the match after a goal too many.
  std::optional<Decision> follow_up(const Decision& decision) const;

  // The restart of a decision has been placed and play goes on: every count begins anew.
  void resume(const Decision& restart);

  // Second half: ends are swapped, so scores change places; the other team kicks off.
  void start_second_half();

 private:
  std::optional<Decision> judge_laws(const Situation& situation);
  std::optional<Decision> judge_half_end(const Situation& situation) const;

  Pitch pitch_;
  Phase phase_ = Phase::FIRST_HALF;
  End first_kick_off_;
  double clock_ = 0.0;
  ByEnd<int> score_{};
  std::optional<RobotId> last_touch_;
  KickOffMemory kick_off_;
  KeeperHoldMemory keeper_hold_;
  StalemateMemory stalemate_;
};

}  // namespace mirocup::referee

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 2> enum_names<referee::Phase>{"FIRST_HALF",
                                                                            "SECOND_HALF"};

}  // namespace mirocup
