// SPDX-License-Identifier: MIT
//
// Run statistics: data for reports that a leg does not need, such as every impact. A world without
// statistics pays nothing for them. Recording allocates.
#pragma once

#include "core/simulator/collision/contact_constraint.hpp"

#include <array>
#include <bitset>
#include <span>
#include <vector>

namespace mirocup::simulator {

// A contact that bounced.
struct Impact {
  double time = 0.0;  // s, since the start of the run
  int first = no_body;
  int second = no_body;   // indices of bodies; no_body is an obstacle
  Vec2 point{0.0, 0.0};   // m
  Vec2 normal{0.0, 0.0};  // unit, from the second body to the first
  double impulse = 0.0;   // N s along the normal
};

// The counts of one run. The caller sets `origin` before each tick.
struct RunStatistics {
  double origin = 0.0;  // s, of the run: start of the tick that is being played
  std::vector<Impact> impacts;
  double deepest_overlap = 0.0;   // m, before it was corrected
  int lasting_contacts = 0;       // pairs that began to press on each other
  long position_evaluations = 0;  // poses of bodies computed at the times of events
  int contact_solves = 0;         // how often the forces of touching bodies were decided

  // pressing[body][partner]: the pair presses now.
  std::array<std::bitset<max_partners>, max_bodies> pressing{};
};

// Records the impact of a contact at t seconds of the tick.
void add_impact(const collision::Contact& contact, double t, RunStatistics& statistics);

// Records which contacts of the involved bodies press; to be called after the forces were decided.
// Counts pairs that did not press before.
void add_pressing(std::span<const collision::Contact> contacts, const BodySet& involved,
                  RunStatistics& statistics);

}  // namespace mirocup::simulator
