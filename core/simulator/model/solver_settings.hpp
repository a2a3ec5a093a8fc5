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
  // [1] A curve is long enough if it holds for this many mean times between the collisions of the
  // tick, or times since the last one.
  double times_between_collisions = 2.0;
  double forced_growth = 8.0;      // [1] of min_duration() where it forced the end of a curve
  double max_min_duration = 2e-3;  // [s]
  // [1] Growth of slip_threshold() per event from Tolerances::slow_slip on. The slides of a large
  // crowd may be a little faster than any limit, and come back as fast.
  double late_slip_growth = 1.05;
  int max_counted = 40;  // [1] collisions of a body in a tick; more count as this many
} rest_thresholds;

// ---- resting_contact/

inline constexpr struct ContactForcesSettings {
  double min_force = 1e-9;               // [N] a smaller force is rounding: the contact is open
  double min_slip_acceleration = 1e-10;  // [m/s^2] a smaller one is rounding: the wheels hold
  double min_rate = 1e-12;               // [m/s] a slower change of a gap counts as none
  double weak_share = 1e-3;              // [1] a smaller share of the largest force is a weak force
  double min_closing = 1e-9;  // [m/s^2] a gap may close this fast where a weak force is dropped
} contact_forces;

inline constexpr struct ContactMotionSettings {
  double edge_overhang = 1e-10;    // [m] a corner leaves its edge this far beyond the edge's end
  double closed_gap_share = 0.01;  // [1] of Tolerances::penetration: a smaller gap stays
  double max_displacement = 1e-9;  // [m] nearly contradicting contacts ask for more: gaps stay
  double resting_speed = 1e-10;    // [m/s, rad/s] slower, and with less acceleration: at rest
  double resting_acceleration = 1e-9;  // [m/s^2, rad/s^2]
} contact_motion;

inline constexpr struct ContactSeriesSettings {
  // [1] of trajectory::root_tolerance, above the level of the last root: the next search must not
  // end at that root again.
  double restart_margin = 10.0;
} contact_series;

// ---- stepping/

inline constexpr struct StepTrajectoriesSettings {
  // [1] of Tolerances::intermediate_penetration: a smaller overlap is not worth a correction.
  double min_correction_share = 0.25;
  // [m] a larger correction would give the body another velocity than its twist says.
  double max_correction = 2e-5;
  double correction_tolerance = 1e-3;  // [1] of the largest overlap: precision of the corrections
  double length_safety = 0.8;  // [1] of the permitted overlap: aim of the next step's length
  double max_growth = 2.0;     // [1] ratio of a step's length to that of the last one
} step_trajectories;

inline constexpr struct TimeStepperSettings {
  // [1] of the ball's radius: no body moves further against the others in a step, or it could end
  // up behind what it hit.
  double max_travel_in_radii = 0.5;
  double travel_overrun =
      1.5;                     // [1] ratio to that limit which the twists found in a step may reach
  int max_refinements = 10;    // fixed-point iterations for the gaps at the end of a step
  int strict_refinements = 4;  // of these, the first ones must meet the strict gap tolerance
  double impulse_tolerance = 1e-9;  // [1] of the largest relative velocity: precision of impulses
  int max_halvings = 6;             // of the step's length; then the last attempt is taken
  // Overlaps at the start of a step shrink no faster than this speed [m/s], lest they add energy;
  // but in steps in which that comes to this distance [m] they shrink at once.
  double max_undoing_speed = 2e-4;
  double undone_overlap = 1e-7;
  // [1] a remembered wheel force is enlarged by it, lest rounding takes it off its bound.
  double force_round_off = 1.0 + 1e-12;
  // [1] keeps a time that is a whole number of steps from being divided into one step more.
  double count_round_off = 1.0 - 1e-9;
  double min_step_share = 1.0 / 64.0;  // [1] of Tolerances::max_step: no shorter step is proposed
  double min_informative_share = 0.5;  // [1] a step cut shorter does not shorten the next proposal
  int friction_rounds = 10;            // in which the bounds of friction follow the normal impulses
} time_stepper;

// ---- world.cpp

inline constexpr struct WorldSettings {
  double min_remaining_share = 0.5;  // [1] of a step: a shorter rest of the tick is added to it
  int max_estimates = 2;             // refinements of a pair's contact time before the exact search
  double forced_end_round_off = 1e-3;  // [1] of the minimum duration: a curve that ends at it
  // [1] of Tolerances::contact_gap: a deeper overlap is projected away at an event.
  double projected_overlap = 2.0;
} world;

inline constexpr struct SceneSettings {
  double max_tick = 0.033;  // [s] the longest tick in which a scene is run: the paper's sample time
} scene;

}  // namespace mirocup::simulator::settings
