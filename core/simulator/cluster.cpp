// SPDX-License-Identifier: MIT
#include "core/simulator/cluster.hpp"

namespace mirocup::simulator {

BodySet cluster_of(int body, std::span<const Contact> contacts) {
  if (contacts.empty()) return {};
  BodySet cluster;
  cluster.set(body);
  bool held = false;
  bool grows = true;
  while (grows) {
    grows = false;
    for (const Contact& c : contacts) {
      if (!c.holds ||
          !(cluster[c.pair.a] || (c.b != no_body && c.a != no_body && cluster[c.pair.partner]))) {
        continue;
      }
      held = true;
      if (c.pair.with_obstacle() || cluster[c.pair.a] == cluster[c.pair.partner]) continue;
      cluster.set(c.pair.a);
      cluster.set(c.pair.partner);
      grows = true;
    }
  }
  return held ? cluster : BodySet{};
}

}  // namespace mirocup::simulator
