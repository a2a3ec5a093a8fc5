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
      t.restitution_threshold = 2e-3;
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
      t.restitution_threshold = 5e-6;
      t.restitution_growth_per_impact = 1.05;
      t.free_impacts = 30;
      t.min_slip_speed = 1e-13;
      t.min_slip_growth_per_impact = 1.5;
      t.growth_per_event = 1.02;
      t.slip_growth_per_event = 1.15;
      t.event_budget = 20'000'000;
      t.max_step = 2e-5;
      break;
  }
  return t;
}

}  // namespace model
}  // namespace mirocup::simulator
