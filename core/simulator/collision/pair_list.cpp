// SPDX-License-Identifier: MIT
#include "core/simulator/collision/pair_list.hpp"

#include "core/base/assert.hpp"
#include "core/simulator/collision/broad_phase.hpp"

namespace mirocup::simulator::collision {

std::span<CandidatePair> PairList::find(const StaticWorld& world,
                                        std::span<const trajectory::Box> boxes,
                                        const BodySet& changed) {
  int kept = 0;
  for (int i = 0; i < count_; ++i) {
    const Pair& pair = list_[i].pair;
    const bool is_stale = changed[pair.a] || (!pair.with_obstacle() && changed[pair.partner]);
    if (!is_stale) list_[kept++] = list_[i];
  }
  count_ = kept;

  const unsigned long unchanged = bodies_below(world.bodies()) & ~changed.to_ulong();
  for (int i = 0; i < world.bodies(); ++i) {
    if (!changed[i]) continue;
    // A pair of two changed bodies is found once, from the body with the higher index.
    for_each_candidate_pair(world, boxes, i, unchanged | bodies_below(i),
                            [this](const Pair& pair) { add(pair); });
  }
  return {list_.data() + kept, static_cast<std::size_t>(count_ - kept)};
}

void PairList::add(const Pair& pair) {
  MIROCUP_ASSERT(count_ < max_candidate_pairs);  // since no pair is in the list twice
  list_[count_++] = {.pair = pair};
}

CandidatePair* PairList::earliest(double& t) {
  CandidatePair* first = nullptr;
  for (CandidatePair& n : list()) {
    if (n.contact_time > t) continue;
    const bool earlier = first == nullptr || n.contact_time < t || n.pair.a < first->pair.a ||
                         (n.pair.a == first->pair.a && n.pair.partner < first->pair.partner);
    if (!earlier) continue;
    first = &n;
    t = n.contact_time;
  }
  return first;
}

}  // namespace mirocup::simulator::collision
