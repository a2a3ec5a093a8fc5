// SPDX-License-Identifier: MIT
#include "core/simulator/neighbours.hpp"

namespace mirocup::simulator {

std::span<Neighbour> Neighbours::find(const Arena& arena, std::span<const Box> boxes,
                                      const BodySet& changed) {
  int kept = 0;
  for (int i = 0; i < count_; ++i) {
    const Pair& pair = list_[i].pair;
    const bool is_stale = changed[pair.a] || (!pair.with_obstacle() && changed[pair.partner]);
    if (!is_stale) list_[kept++] = list_[i];
  }
  count_ = kept;

  for (int i = 0; i < arena.bodies(); ++i) {
    if (!changed[i]) continue;
    for (int j = 0; j < arena.bodies(); ++j) {
      if (j == i || (changed[j] && j > i)) continue;
      const Pair pair = pair_of(i, j);
      if (boxes_meet(arena, pair, boxes)) add(pair);
    }
    if (is_far_from_obstacles(arena, i, boxes[i])) continue;
    for (int k = 0; k < plane_walls + end_walls; ++k) {
      const Pair pair = pair_with_obstacle(i, k);
      if (boxes_meet(arena, pair, boxes)) add(pair);
    }
  }
  return {list_.data() + kept, static_cast<std::size_t>(count_ - kept)};
}

void Neighbours::add(const Pair& pair) {
  if (count_ < static_cast<int>(list_.size())) list_[count_++] = {.pair = pair};
}

}  // namespace mirocup::simulator
