// SPDX-License-Identifier: MIT
#include "core/simulator/model/tolerances.hpp"

namespace mirocup::simulator {
inline namespace model {

Tolerances tolerances_of(Accuracy accuracy) {
  Tolerances t;
  switch (accuracy) {
    case Accuracy::coarse:
      t.contact_gap = 5e-7;
      t.penetration = 1e-8;
      t.pressing_threshold = 2e-3;
      t.series_height = 1e-4;
      t.event_budget = 0;
      t.max_step = 34e-3;
      t.step_gap = 5e-7;
      t.step_gap_in_conflict = 5e-7;
      t.intermediate_penetration = 1e-4;
      break;
    case Accuracy::standard:
      break;
    case Accuracy::reference:
      t.penetration = 1e-13;
      t.pressing_threshold = 2e-5;
      t.series_height = 1e-12;
      t.slow_motion = 1e-9;
      t.event_budget = 10'000'000;
      t.max_step = 2e-5;
      break;
  }
  return t;
}

}  // namespace model
}  // namespace mirocup::simulator
