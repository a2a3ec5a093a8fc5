// SPDX-License-Identifier: MIT
//
// The laws of play, what each of them remembers, and their order within a tick.
#pragma once

#include "core/referee/laws/collision.hpp"
#include "core/referee/laws/crowding.hpp"
#include "core/referee/laws/fallen.hpp"
#include "core/referee/laws/hand.hpp"
#include "core/referee/laws/holding.hpp"
#include "core/referee/laws/keeper_block.hpp"
#include "core/referee/laws/keeper_catch.hpp"
#include "core/referee/laws/keeper_charge.hpp"
#include "core/referee/laws/keeper_hold.hpp"
#include "core/referee/laws/keeper_push_in.hpp"
#include "core/referee/laws/kick_off.hpp"
#include "core/referee/laws/penalty_attempt.hpp"
#include "core/referee/laws/push.hpp"
#include "core/referee/laws/stalemate.hpp"
#include "core/referee/laws/wall_push.hpp"

#include <vector>

namespace mirocup::referee {

// The result of a tick: at most one decision, and notes of other offences, without effect.
struct Judgement {
  std::optional<Decision> decision;
  std::vector<Decision> notes;

  // Adds the call of a law, if the law made one. The first call of a tick is the decision; later
  // calls, and calls with the verdict NONE, become notes.
  void call(std::optional<Decision> decision);

  // Adds a note: the decision without its verdict and restart.
  void note(Decision decision);
};

// The advantage: a foul of the defenders that is not called yet, because a goal may still come.
struct Advantage {
  std::optional<Decision> foul;
  double for_s = 0.0;  // how long the foul has waited
};

// The memory of all laws. It is reset after each stoppage.
struct LawBook {
  Occupancy occupancy;
  Advantage advantage;
  PenaltyAttemptMemory attempt;

  CollisionMemory collision;
  CrowdingMemory crowding;
  HoldingMemory holding;
  KeeperBlockMemory keeper_block;
  KeeperCatchMemory keeper_catch;
  KeeperChargeMemory keeper_charge;
  KeeperHoldMemory keeper_hold;
  KeeperPushInMemory keeper_push_in;
  KickOffMemory kick_off;
  PushMemory push;
  StalemateMemory stalemate;
  WallPushMemory wall_push;
};

// Judges one tick of play. The book's occupancy is already up to date. `goal` is the goal law's
// call in this tick, if any; it becomes the decision unless a foul of the attackers cancels it.
Judgement judge_play(const JudgedField& pitch, const TickFacts& situation,
                     const std::optional<Decision>& goal, LawBook& book);

// Judges only the fouls of the attackers, which cancel their goal of the same tick. The first foul
// is the decision.
Judgement judge_attackers(const JudgedField& pitch, const TickFacts& situation,
                          const std::optional<Decision>& goal, LawBook& book);

// Ends the advantage and returns the call of the foul that has waited in it.
Decision advantage_is_over(const TickFacts& situation, Advantage& advantage);

}  // namespace mirocup::referee
