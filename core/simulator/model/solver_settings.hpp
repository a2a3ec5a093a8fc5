// SPDX-License-Identifier: MIT
//
// Every constant of the simulator's solvers that no caller chooses, in one table: name, unit,
// reason.
//
// Tolerances (tolerances.hpp) are what an accuracy level chooses. The numbers here are the same at
// every level. They were tuned on crowds of six and of twenty-two robots (build/physics_bars); a
// change of any of them changes the state hash.
#pragma once

namespace mirocup::simulator::settings {

// ---- trajectory/

// ---- solver/

// ---- collision/

inline constexpr struct TimeOfImpactSettings {
  // [1] Separating axes that are tried for a pair; two or three are usual. Beyond, the time reached
  // is returned as if it were a touch: the caller finds none there and searches on from it.
  int max_axes = 64;
  // [1] Share of trajectory::root_tolerance by which the ball must be outside the sector of a
  // corner to have left it.
  double sector_round_off = 4.0;
} time_of_impact;

// ---- impact/

inline constexpr struct ImpactSettings {
  double min_approach = 1e-13;  // [m/s] slower approaches are rounding
  int max_rounds = 64;          // [1] then all contacts that still approach are stopped for good
  double energy_round_off = 1e-14;  // [1] a round adds energy if it adds more than this share
} impact;

inline constexpr struct RestThresholdsSettings {
  // [1] A curve is long enough if it holds for this many mean times between the impacts of the
  // tick, or times since the last one.
  double times_between_impacts = 2.0;
  double forced_growth = 8.0;      // [1] of min_duration() where it forced the end of a curve
  double max_min_duration = 2e-3;  // [s]
  // [1] Growth of slip_threshold() per event, once it has reached Tolerances::slow_slip. The slides
  // of a large crowd may be a little faster than any limit, and come back as fast.
  double late_slip_growth = 1.05;
  int max_counted = 40;  // [1] impacts of a body in a tick; more count as this many
} rest_thresholds;

// ---- resting_contact/

// ---- stepping/

// ---- world.cpp

}  // namespace mirocup::simulator::settings
