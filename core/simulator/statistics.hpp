// SPDX-License-Identifier: MIT
//
// What a report wants to know of a run and a match does not: every impact, and what was counted on
// the way. A world that has no trace pays nothing for it.
#pragma once

#include "core/simulator/collision/contact_constraint.hpp"

#include <array>
#include <bitset>
#include <span>
#include <vector>

namespace mirocup::simulator {

// Two bodies that approached and were thrown apart.
struct Impact {
  double time = 0.0;  // s, from the trace's origin
  int first = no_body;
  int second = no_body;   // indices of bodies; no_body is a wall
  Vec2 point{0.0, 0.0};   // m
  Vec2 normal{0.0, 0.0};  // unit, from the second to the first
  double impulse = 0.0;   // N s along the normal
};

struct RunStatistics {
  double origin = 0.0;  // s: when the tick began that is being played
  std::vector<Impact> impacts;
  double deepest_overlap = 0.0;   // m, before it was corrected
  int lasting_contacts = 0;       // pairs that began to press on each other
  long position_evaluations = 0;  // poses of a body computed at a time of an event
  int contact_solves = 0;         // times that forces of touching bodies were asked for

  // Which pairs press now: [body][partner].
  std::array<std::bitset<max_partners>, max_bodies> pressing{};
};

// An impact at t seconds of the tick.
void add_impact(const collision::Contact& contact, double t, RunStatistics& statistics);

// The contacts of the involved bodies, after it was found which of them press.
void add_pressing(std::span<const collision::Contact> contacts, const BodySet& involved,
                  RunStatistics& statistics);

}  // namespace mirocup::simulator
