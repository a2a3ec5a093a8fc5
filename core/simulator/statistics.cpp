// SPDX-License-Identifier: MIT
#include "core/simulator/statistics.hpp"

namespace mirocup::simulator {

void add_impact(const Contact& c, double t, Trace& trace) {
  trace.impacts.push_back({.time = trace.origin + t,
                           .first = c.a,
                           .second = c.b,
                           .point = c.point.point,
                           .normal = c.point.normal,
                           .impulse = c.impact.impulse});
}

void add_pressing(std::span<const Contact> contacts, const BodySet& involved, Trace& trace) {
  if (!contacts.empty()) ++trace.contact_solves;
  const auto before = trace.pressing;
  for (int i = 0; i < max_bodies; ++i) {
    if (involved[i]) trace.pressing[i].reset();
  }
  for (const Contact& c : contacts) {
    if (!c.resting.is_active || trace.pressing[c.pair.a][c.pair.partner]) continue;
    trace.pressing[c.pair.a].set(c.pair.partner);
    if (!before[c.pair.a][c.pair.partner]) ++trace.lasting_contacts;
  }
}

}  // namespace mirocup::simulator
