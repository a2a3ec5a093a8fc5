// SPDX-License-Identifier: MIT
#include "core/simulator/model/tolerances.hpp"

namespace mirocup::simulator {

Tolerances tolerances_of(Accuracy accuracy) {
  Tolerances t;
  switch (accuracy) {
    case Accuracy::coarse:
      t.touch = 5e-7;
      t.sink = 1e-8;
      t.rest_speed = 2e-3;
      t.followed_per_tick = 0;
      t.step = 34e-3;
      t.step_touch = 5e-7;
      t.step_overlap = 5e-7;
      t.overlap_within_step = 1e-4;
      break;
    case Accuracy::standard:
      break;
    case Accuracy::reference:
      t.sink = 1e-13;
      t.rest_speed = 5e-6;
      t.rest_growth_per_touch = 1.05;
      t.patient_touches = 30;
      t.brief_slide = 1e-13;
      t.brief_slide_growth_per_touch = 1.5;
      t.growth_per_event = 1.02;
      t.slide_growth_per_event = 1.15;
      t.followed_per_tick = 20'000'000;
      t.step = 2e-5;
      break;
  }
  return t;
}

}  // namespace mirocup::simulator
