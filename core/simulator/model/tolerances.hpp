// SPDX-License-Identifier: MIT
//
// How exactly bodies in lasting contact are followed: every threshold of the simulator.
#pragma once

#include "core/base/names.hpp"

#include <array>

namespace mirocup::simulator::inline model {

// How exact the simulator is asked to be. Free motion and single impacts are exact to rounding at
// every level; what differs is how closely bodies in lasting contact are followed. A match is always
// played with the standard ones.
enum class Accuracy { coarse, standard, reference };

struct Tolerances {
  double contact_gap = 1e-10;  // m: bodies with a smaller gap are in contact
  double penetration = 1e-12;  // m: bodies in contact that come closer by this hit each other anew
  // m/s: an approach slower than this does not bounce, it rests. The first is for a body's first
  // touch; the other, for bodies that are in company already, is more than what the motors can gain
  // over `sink`, so that bouncing comes to an end.
  double first_restitution_threshold = 1e-10;
  double restitution_threshold = 2e-4;
  // Within a tick patience wears off (patience.hpp). What counts as rest grows with each touch of a
  // body; `sink` with each beyond the patient ones, up to `touch`. A touch is forgotten after a
  // while, s, but where there are so many, bouncing has to end.
  double restitution_growth_per_touch = 3.0;
  double impact_memory = 2e-3;
  int remembered_touches = 4;
  double penetration_growth_per_touch = 4.0;
  int free_touches = 8;
  // An impact stops wheels that it makes slide no faster than this, m/s: they would grip again
  // within v / grip g.
  double min_slip_speed = 1e-6;
  double min_slip_growth_per_touch = 8.0;
  double min_contact_duration = 1e-8;  // s: the shortest that bodies press and wheels grip
  // Of that and of the slowest rolling in contact, for each event; of the slowest sliding, up to
  // `slip_threshold`, m/s, from where on it grows slowly.
  double growth_per_event = 1.3;
  double slip_growth_per_event = 2.0;
  double slow_slip = 1e-7;
  // What a body's events of a tick may cost, summed: of each the square of how many bodies it involves,
  // times the square of how many these have met in the tick. 3 of four, 7 of three or 34 of two that meet
  // nobody else. Beyond, the body and what it touches go on in small steps; five that still touch then do
  // so from the next tick's begin.
  int event_budget = 540;
  double max_step = 3e-3;              // s: the longest of those
  double step_gap = 1e-10;             // m: what is left of gaps and overlaps at the end of one,
  double step_gap_in_conflict = 1e-7;  // m: where contacts nearly contradict each other,
  double intermediate_penetration = 8e-7;  // m: and between its ends
};

Tolerances tolerances_of(Accuracy accuracy);

}  // namespace mirocup::simulator::inline model

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<simulator::Accuracy>{
    "coarse", "standard", "reference"};

}  // namespace mirocup
