// SPDX-License-Identifier: MIT
//
// Rest thresholds: the limits below which motion counts as rest.
//
// They guard against Zeno behaviour: infinitely many events in finite time.
//
// Bounces. Impacts of one contact form a series if each approach is at most about the restitution e
// times the last. After a flight of time T that ends with an approach v, the next bounce is
// e^2 v T / 4 high. If the contact presses with an acceleration a, the bounce is e^2 v^2 / 2 a
// high. If that height is at most (1 - e) series_height, the impact ends the series: its impulse
// stops the contact, which then presses with the mean force of the impacts that are left out. Every
// other impact bounces: an approach that is faster than a series allows, a higher bounce, a first
// touch, and any impact at e = 1. The exception: in a contact that presses, approaches up to
// Tolerances::pressing_threshold count as rounding and do not bounce.
//
// The contacts of the last contact_memory seconds are remembered from tick to tick, so the end of a
// tick does not interrupt a series.
//
// Forces. A contact or a grip holds for at least min_duration(), which is 1e-8 s at the start of a
// tick. If a curve ends as soon as this minimum allows, contacts press and let go in alternation.
// Then min_duration() grows by a factor of 8, up to max_min_duration, 2e-3 s.
//
// The numbers are those of Tolerances at the level `standard` and of settings::rest_thresholds.
// The event budget (Tolerances::event_budget) is the last resort: bodies with events beyond it
// are time-stepped. Uses collision, model and trajectory.
#pragma once

#include "core/simulator/collision/contact_constraint.hpp"
#include "core/simulator/model/solver_settings.hpp"
#include "core/simulator/model/tolerances.hpp"

#include <array>
#include <cstdint>

namespace mirocup::simulator::impact {

// The rest thresholds and the event budget of one world. Times are s of the tick. Belongs to the
// world's thread.
class RestThresholds {
 public:
  // The thresholds of a world of this many bodies.
  RestThresholds(const Tolerances& tolerances, int bodies);

  // Starts a tick of `duration` seconds with the least min_duration(), an unspent budget and no
  // impacts. Until then contacts are remembered as at the end of the last tick: for recall().
  void begin_tick(double duration);
  // Ends a tick of `duration` seconds. Afterwards, remembered times count from the end of that
  // tick.
  void end_tick(double duration);
  // To be called at a tick's end with the bodies that are then in a step. With an event budget of 0
  // every body is over budget in every tick. Then were_over_budget() names in the next tick only
  // these bodies.
  void note_steps(const BodySet& bodies) {
    if (budget_ == 0) memory_.over_budget = bodies;
  }

  // To be called when bodies were placed: contacts that exist now count as new.
  void forget() { memory_ = {}; }

  // A contact that was closed not long ago.
  struct Touched {
    std::uint8_t a, partner;  // of the pair
    std::uint8_t corner;      // index: of the point's side; 0 for the ball
    bool point_on_a;          // the pair's a is the point's side
    double time = 0.0;        // s of the tick: when the contact was closed last
    double approach = 0.0;    // m/s, at its last impact
    double pressing = 0.0;    // m/s^2: the closing acceleration that its force prevents at `time`
  };
  // What a tick leaves to the next one.
  struct Memory {
    BodySet over_budget;  // bodies that went over budget in the tick
    int count = 0;        // elements in use of `touched`
    std::array<Touched, collision::max_contacts> touched;
  };
  const Memory& memory() const { return memory_; }
  void recall(const Memory& memory) { memory_ = memory; }

  // Counts an impact of two bodies at time t.
  void note_impact(double t);

  // True if the contact was closed within the last contact_memory seconds before this tick.
  bool remembers(const collision::Contact& contact) const { return find(contact) != memory_.count; }

  // Remembers a contact that is closed at time t, with its last impact and its force.
  void note_contact(const collision::Contact& contact, std::span<const solver::InverseMass> mass,
                    double t);

  // Counts an event; Tolerances::event_budget has what it costs. If the world has spent its budget
  // of the tick, the bodies involved are over budget. Bodies that were over budget in the last tick
  // are over budget again if they have an event once 1/budget_divisor of the budget is spent.
  // `was_forced` is true if the event ended a curve as soon as min_duration() allowed.
  void note_event(const BodySet& involved, bool was_forced);

  // Puts all bodies of a large island over budget from the start of the tick if one of them went
  // over budget in the last tick. To be called at the start of a tick for each island.
  void note_island(const BodySet& island);

  const BodySet& over_budget() const { return memory_.over_budget; }
  // Returns the bodies that were over budget in the last tick.
  const BodySet& were_over_budget() const { return were_over_budget_; }

  // Returns the approach speed, m/s, up to which the contact does not bounce at time t.
  double restitution_threshold(const collision::Contact& contact, double t) const;
  // Returns for how long a contact or a grip holds at least, s.
  double min_duration() const { return min_duration_; }
  // Returns for how long a curve that starts at time t should hold, s; an impact would probably cut
  // a longer curve short. It is times_between_impacts times the mean time between the impacts of
  // this tick or the time since the last impact, whichever is longer; `never` before the first one.
  double preferred_duration(double t) const;

 private:
  // Returns the index of the contact, or the count if it is not remembered.
  int find(const collision::Contact& contact) const;
  void drop_touched_before(double t);

  Tolerances tolerances_;
  Memory memory_;
  int least_budget_;  // of a short tick
  // Least mean cost of the events of two or more bodies: the other bodies that a body may meet
  // next, counted up to those of the least budget.
  int cost_of_meeting_;
  int budget_ = 0;            // of this tick
  int spent_ = 0;             // the part of budget_ that is spent so far
  int meetings_ = 0;          // events of two or more bodies in this tick, so far
  BodySet were_over_budget_;  // in the last tick
  int all_impacts_ = 0;       // in this tick, so far
  double last_impact_ = 0.0;  // s of the tick
  double min_duration_ = 0.0;
};

}  // namespace mirocup::simulator::impact
