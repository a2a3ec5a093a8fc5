// SPDX-License-Identifier: MIT
#include "core/simulator/tick_events.hpp"

namespace mirocup::simulator {

void add_touches(const collision::StaticWorld& world, std::span<const collision::Contact> contacts,
                 TickEvents& events) {
  for (const collision::Contact& c : contacts) {
    if (c.pair.with_obstacle()) continue;
    events.touched[c.pair.a].set(c.pair.partner);
    events.touched[c.pair.partner].set(c.pair.a);
    if (world.is_ball(c.pair.a)) events.last_to_touch_ball = c.pair.partner;
  }
}

}  // namespace mirocup::simulator
