// SPDX-License-Identifier: MIT
//
// The accuracy levels: how closely bodies in lasting contact are followed.
//
// Free motion and single impacts are exact to rounding at every level. The constants that do not
// depend on the level are in solver_settings.hpp.
#pragma once

#include "core/base/names.hpp"

#include <array>

namespace mirocup::simulator {
inline namespace model {

// A level of accuracy and cost. A match is always played with `standard`. `coarse` steps every
// contact in time; `reference` follows every event and is the yardstick of the other two.
enum class Accuracy { coarse, standard, reference };

// The thresholds of one level; the values here are those of `standard`. The impacts of a body
// are counted per tick, and thresholds that grow with that count make sure that a tick ends (see
// "Zeno behaviour" in docs/algorithm.md).
struct Tolerances {
  // ---- gaps
  double contact_gap = 1e-10;  // m: bodies with a smaller gap are in contact
  double penetration = 1e-12;  // m: bodies in contact that overlap more than this collide again

  // ---- restitution: an approach slower than the threshold does not bounce, it comes to rest
  // m/s: the threshold for a body's first impact in a tick, so that this impact always bounces.
  double first_restitution_threshold = 1e-10;
  // m/s: the threshold for bodies that were in contact before the tick and had no impact in it. It
  // ends the bouncing of bodies that motors press together: over the distance `penetration`
  // motors give them less speed than this.
  double restitution_threshold = 2e-4;
  // At the n-th impact of a body in the tick, n >= 2, the threshold is `restitution_threshold`
  // times this to the power n.
  double restitution_growth_per_impact = 3.0;

  // ---- the count of impacts within a tick
  // s: one counted impact of a body is forgotten each time that this long passed without one.
  double impact_memory = 2e-3;
  // Once a body has counted this many impacts, none is forgotten any more, so that bouncing ends.
  int remembered_impacts = 4;
  // Growth factor of `penetration` with each impact beyond `free_impacts`, up to `contact_gap`.
  double penetration_growth_per_impact = 4.0;
  int free_impacts = 8;

  // ---- wheels
  // m/s: slip that an impact causes and that is at most this fast is removed at once. The wheels
  // would grip again within v / (grip g).
  double min_slip_speed = 1e-6;
  // Growth factor of `min_slip_speed` with each impact of a body in the tick.
  double min_slip_growth_per_impact = 8.0;

  // ---- events of contact clusters
  double min_contact_duration = 1e-8;  // s: shortest time for which a contact or a grip holds
  // Growth factor per event of `min_contact_duration` and of the rolling speed that counts as rest.
  double growth_per_event = 1.3;
  // Growth factor per event of the slip that counts as rest, until it reaches `slow_slip`. Above
  // that it grows by 5 % per event.
  double slip_growth_per_event = 2.0;
  double slow_slip = 1e-7;  // m/s
  // Event budget of a body per tick. An event with n bodies that have met m bodies in this tick
  // costs (n m)^2. The default allows 3 events of four bodies, 7 of three or 34 of two. A body over
  // budget is time-stepped for the rest of the tick, together with the bodies that it touches. An
  // island of five or more bodies that went over budget is time-stepped from the start of the next
  // tick. With a budget of 0 every body in contact is always time-stepped.
  int event_budget = 540;

  // ---- time stepping
  double max_step = 3e-3;              // s: longest step
  double step_gap = 1e-10;             // m: gaps and overlaps that may remain at the end of a step,
  double step_gap_in_conflict = 1e-7;  // m: the same where contacts nearly contradict each other
  double intermediate_penetration = 8e-7;  // m: overlap that is allowed between the ends of a step
};

// Returns the thresholds of a level.
Tolerances tolerances_of(Accuracy accuracy);

}  // namespace model
}  // namespace mirocup::simulator

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<simulator::Accuracy>{
    "coarse", "standard", "reference"};

}  // namespace mirocup
