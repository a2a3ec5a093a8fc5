// SPDX-License-Identifier: MIT
#include "core/simulator/cluster.hpp"

namespace mirocup::simulator {

BodySet cluster_of(int body, std::span<const Contact> contacts) {
  return connected(BodySet(1UL << body), contacts, [](const Contact& c) { return c.holds; });
}

BodySet touching_with(const BodySet& bodies, std::span<const Contact> contacts) {
  return connected(bodies, contacts, [](const Contact&) { return true; });
}

}  // namespace mirocup::simulator
