// SPDX-License-Identifier: MIT
#include "core/simulator/statistics.hpp"

namespace mirocup::simulator {

void add_impact(const collision::Contact& c, double t, RunStatistics& statistics) {
  statistics.impacts.push_back({.time = statistics.origin + t,
                                .first = c.a,
                                .second = c.b,
                                .point = c.point.point,
                                .normal = c.point.normal,
                                .impulse = c.impact.impulse});
}

void add_pressing(std::span<const collision::Contact> contacts, const BodySet& involved,
                  RunStatistics& statistics) {
  if (!contacts.empty()) ++statistics.contact_solves;
  const auto before = statistics.pressing;
  for (int i = 0; i < max_bodies; ++i) {
    if (involved[i]) statistics.pressing[i].reset();
  }
  for (const collision::Contact& c : contacts) {
    if (!c.resting.is_active || statistics.pressing[c.pair.a][c.pair.partner]) continue;
    statistics.pressing[c.pair.a].set(c.pair.partner);
    if (!before[c.pair.a][c.pair.partner]) ++statistics.lasting_contacts;
  }
}

}  // namespace mirocup::simulator
