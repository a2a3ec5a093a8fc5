// SPDX-License-Identifier: MIT
//
// Who goes in a small step, and with whom: those who take one together keep out of each other's way
// until its end, or until somebody else runs into them.
#pragma once

#include "core/simulator/model/body_pair.hpp"

#include <array>

namespace mirocup::simulator::stepping {

class StepIslands {
 public:
  // `begin`: s of the tick.
  void begin_step(const BodySet& members, double start) {
    stepping_ |= members;
    for_each_body(members, [&](int i) {
      island_[i] = members;
      start_[i] = start;
    });
  }
  // Of these bodies, those that were in a step: they no longer are.
  BodySet end_step(const BodySet& bodies) {
    const BodySet left = stepping_ & bodies;
    stepping_ &= ~bodies;
    return left;
  }

  const BodySet& stepping() const { return stepping_; }
  bool is_stepping(int body) const { return stepping_[body]; }
  // When the step began that the body is in, s of the tick.
  double start_of(int body) const { return start_[body]; }
  // Nobody, if the body is not in a step.
  BodySet island_of(int body) const { return stepping_[body] ? island_[body] : BodySet{}; }

  // Does the pair keep out of each other's way by one step?
  bool share_step(const Pair& pair) const {
    if (!stepping_[pair.a]) return false;
    return pair.with_obstacle() || (stepping_[pair.partner] && island_[pair.a][pair.partner]);
  }

 private:
  BodySet stepping_;
  std::array<BodySet, max_bodies> island_;  // of those: who takes the same step
  std::array<double, max_bodies> start_{};  // of that
};

}  // namespace mirocup::simulator::stepping
