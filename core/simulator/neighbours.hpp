// SPDX-License-Identifier: MIT
//
// Which pairs may touch before their segments end, and when. Pairs whose swept boxes stay apart are
// not here and cost nothing more.
#pragma once

#include "core/simulator/arena.hpp"

#include <array>
#include <bitset>
#include <span>

namespace mirocup::simulator {

using BodySet = std::bitset<max_bodies>;

struct Neighbour {
  Pair pair;
  double touch = never;
};

class Neighbours {
 public:
  std::span<const Neighbour> list() const {
    return {list_.data(), static_cast<std::size_t>(count_)};
  }

  void clear() { count_ = 0; }

  // Finds the neighbours of the changed bodies anew, at time t.
  void refresh(const Arena& arena, std::span<const Segment> segments, std::span<const Box> boxes,
               const BodySet& changed, double t);

 private:
  void add(const Arena& arena, const Pair& pair, std::span<const Segment> segments, double t);

  std::array<Neighbour, 512> list_;
  int count_ = 0;
};

}  // namespace mirocup::simulator
