// SPDX-License-Identifier: MIT
//
// All laws of play, what each remembers, and their order within a tick.
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

// What comes of a tick: at most one decision, and what else was seen and has no effect.
struct Judgement {
  std::optional<Decision> decision;
  std::vector<Decision> notes;

  // The first call of a tick is the decision; the later ones, and those without effect, are notes.
  void call(std::optional<Decision> decision);
  void note(Decision decision);
};

// A foul by the defenders that waits whether a goal comes all the same.
struct Advantage {
  std::optional<Decision> foul;
  double for_s = 0.0;
};

// Everything here begins anew after each stoppage.
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

// One tick of play, the watch brought up to it. `goal`: what the goal law says of it; it is the
// decision unless the attackers' foul cancels it.
Judgement judge_play(const Pitch& pitch, const Situation& situation,
                     const std::optional<Decision>& goal, LawBook& book);

// The attackers' fouls that cancel a goal, in their order; at most the first.
Judgement judge_attackers(const Pitch& pitch, const Situation& situation,
                          const std::optional<Decision>& goal, LawBook& book);

// The foul that waited, called now.
Decision advantage_is_over(const Situation& situation, Advantage& advantage);

}  // namespace mirocup::referee
