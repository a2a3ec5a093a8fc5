// SPDX-License-Identifier: MIT
//
// All constants of the simulator's solvers that no caller chooses, each with name, unit and reason.
//
// An accuracy level chooses the Tolerances (tolerances.hpp). The numbers here are the same at every
// level. They were tuned on crowds of six and of twenty-two robots (build/physics_bars); a change
// of any of them changes the state hash. The unit stands in brackets; [1] is a share or a factor
// without unit, "[1] of X" a share of X. Each struct has the name of the file that uses it.
#pragma once

namespace mirocup::simulator::settings {

// ---- trajectory/

inline constexpr struct TaylorSeriesSettings {
  // [unit of the series] A root search looks for the time at which a series falls to a level, for
  // example a gap to 0. The series has reached the level when its value is this close to it. This
  // is more than the rounding of a gap, and far less than any tolerance.
  double root_tolerance = 1e-14;
  // [1] Steps of the search in one window of its interval before a smaller window is tried.
  int steps_per_window = 8;
  // [1] Windows of one search. Only a series that stays within rounding of its level needs so many.
  int max_windows = 256;
  // [1] Factors of the window's length: window_growth after a window without a root, window_shrink
  // after a window that its steps did not get through, because the curvature bound was too loose.
  double window_growth = 2.0;
  double window_shrink = 0.25;
  // [1] Length of a segment times its fastest rate. 14 terms of an exponential or of a steady turn
  // are then exact to 1e-13 of the motion: 0.6^14 / 14! = 9e-15.
  double length_times_rate = 0.6;
} taylor_series;

inline constexpr struct SegmentSettings {
  // [m; 1 for headings] Limit of the sum of the last two terms of a pose. The error of the
  // truncation is a hundredth of this limit or less.
  double free_truncation = 1e-10;
  // [m; 1] The same for bodies in contact. It is looser, because pressing contacts keep their gaps
  // at zero in any case.
  double contact_truncation = 4e-10;
  // [m; 1] Terms that grow from one to the next but are smaller than this are ignored.
  double min_growth = 1e-13;
  // [1] Factor by which the length is cut, again and again, until the series converge.
  double length_shrink = 0.85;
  // [rad] Below this turn, the first terms of sin(a)/a and (1 - cos(a))/a are exact to 1e-13.
  double small_turn = 1e-4;
} segment;

inline constexpr struct DifferentialDriveSettings {
  // [m/s] Slower lateral motion is the rounding of wheels that roll.
  double slip_round_off = 1e-13;
  // [1] Share by which the limit of the lateral acceleration lies above grip g. A slide that begins
  // at this limit has a direction in spite of rounding.
  double grip_margin = 1e-7;
  // [s] The least lag of a motor. A segment is cut to a part of the lag, so a robot has at most
  // 5500 segments in a tick.
  double least_lag = 1e-5;
} differential_drive;

inline constexpr struct RollingBallSettings {
  // [m/s] A slower ball lies still.
  double roll_round_off = 1e-10;
  // [m/s] Below this speed the direction in which a pushed ball brakes is kept fixed, because it
  // is not smooth where the speed is zero.
  double min_speed_with_direction = 1e-3;
  // [1] For RollingFriction::per_axis. At the start of a segment, a component of the velocity
  // counts as slow if it exceeds k by at most this share, because rounding may leave it just above
  // k. A slow component that speeds up ends its segment when it exceeds k by twice this share, so
  // events do not repeat at k.
  double k_margin = 1e-9;
} rolling_ball;

inline constexpr struct ClosedFormSettings {
  // [1] Limit of the turn (rad) plus the number of motor time constants in one span. Up to here the
  // quadrature rule of eight nodes is exact to 1e-16 of the path.
  double max_angle = 2.5;
  // [1] Share by which a box is larger than the path requires, to allow for rounding.
  double box_margin = 1e-9;
} closed_form;

inline constexpr struct MotionBoundSettings {
  // [m] Added to a curve's deviation from its chord, to allow for rounding.
  double position_round_off = 1e-12;
} motion_bound;

// ---- solver/

// A and b are those of the problem in box_qp.hpp.
inline constexpr struct BoxQpSettings {
  // [1] Smallest pivot, as a share of its diagonal entry. A smaller pivot says that the unknown
  // depends on others, for example where two contacts push the same bodies in the same direction.
  // The pivot is then raised to this share. As a result the unknown hardly moves if the other
  // equations leave it undetermined, and goes to its bound if they contradict it.
  double min_pivot = 1e-10;
  // [1] Gradient that counts as zero, as a share of the largest |b|.
  double gradient_tolerance = 1e-14;
  // [1] Where rows nearly contradict each other, rounding can make the solver release the same
  // bounds again and again. So after `exact_rounds` rounds the gradient tolerance is multiplied by
  // `tolerance_growth` in each round, up to `max_gradient_tolerance`. After `max_rounds` rounds the
  // solver returns the values that it has reached.
  int exact_rounds = 8;
  double tolerance_growth = 4.0;
  double max_gradient_tolerance = 1e-6;
  int max_rounds = 64;
  // [unknowns] From this size on a warm start pays. Six robots around the ball give fewer.
  int warm_start_size = 32;
} box_qp;

// A and D are those of the problem in regularized_qp.hpp.
inline constexpr struct RegularizedQpSettings {
  // [1] Compliance of a contact: D is this share of A's diagonal.
  double regularization = 1e-5;
  // [1] Limit of the rounds of Newton's method; few are needed.
  int max_newton_rounds = 40;
  // [1] Number of fractions of Newton's step that the line search tries: 1, 1/2, 1/4, 1/8.
  int max_backtracks = 4;
  // [1] If the first bound is farther away than this fraction of the step, the step to that bound
  // is tried first. If it is nearer, fractions of the step are tried first.
  double near_bound = 0.1;
  // [1] Armijo's constant: share of the decrease promised by the gradient that a step must reach.
  double armijo_fraction = 0.1;
  // [1] Rounding of the objective, as a share of it.
  double value_round_off = 1e-14;
  // [1] The step to the first bound is multiplied by this, because rounding could otherwise leave
  // the unknown just short of its bound, round after round.
  double bound_round_off = 1.0 + 1e-12;
} regularized_qp;

inline constexpr struct PivotedCholeskySettings {
  // [1] An equation whose pivot is at most this share of its diagonal entry follows from the others
  // and is dropped. This is less than BoxQpSettings::min_pivot, because an equation that is dropped
  // by mistake leaves a contact without its force; a pivot that is raised there only makes an
  // unknown compliant.
  double redundant_pivot = 1e-11;
  // [1] An equation whose pivot is above this share of its diagonal entry is clearly independent
  // and keeps its place in the order.
  double independent_pivot = 1e-3;
} pivoted_cholesky;

// ---- collision/

inline constexpr struct TimeOfImpactSettings {
  // [1] Separating axes that are tried for a pair; two or three are usual. After the last one the
  // search stops and returns the time that it has reached. The bodies do not touch at that time;
  // the caller notices this and searches again from there.
  int max_axes = 64;
  // [1] A ball has left a corner's sector when its centre is farther outside than this multiple of
  // root_tolerance.
  double sector_round_off = 4.0;
} time_of_impact;

// ---- impact/

inline constexpr struct ImpactSettings {
  double min_approach = 1e-13;  // [m/s] slower approaches are rounding
  // [m/s] Rounding of the rate of a contact that presses. A contact that approaches no faster is
  // left out when the others bounce; else rounding would decide its share of the impulses.
  double resting_approach = 1e-9;
  int max_rounds = 64;  // [1] after them, contacts that still approach are stopped without bounce
  double energy_round_off = 1e-14;  // [1] of the energy: a smaller gain of a round counts as none
} impact;

inline constexpr struct RestThresholdsSettings {
  // [1] A curve is long enough if it holds for this multiple of the mean time between the impacts
  // of the tick, or of the time since the last impact, whichever is longer.
  double times_between_impacts = 2.0;
  int bodies_of_least_budget = 7;  // a world of fewer bodies has the budget of this many
  double budget_duration = 0.034;  // [s] a longer tick has as many budgets as it has such parts
  double most_budget = 1e9;        // [1] of a tick of any length
  // [1] Bodies that were over budget in the last tick have the budget divided by this.
  int budget_divisor = 8;
  // [bodies] Beyond this size the cost of an event grows with the fourth power of its bodies: the
  // time of a factorisation grows with the cube, and the number of factorisations with the bodies.
  int large_event = 10;
  // [bodies] From this size on, an island is stepped from the start of a tick if one of its bodies
  // was over budget in the last tick.
  int large_island = 5;
  // [1] Factor by which min_duration() grows when a curve ends as soon as min_duration() allows.
  double forced_growth = 8.0;
  double max_min_duration = 2e-3;  // [s]
  double contact_memory = 0.02;    // [s] a contact that has been open for longer is forgotten
  // [1] An approach up to e + this * (1 - e) times its contact's last one may belong to a series.
  double series_margin = 0.5;
  // [m/s^2] Largest acceleration with which a contact that an impact has opened closes by itself.
  // An approach that needed more comes from a hit by another body and belongs to no series.
  double max_acceleration = 5e3;
} rest_thresholds;

// ---- resting_contact/

inline constexpr struct ContactForcesSettings {
  double min_force = 1e-9;               // [N] a smaller force is rounding: the contact is open
  double min_slip_acceleration = 1e-10;  // [m/s^2] a smaller one is rounding: the wheels hold
  double min_rate = 1e-12;               // [m/s] a slower change of a gap counts as none
  double weak_share = 1e-3;              // [1] of the largest force: a smaller force is weak
  double min_closing = 1e-9;  // [m/s^2] weak forces stay if without them a gap would close faster
  // [1] Friction agrees with the normal forces if these change by at most this share of the largest
  // one in a round. If they still change more after friction_rounds, the bodies are jammed:
  // friction holds itself up.
  double friction_tolerance = 1e-9;
  int friction_rounds = 64;
  // [1] The diagonal of the problem's matrix A grows by this share. If wheels and walls hold a
  // robot from both sides, many sets of forces would do; the growth selects the smallest one, and
  // friction follows from it.
  double friction_compliance = 1e-6;
  // [m/s^2] A contact at rest sticks if it would begin to slide with a smaller acceleration. The
  // compliance alone gives a wedged robot a thousandth of this acceleration.
  double min_slide_acceleration = 1e-3;
} contact_forces;

inline constexpr struct ContactMotionSettings {
  double edge_overhang = 1e-10;    // [m] a corner this far beyond the edge's end has left it
  double closed_gap_share = 0.01;  // [1] of Tolerances::penetration: a smaller gap is not corrected
  double max_displacement = 1e-9;  // [m] no gap is corrected if a body would move farther than this
  // A body whose speeds and accelerations are all below these two is at rest.
  double resting_speed = 1e-10;        // [m/s, rad/s]
  double resting_acceleration = 1e-9;  // [m/s^2, rad/s^2]
  double friction_round_off = 1e-14;   // [1] of a force's term: a smaller change ends the rounds
} contact_motion;

inline constexpr struct ContactSeriesSettings {
  // [1] Multiple of root_tolerance. A series that starts at most this far above its level is not
  // searched: the search would end at the root at which the last curve ended.
  double restart_margin = 10.0;
} contact_series;

// ---- stepping/

inline constexpr struct StepTrajectoriesSettings {
  // [1] of Tolerances::intermediate_penetration: a smaller overlap is not worth a correction.
  double min_correction_share = 0.25;
  // [m] A larger correction would make the body's velocity differ too much from its twist.
  double max_correction = 2e-5;
  double correction_tolerance = 1e-3;  // [1] of the largest overlap: precision of the corrections
  double length_safety = 0.8;  // [1] of the permitted overlap: the next step is to reach this share
  double max_growth = 2.0;     // [1] largest ratio of a step's length to that of the step before
} step_trajectories;

inline constexpr struct TimeStepperSettings {
  // [1] of the ball's radius: no body moves further against the others in a step, or it could end
  // up behind what it hit.
  double max_travel_in_radii = 0.5;
  // [1] The twists that a step finds may move a body by up to this multiple of the travel above.
  double travel_overrun = 1.5;
  int max_refinements = 10;  // fixed-point iterations for the gaps at the end of a step
  // The first `strict_refinements` of these iterations must meet Tolerances::step_gap, later ones
  // only step_gap_in_conflict.
  int strict_refinements = 4;
  double impulse_tolerance = 1e-9;  // [1] of the largest relative velocity: precision of impulses
  int max_halvings = 6;             // of the step's length; then the last attempt is accepted
  // Overlaps at the start of a step are removed at `max_undoing_speed` [m/s] at most, because a
  // faster removal would add energy. A step that lasts `undone_overlap` [m] / `max_undoing_speed`
  // or longer removes the whole overlap.
  double max_undoing_speed = 2e-4;
  double undone_overlap = 1e-7;
  // [1] Factor of a remembered wheel force, so that rounding does not take it off its bound.
  double force_round_off = 1.0 + 1e-12;
  // [1] Factor of a number of steps before it is rounded up, so that rounding adds no step.
  double count_round_off = 1.0 - 1e-9;
  double min_step_share = 1.0 / 64.0;  // [1] of Tolerances::max_step: no shorter step is proposed
  // [1] A step that was cut to less than this share of its wanted length shortens no later step.
  double min_informative_share = 0.5;
  int friction_rounds = 10;  // rounds in which the bounds of friction follow the normal impulses
} time_stepper;

// ---- world.cpp

inline constexpr struct WorldSettings {
  // [1] of a step's length. If the rest of the tick after a step would be shorter than this, the
  // step ends with the tick.
  double min_remaining_share = 0.5;
  int max_estimates = 2;  // refinements of a pair's contact time before the exact search
  // [1] of min_duration(): a segment whose length differs from min_duration() by at most this share
  // counts as forced: it ended as soon as min_duration() allowed.
  double forced_end_round_off = 1e-3;
  // [1] of Tolerances::contact_gap: a deeper overlap is projected away at an event.
  double projected_overlap = 2.0;
  double first_contact_gap = 1e-10;  // [m] a contact that is not remembered has at most this gap
  double resting_speed = 1e-6;       // [m/s] an island that is slower leaves time stepping
  // [events] If the event budget is 0, a lone robot that slides along a wall is followed event by
  // event until the tick has had this many events.
  int events_of_sliding = 32;
} world;

inline constexpr struct SceneSettings {
  double max_tick = 0.033;  // [s] the longest tick in which a scene is run: the paper's sample time
} scene;

}  // namespace mirocup::simulator::settings
