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

// The thresholds of one level; the values here are those of `standard`. "Zeno behaviour" in
// docs/algorithm.md says how they make sure that a tick ends.
struct Tolerances {
  // ---- gaps
  double contact_gap = 1e-10;  // m: bodies with a smaller gap are in contact
  double penetration = 1e-12;  // m: bodies in contact that overlap more than this collide again

  // ---- restitution: a contact that approaches more slowly than its threshold does not bounce
  // m/s: the threshold of a contact that did not press before.
  double first_touch_threshold = 1e-10;
  // m/s: the threshold of a contact that presses. It is larger than any speed that motors can give
  // a body on the distance `penetration`.
  double pressing_threshold = 5e-4;
  // m: an impact ends its series if the bounces that would follow are not higher than this. The
  // wheels of a robot in a series lose at once a slip that would take them no further than this.
  double series_height = 3e-7;

  // ---- events of contact clusters
  double min_contact_duration = 1e-8;  // s: shortest time for which a contact or a grip holds
  // m/s: a slower slide of a robot in contact is stopped, and so is a slower ball in contact.
  double slow_motion = 1e-7;
  // Event budget of a tick of up to 34 ms, for each body of the world; a world with fewer than
  // seven bodies has the budget of seven, and a longer tick has more in proportion. An event with
  // n bodies costs n if n is one or two, n^2 up to ten, and n^4 / 100 beyond. In a world of
  // seven or more bodies the events of two or more cost 6 each on average, or more: a tick of
  // seven bodies can have 560 events of one body, 94 of two, 35 of four or 12 of all. The bodies
  // of an event beyond the budget are time-stepped for the rest of the tick, together with the
  // bodies that they touch. In the next tick these bodies have an eighth of the budget, and an
  // island of five or more bodies that holds one of them and moves is time-stepped from the start:
  // a lasting scrum costs steps, a single crowded tick costs events. With a budget of 0 every body
  // in contact is time-stepped.
  int event_budget = 80;

  // ---- time stepping
  double max_step = 3e-3;              // s: longest step
  double step_gap = 1e-10;             // m: gaps and overlaps that may remain at the end of a step
  double step_gap_in_conflict = 1e-7;  // m: the same if contacts nearly contradict each other
  double intermediate_penetration = 8e-7;  // m: overlap that is allowed inside a step
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
