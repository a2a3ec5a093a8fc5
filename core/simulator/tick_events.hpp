// SPDX-License-Identifier: MIT
//
// What happened in a tick, for the referee and for reports.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"

#include <array>
#include <span>

namespace mirocup::simulator {

struct TickEvents {
  // touched[a][b]: bodies a and b were in contact at some time of the tick; symmetric. The ball's
  // index is the number of robots.
  std::array<BodySet, max_bodies> touched{};
  int last_to_touch_ball = no_body;  // the last robot that touched the ball, if one did
  int events = 0;
  int impacts = 0;
  bool stepped = false;          // some bodies went on in small steps
  double deepest_overlap = 0.0;  // m, before it was corrected
};

// These were in contact.
void add_touches(const collision::StaticWorld& world, std::span<const collision::Contact> contacts,
                 TickEvents& events);

}  // namespace mirocup::simulator
