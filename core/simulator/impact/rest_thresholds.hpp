// SPDX-License-Identifier: MIT
//
// Rest thresholds: the limits below which motion counts as rest, and how they grow within a tick.
//
// They guard against Zeno behaviour: infinitely many events in finite time. Bodies in a crowd would
// bounce, let go and grip again ever faster, ever weaker. So the limits start at rounding and grow
// with the impacts of a body, or with the events of the tick. Motion below a limit is stopped and
// never thrown back, so growing limits add no energy.
//
//   limit                    from             factor, for each      up to
//   restitution_threshold()  see below        3     impact          -
//   penetration()            1e-12 m          4     impact, from    contact_gap, 1e-10 m
//                                                   the 9th on
//   min_slip_speed()         1e-6 m/s         8     impact          the restitution threshold
//   slip_threshold()         rounding         2     event           slow_slip, 1e-7 m/s
//                            1e-7 m/s         1.05  event           restitution_threshold, 2e-4 m/s
//   roll_threshold()         rounding         1.3   event           restitution_threshold, 2e-4 m/s
//   min_duration()           1e-8 s           1.3   event           max_min_duration, 2e-3 s
//                                             8     event that it forced
//
// The restitution threshold is 1e-10 m/s at the first impact of a body in the tick, and 1.8e-3 m/s
// at the second; from there on it grows. Two bodies that were in contact before the tick, and have
// had no impact in it, start with 2e-4 m/s instead.
//
// The numbers are those of Tolerances at the level `standard` and of settings::rest_thresholds. An
// impact counts only for its two bodies, so a crowd does not change the limits of bodies outside
// it. The count of a pair is the larger one of its two bodies. An event counts for all bodies.
//
// The event budget (Tolerances::event_budget) is the last resort: a body that has used it up is
// time-stepped. Uses model and trajectory.
#pragma once

#include "core/simulator/model/body_pair.hpp"
#include "core/simulator/model/parameters.hpp"
#include "core/simulator/model/solver_settings.hpp"
#include "core/simulator/model/tolerances.hpp"

#include <array>

namespace mirocup::simulator::impact {

// The rest thresholds and event budgets of one world. Times are s of the tick. Belongs to the
// world's thread.
class RestThresholds {
 public:
  explicit RestThresholds(const Tolerances& tolerances);

  // Starts a tick: all limits and budgets are those of its start. `touching` are the bodies that
  // have a contact now.
  void begin_tick(const BodySet& touching);

  // To be called when bodies were placed: contacts that exist now count as new in the next tick.
  void forget();

  // What a tick leaves to the next one.
  struct Memory {
    BodySet touching;     // bodies with a contact when the tick began
    BodySet hit;          // bodies with an impact in it
    BodySet over_budget;  // bodies that used up their event budget in it
  };
  Memory memory() const { return {touching_, hit_, over_budget_}; }
  void recall(const Memory& memory);

  // Counts an impact of both bodies of a pair at time t.
  void note_impact(const Pair& pair, double t);

  // Counts a bounce as an impact of those of the two bodies that have none at time t yet: wheels
  // that grip again can throw a robot at a body that it touches already.
  void note_bounce(const Pair& pair, double t);

  // Counts an event. Each involved body pays (n m)^2 of its budget. Here n is the number of bodies
  // involved, and m is the number of bodies that these have met in this tick, themselves included.
  // `was_forced` is true if the event ended a curve as soon as min_duration() allowed.
  void note_event(const BodySet& involved, bool was_forced);

  // Puts all bodies of an island over budget from the start of the tick if both hold: one of them
  // went over budget in the last tick, and a single event of the whole island would cost the whole
  // budget. To be called at the start of a tick for each island.
  void note_island(const BodySet& island);

  // Returns the bodies that have used up their event budget.
  const BodySet& over_budget() const { return over_budget_; }

  // Returns the approach speed, m/s, up to which the pair does not bounce.
  double restitution_threshold(const Pair& pair) const;
  // Returns by how much a pair in contact must come closer to have an impact again, m.
  double penetration(const Pair& pair) const;
  // Returns the fastest lateral slip, m/s, that is removed together with the impact that caused it.
  double min_slip_speed(int robot) const;
  // Return the speeds, m/s, up to which sliding wheels and a rolling ball in contact hold.
  double slip_threshold() const { return slip_threshold_; }
  double roll_threshold() const { return roll_threshold_; }
  // Returns for how long a contact or a grip holds at least, s.
  double min_duration() const { return min_duration_; }
  // Returns for how long a curve that starts at time t should hold, s. It is a small multiple of
  // the mean time between the impacts of this tick or of the time since the last impact, whichever
  // is longer. An impact would probably cut a longer curve short.
  double preferred_duration(double t) const;

 private:
  static constexpr int max_counted = settings::rest_thresholds.max_counted;
  using GrowthTable = std::array<double, max_counted + 1>;  // a limit by the number of impacts
  static GrowthTable growing(double first, double growth, double limit, int free = 0);

  static int cost_of_event(const BodySet& involved, const BodySet& met);
  int impacts_of(const Pair& pair) const;
  void count(int body, double t);
  // True if the body has been in contact since before the tick, and had no impact in it.
  bool is_lasting(int body) const { return in_contact_before_[body] && impacts_[body] == 0; }

  Tolerances tolerances_;
  GrowthTable restitution_after_impacts_, penetration_after_impacts_, slip_after_impacts_;

  // "Now" is this tick, "before" the last one.
  BodySet touching_;                       // bodies with a contact when the tick began
  BodySet hit_;                            // bodies with an impact now
  BodySet in_contact_before_;              // bodies with a contact or an impact before
  std::array<BodySet, max_bodies> met_{};  // by body: itself and those it had an impact with
  std::array<int, max_bodies> impacts_{};  // by body, less forgotten ones; at most max_counted
  std::array<double, max_bodies> last_impact_of_{};  // by body, s
  std::array<int, max_bodies> event_cost_{};         // by body, summed
  BodySet over_budget_, were_over_budget_;           // now; before
  int all_impacts_ = 0;                              // of pairs, now
  double last_impact_ = 0.0;                         // of any pair, s
  double slip_threshold_ = 0.0;
  double roll_threshold_ = 0.0;
  double min_duration_ = 0.0;
};

}  // namespace mirocup::simulator::impact
