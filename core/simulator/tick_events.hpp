// SPDX-License-Identifier: MIT
//
// What happened in a tick: for the referee and for reports. Plain data; belongs to the world's
// thread.
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
  int events = 0;                    // ends of segments and first contacts
  int impacts = 0;                   // contacts that bounced
  bool stepped = false;              // some bodies were time-stepped
  double deepest_overlap = 0.0;      // m, before it was corrected
};

// Adds the touches of bodies that have these contacts; contacts with obstacles are not touches.
inline void add_touches(const collision::StaticWorld& world,
                        std::span<const collision::Contact> contacts, TickEvents& events) {
  for (const collision::Contact& c : contacts) {
    if (c.pair.with_obstacle()) continue;
    events.touched[c.pair.a].set(c.pair.partner);
    events.touched[c.pair.partner].set(c.pair.a);
    if (world.is_ball(c.pair.a)) events.last_to_touch_ball = c.pair.partner;
  }
}

}  // namespace mirocup::simulator
