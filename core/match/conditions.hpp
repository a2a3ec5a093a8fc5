// SPDX-License-Identifier: MIT
//
// The conditions of a leg: by how much a real hall disturbs it.
//
// In an exact leg two deterministic teams play the same game again and again. In a real hall no two
// kick-offs are alike: robots and ball are put down by hand, wheels wear, and a camera sees with
// noise and delay. Conditions say how large each of these disturbances is; the seed of the leg says
// how they turn out (core/match/disturbances.hpp, core/match/camera.hpp).
//
// Every "sigma" is that of a normal distribution that is cut off at two sigma, so no draw is
// absurd. The numbers are chosen, not measured: sources are named where there are any.
#pragma once

#include "core/base/names.hpp"

#include <array>

namespace mirocup::match {

enum class ConditionsPreset {
  exact,   // nothing is disturbed
  hall,    // placing by hand, wheels and floor are disturbed
  camera,  // as hall, and one camera and one radio for everybody
};

// A value of 0 switches its disturbance off, which then costs nothing.
struct Conditions {
  ConditionsPreset preset = ConditionsPreset::exact;  // the values below may differ from it

  // ---- placing by hand at restarts
  double place_sigma_m = 0.0;    // m, along x and y, of each robot and of the ball
  double place_sigma_rad = 0.0;  // rad, of the heading of each robot

  // ---- wheels and floor
  double wheel_gain_sigma = 0.0;    // share by which a wheel is too fast or slow in the whole leg
  double wheel_jitter_sigma = 0.0;  // share by which a wheel deviates from its command in each tick
  double rolling_sigma = 0.0;       // share by which rolling resistance deviates in the whole leg

  // ---- camera
  double see_sigma_m = 0.0;        // m, along x and y, of every robot and of the ball in each tick
  double see_sigma_rad = 0.0;      // rad, of the heading of every robot in each tick
  int delay_ticks = 0;             // age of the observation, ticks
  double unseen_rate = 0.0;        // probability that a seen body is lost in a tick
  double unseen_mean_ticks = 0.0;  // mean number of ticks for which a lost body is not seen

  // ---- radio
  double radio_loss = 0.0;  // probability that a robot does not receive the command of a tick

  bool operator==(const Conditions&) const = default;

  bool disturbs_placing() const { return place_sigma_m > 0.0 || place_sigma_rad > 0.0; }
  bool has_camera() const {
    return see_sigma_m > 0.0 || see_sigma_rad > 0.0 || delay_ticks > 0 || unseen_rate > 0.0;
  }
};

// The largest delay of a camera, ticks.
inline constexpr int max_delay_ticks = 8;

// The preset of matches and leagues that do not choose one.
inline constexpr ConditionsPreset default_preset = ConditionsPreset::hall;

// Returns the conditions of a preset.
Conditions conditions_of(ConditionsPreset preset);

}  // namespace mirocup::match

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<match::ConditionsPreset>{
    "exact", "hall", "camera"};

}  // namespace mirocup
