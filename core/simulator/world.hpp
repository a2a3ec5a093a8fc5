// SPDX-License-Identifier: MIT
//
// All bodies on the field and how they move through one tick.
//
// A tick is played from event to event. Between events every body follows its own segment; an event
// is the first touch of two bodies, wheels that begin or cease to slide, a ball that stops, or a
// contact that opens. Only the bodies that touch at an event are looked at again. Bodies that have
// had more events in a tick than anyone can follow go on in small steps with what they touch, so no
// scene can stall the world; so do heaps from the begin, and bodies that touch with friction (an
// option).
//
// Threads: none; one world belongs to one thread. Nothing is allocated after construction. The same
// commands give the same bits everywhere, and a world turned by 180 degrees stays turned, bit for
// bit.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"
#include "core/simulator/collision/pair_list.hpp"
#include "core/simulator/impact/friction.hpp"
#include "core/simulator/impact/islands.hpp"
#include "core/simulator/impact/rest_thresholds.hpp"
#include "core/simulator/model/tolerances.hpp"
#include "core/simulator/resting_contact/contact_motion.hpp"
#include "core/simulator/solver/box_qp.hpp"
#include "core/simulator/statistics.hpp"
#include "core/simulator/stepping/step_islands.hpp"
#include "core/simulator/stepping/time_stepper.hpp"
#include "core/simulator/tick_events.hpp"
#include "core/simulator/trajectory/closed_form.hpp"

#include <array>
#include <memory>
#include <span>

namespace mirocup::simulator {

class World {
 public:
  // `field` may be null: an infinite plane; else it outlives the world. At most max_robots robots.
  World(const field::Field* field, const Parameters& parameters, const Tolerances& tolerances,
        int robots, bool has_ball);

  World(const World&) = delete;
  World& operator=(const World&) = delete;

  int robots() const { return static_world_.robots; }
  const Parameters& parameters() const { return static_world_.parameters; }
  const collision::StaticWorld& static_world() const { return static_world_; }

  BodyState robot(int i) const;
  BallState ball() const;

  // Puts a body somewhere; it must overlap nothing when the next tick begins.
  void set_robot(int i, const BodyState& state);
  void set_ball(const BallState& state);

  // Where impacts and counts are added from now on; null, as at the beginning: nowhere. It outlives
  // the world or is taken back.
  void set_statistics(RunStatistics* statistics) { statistics_ = statistics; }

  // Plays `duration` seconds under the commands, one per robot.
  const TickEvents& advance(std::span<const WheelCommand> commands, double duration);

 private:
  // Who touches, or whose curve ends.
  struct Event {
    double time;  // s of the tick
    bool is_touch;
    Pair pair;  // of a touch
    BodySet involved;
  };
  Event next_event(double tick_end);
  const collision::CandidatePair* earliest_contact(double& t);
  bool refine_estimate(collision::CandidatePair& n) const;
  void play_event(const Event& event, double tick_end);
  bool was_forced_to_hold(const Event& event) const;
  void resolve_collisions(double t);
  void continue_motion(const BodySet& involved, const BodySet& were_stepping, double t,
                       double tick_end);
  BodySet to_be_stepped(const BodySet& bodies) const;
  void take_steps(const BodySet& candidates, double t, double tick_end);
  void begin_step(const stepping::TimeStepper::Step& taken, double t, double tick_end);

  void grow_island(double t, BodySet& involved);
  void update_pairs(const BodySet& involved, double t, double tick_end);
  void start_closed_form(int body, double t, double tick_end);
  void to_series(int body, double t, double tick_end);
  double earliest_contact_of(const Pair& pair, double t) const;
  BodyState state_at(int body, double t) const;
  Pose pose_of(int body, double t) const;
  void advance_to(double t, const BodySet& involved);
  void collect_contacts(const BodySet& involved, double t);
  void collect_contacts_anywhere();
  void drop_contacts_of(const BodySet& bodies);
  void separate_overlaps();
  void collide(std::span<collision::Contact> contacts, double t);
  void start_segments(const BodySet& involved, double t, double tick_end);

  collision::StaticWorld static_world_;
  std::array<BodyState, max_bodies> bodies_{};              // each at the begin of its segment
  std::array<trajectory::Segment, max_bodies> segments_{};  // of quiet bodies only begin and end
  BodySet closed_form_;
  std::array<BodyState, max_bodies> closed_form_end_;  // of quiet bodies
  trajectory::MotorDecay whole_decay_, rest_decay_;    // over a whole tick, over a rest of one
  std::array<trajectory::Box, max_bodies> boxes_{};
  std::array<trajectory::MotionBound, max_bodies> bounds_{};
  std::array<trajectory::DriveReference, max_robots> drives_{};
  std::array<solver::InverseMass, max_bodies> mass_{};
  std::array<solver::InverseMass, max_bodies> free_mass_{};
  impact::RestThresholds thresholds_;
  collision::PairList pairs_;
  TickEvents events_;
  bool bodies_were_set_ = true;
  stepping::StepIslands step_islands_;
  RunStatistics* statistics_ = nullptr;

  collision::ContactList contacts_;  // of the event being played; between ticks, of all bodies
  impact::Islands islands_;          // of those, always
  std::unique_ptr<solver::BoxQp> qp_;
  std::unique_ptr<solver::RegularizedQp> regularized_qp_;
  std::unique_ptr<resting_contact::ContactForces> forces_;
  std::unique_ptr<resting_contact::ContactMotion> motion_;
  std::unique_ptr<stepping::TimeStepper> steps_;
};

}  // namespace mirocup::simulator
