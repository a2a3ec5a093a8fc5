// SPDX-License-Identifier: MIT
#include "core/match/conditions.hpp"

namespace mirocup::match {

Conditions conditions_of(ConditionsPreset preset) {
  Conditions c;
  c.preset = preset;
  if (preset == ConditionsPreset::exact) return c;
  // Chosen: a careful hand puts a cube down to 2 mm and 1.5 degrees.
  c.place_sigma_m = 0.002;
  c.place_sigma_rad = 0.026;
  // Chosen: wheels of one make differ by a hundredth in radius and motor.
  c.wheel_gain_sigma = 0.01;
  c.wheel_jitter_sigma = 0.01;
  // Chosen: a carpet that was vacuumed, or was not.
  c.rolling_sigma = 0.10;
  if (preset == ConditionsPreset::hall) return c;
  // Chosen: half a pixel of a camera that sees a field of 2 m with 700 pixels.
  c.see_sigma_m = 0.0015;
  c.see_sigma_rad = 0.017;
  // Chosen: grabbing and recognising one picture takes one picture's time.
  c.delay_ticks = 1;
  c.unseen_rate = 0.01;
  c.unseen_mean_ticks = 3.0;
  c.radio_loss = 0.01;
  return c;
}

}  // namespace mirocup::match
