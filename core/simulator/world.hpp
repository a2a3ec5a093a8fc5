// SPDX-License-Identifier: MIT
//
// All bodies on the field, and how they move through one tick.
//
// The simulator is event-driven: between two events every body moves on a smooth trajectory of its
// own. An event is the first contact of two bodies, wheels that begin or cease to slide, a ball
// that stops, or a contact that opens. Only the bodies of an event, and all that touch them, get
// new trajectories. Once the events of a tick have used up its event budget, the bodies of further
// events are time-stepped with everything that they touch, so no scene can stall the world. Large
// islands that went over budget are stepped from the start of the next tick. Contacts with friction
// (an option) are stepped unless they slide. docs/algorithm.md describes the method room by room.
//
// Uses all rooms of core/simulator. Units: m, s, rad, N; times are seconds since the start of the
// tick. Threads: none; a world belongs to one thread. Nothing is allocated after construction.
// Determinism: the same calls give the same bits on every computer. A world that is turned by 180
// degrees gives the same bits, turned.
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
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace mirocup::simulator {

class World {
 public:
  // A world with at most max_robots robots, all bodies at rest at the origin; set them before the
  // first tick. A null `field` is an infinite plane without obstacles; otherwise it outlives the
  // world.
  World(const field::Field* field, const Parameters& parameters, const Tolerances& tolerances,
        int robots, bool has_ball);

  World(const World&) = delete;
  World& operator=(const World&) = delete;

  int robots() const { return static_world_.robots; }
  const Parameters& parameters() const { return static_world_.parameters; }
  const collision::StaticWorld& static_world() const { return static_world_; }

  // Returns the present state of a robot, 0 <= i < robots(), and of the ball, if the world has one.
  BodyState robot(int i) const;
  BallState ball() const;

  // Sets the state of a body. Nothing may overlap when the next tick starts. The memory of
  // contacts and forces is lost, so a restart is the same as in a new world.
  void set_robot(int i, const BodyState& state);
  void set_ball(const BallState& state);

  // The data on which the next tick depends besides the states of the bodies: which of them
  // touched, and the forces with which time steps start warm. Plain data. A copy need not hold more
  // than its first size_of(memory) bytes.
  struct Memory {
    bool bodies_were_set = true;  // since the last tick; if so, nothing below counts
    impact::RestThresholds::Memory thresholds;
    struct Touch {
      std::uint8_t a, partner;  // as in Pair
    };
    int touches = 0;                                     // elements in use of `touch`
    std::array<Touch, collision::max_contacts> touch{};  // the pairs in contact, in their order
    stepping::TimeStepper::Memory steps;  // the last member: it ends with its unused elements
  };
  static std::size_t size_of(const Memory& memory);

  // save() copies this world's memory. recall() takes over the memory that a world of the same kind
  // has saved; call it after set_robot() and set_ball() have set all bodies to their states of that
  // time. From then on both worlds give the same bits.
  void save(Memory& memory) const;
  void recall(const Memory& memory);

  // Everything that changes in a world. Any world that differs from the saved one in nothing but
  // rolling resistance can load it. So a batch of legs needs one world for each thread, and a leg
  // that waits needs its State only.
  struct State {
    double rolling_resistance = 0.0;
    std::array<BodyState, max_bodies> bodies{};
    Memory memory;
  };
  void save(State& to) const;
  void load(const State& from);
  // Makes this world equal to a new one with this rolling resistance.
  void clear(double rolling_resistance);

  // Sets where impacts and counts are recorded from now on; null, the default, records nothing. The
  // statistics must live until others are set or the world is destroyed.
  void set_statistics(RunStatistics* statistics) { statistics_ = statistics; }

  // Plays one tick of `duration` seconds (zero or more) under these commands, one per robot.
  // Returns what happened, valid until the next call. A tick of duration zero only resolves
  // collisions at its time.
  const TickEvents& advance(std::span<const WheelCommand> commands, double duration);

 private:
  // The next time at which a trajectory changes.
  struct Event {
    double time;       // s of the tick
    bool is_touch;     // true: a first contact; false: segments end
    Pair pair;         // the pair that touches
    BodySet involved;  // bodies that touch, or whose segments end
  };
  void start_tick(std::span<const WheelCommand> commands, double duration);
  bool is_at_rest(const BodySet& bodies) const;
  void set_drives(std::span<const WheelCommand> commands);
  Event next_event(double tick_end);
  const collision::CandidatePair* earliest_contact(double& t);
  bool refine_estimate(collision::CandidatePair& n) const;
  void play_event(const Event& event, double tick_end);
  bool was_forced_to_hold(const Event& event) const;
  void resolve_collisions(double t);
  void continue_motion(const BodySet& involved, const BodySet& were_stepping, double t,
                       double tick_end);
  BodySet may_press() const;
  BodySet to_be_stepped(const BodySet& bodies) const;
  BodySet over_budget_or_sticking();
  void take_steps(const BodySet& candidates, double t, double tick_end);
  void begin_step(const stepping::TimeStepper::Step& taken, double t, double tick_end);

  void grow_island(double t, BodySet& involved);
  void update_pairs(const BodySet& involved, double t, double tick_end);
  void start_closed_form(int body, double t, double tick_end);
  void to_series(int body, double t, double tick_end);
  double earliest_contact_of(collision::CandidatePair& n, double t) const;
  BodyState state_at(int body, double t) const;
  Pose pose_of(int body, double t) const;
  void advance_to(double t, const BodySet& involved);
  void collect_contacts(const BodySet& involved, double t);
  void keep_first_contacts_exact();
  void collect_contacts_anywhere();
  void drop_contacts_of(const BodySet& bodies);
  void separate_overlaps();
  void collide(std::span<collision::Contact> contacts, double t);
  void start_segments(const BodySet& involved, double t, double tick_end);

  collision::StaticWorld static_world_;
  // Trajectories, of three kinds. Series: the segment is complete. Closed form: the body is in
  // closed_form_. Step: the body is also in step_islands_. In closed form and in a step, a segment
  // has only its begin and its end.
  std::array<BodyState, max_bodies> bodies_{};  // each at the start of its segment
  std::array<trajectory::Segment, max_bodies> segments_{};
  BodySet closed_form_;                                // bodies without series
  std::array<BodyState, max_bodies> closed_form_end_;  // of bodies in closed form, not in a step
  // The decays last used over a whole tick, and over the rest of a tick.
  struct KnownDecay {
    trajectory::MotorDecay forward, turn;  // `turn` only for motors with two lags
  };
  KnownDecay whole_decay_, rest_decay_;
  stepping::StepIslands step_islands_;
  std::array<trajectory::Box, max_bodies> boxes_{};
  std::array<trajectory::MotionBound, max_bodies> bounds_{};
  std::array<trajectory::DriveReference, max_robots> drives_{};
  std::array<solver::InverseMass, max_bodies> mass_{};
  std::array<solver::InverseMass, max_bodies> free_mass_{};
  impact::RestThresholds thresholds_;
  collision::PairList pairs_;
  TickEvents events_;
  bool bodies_were_set_ = true;  // since the last tick
  RunStatistics* statistics_ = nullptr;

  collision::ContactList contacts_;  // of the event being played; between ticks, of all bodies
  impact::Islands islands_;          // of contacts_: sorted whenever contacts_ changes
  std::unique_ptr<solver::BoxQp> qp_;
  std::unique_ptr<solver::RegularizedQp> regularized_qp_;
  std::unique_ptr<resting_contact::ContactForces> forces_;
  std::unique_ptr<resting_contact::ContactMotion> motion_;
  std::unique_ptr<stepping::TimeStepper> steps_;
};

}  // namespace mirocup::simulator
