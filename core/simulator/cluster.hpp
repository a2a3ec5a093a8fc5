// SPDX-License-Identifier: MIT
//
// Who moves together: bodies that hold each other are one cluster, and one power series; bodies that
// touch, directly or through others, are one group, and concern no other.
#pragma once

#include "core/simulator/impact.hpp"

#include <array>
#include <span>

namespace mirocup::simulator {

// Whom the contacts that count, counts(contact), connect with one of these bodies, directly or through
// others; of these, those with such a contact.
template <class Counts>
BodySet connected(const BodySet& with, std::span<const Contact> contacts, Counts counts) {
  if (contacts.empty()) return {};
  std::array<unsigned long, max_bodies> beside{};  // one bit for each body, itself included
  for (const Contact& c : contacts) {
    if (!counts(c)) continue;
    const BodySet two = bodies_of(c.pair);
    for_each_body(two, [&](int i) { beside[i] |= two.to_ulong(); });
  }
  unsigned long found = 0;
  for (BodySet next = with; next.any();) {
    unsigned long reached = 0;
    for_each_body(next, [&](int i) { reached |= beside[i]; });
    next = BodySet(reached & ~(found | next.to_ulong()));
    found |= reached;
  }
  return BodySet(found);
}

// The bodies that hold together with this one, itself included; empty if nothing holds it.
BodySet cluster_of(int body, std::span<const Contact> contacts);

// Those that touch one of these, directly or through others; empty if nothing touches them.
BodySet touching_with(const BodySet& bodies, std::span<const Contact> contacts);

}  // namespace mirocup::simulator
