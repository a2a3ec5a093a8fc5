// SPDX-License-Identifier: MIT
//
// Time stepping with impulses: how bodies in lasting contact move when following every event
// would take too long, and wherever contacts have friction.
//
// The scheme is that of Stewart and Trinkle (1996) and of Anitescu and Potra (1997). Within a
// step every body keeps its twist. All impulses of the step, of contacts and of the ground on
// wheels, are one convex problem in velocities: contacts only push, wheels hold laterally up to
// their grip, and no gap may be below zero at the end of the step. The contacts and their normals
// are found where the bodies would be if they kept their twists. A fixed-point iteration then
// replaces the predicted gaps by those that are measured at the end of the step, until every
// pressing contact touches and none overlaps (Tolerances::step_gap). So overlaps cannot accumulate,
// and no later correction is needed. The method is of first order in the step's length, and
// contacts within a step do not bounce.
//
// step_trajectories.hpp treats the motion inside a step and may demand a shorter step. The
// regularised QP starts from the forces of the last step (warm start).
//
// Uses impact/, collision/, solver/, trajectory/ and model/. Units: m, s, rad, N. Threads: none;
// the object belongs to one world.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"
#include "core/simulator/impact/friction.hpp"
#include "core/simulator/solver/regularized_qp.hpp"
#include "core/simulator/stepping/step_trajectories.hpp"
#include "core/simulator/trajectory/differential_drive.hpp"

#include <array>
#include <span>

namespace mirocup::simulator::stepping {

class TimeStepper {
 public:
  // World and problem outlive this object; every step resets the problem. Nothing allocates after
  // construction.
  TimeStepper(const collision::StaticWorld& world, solver::RegularizedQp& problem);

  // A step that was taken. If no candidate has a lasting contact, there are no members, and no step
  // was taken.
  struct Step {
    BodySet members;
    double length = 0.0;  // s
  };

  // Takes one step of one island: the first candidate that touches another body or obstacle, or
  // may touch one before the step ends, and all candidates connected with it by such contacts.
  // Sets the members' twists to those that they keep during the step; poses stay. Returns the
  // members and the length of the step, which is at most `longest` (s, positive) and divides it
  // evenly.
  //
  // `touching` are the contacts now; `drives` has one entry per robot, `mass` and `bodies` one
  // per body. At least one candidate.
  Step take_step(const BodySet& candidates, std::span<const collision::Contact> touching,
                 std::span<const trajectory::DriveReference> drives,
                 std::span<const solver::InverseMass> mass, double longest,
                 std::span<BodyState> bodies);

  // Returns a body's displacement from its arc in the middle of its latest step (m, field frame).
  const Vec2& correction(int member) const { return trajectories_.correction_of(member); }

  // Returns the twist of a member whose step is interrupted after this share (0 to 1) of it. `kept`
  // is its twist during the step, which contains all impulses of the step; the result contains
  // their share.
  Twist twist_after(int member, const Twist& kept, double share) const;

  // Returns a member of the latest step at its end. Valid until the next call of take_step().
  const BodyState& end(int member) const { return end_[member]; }
  // Returns the pressing contacts of the latest step. Valid until the next call of take_step().
  std::span<const collision::Contact> pressing() const { return contacts_.contacts(); }

  // Starts a tick: the first step of a body that took no step in the last tick may be long again.
  void begin_tick();
  // Makes the next steps start from zero forces: after bodies were set, old forces mean nothing.
  void forget_forces();

  // A pressing contact of an earlier step, from which the next step starts warm. The warm start is
  // limited to `impulse`. Without this limit, a short step that stops a body with a large force
  // would hand this force on to a longer step. `kind`, `corner` and `edge` are those of its contact
  // point.
  struct RememberedForce {
    Pair pair;
    collision::Touching kind;
    bool point_on_a;
    int corner, edge;
    double force;    // N
    double impulse;  // N s
  };

  // Data that steps leave to later steps of this tick and of the next.
  struct Memory {
    BodySet stepped;                                   // bodies that took a step in this tick
    std::array<double, max_robots> wheel_force{};      // N, lateral, of each robot's latest step
    std::array<double, max_bodies> proposed_length{};  // s, of each body's next step
    int forces = 0;                                    // elements in use of `force`
    std::array<RememberedForce, solver::max_unknowns> force;  // of each body's latest step
  };
  // Both copy only the forces in use: other elements of the target's array keep their values.
  void save(Memory& memory) const { copy(memory_, memory); }
  void recall(const Memory& memory) { copy(memory, memory_); }

 private:
  // One attempt at a step: its input, and what the attempt found.
  struct Attempt {
    BodySet candidates;
    std::span<const collision::Contact> touching;
    std::span<const trajectory::DriveReference> drives;
    std::span<const solver::InverseMass> mass;
    std::span<const BodyState> start;
    double length = 0.0;  // s

    BodySet members{};
    double next_length = 0.0;  // s: proposed length of the members' next step
  };

  static void copy(const Memory& from, Memory& to);

  // Unknowns of the QP from `begin` to before `end`.
  struct UnknownRange {
    int begin = 0;
    int end = 0;
  };

  bool attempt(Attempt& step);
  void propose_next(const Attempt& step, double longest, double wanted);
  double max_step_length(const BodySet& some, std::span<const BodyState> bodies) const;
  double proposed_length(const BodySet& some) const;

  void set_unconstrained_twists(const Attempt& step);
  double motor_reach(const Attempt& step) const;
  void predict_contacts(const Attempt& step);

  bool solve_until_settled(Attempt& step);
  void allow_initial_overlaps(const Attempt& step);
  bool has_settled(double tolerance) const;
  bool check_trajectories(Attempt& step);

  void build_problem(const Attempt& step);
  void solve_impulses(const Attempt& step);
  void solve_with_friction();
  void set_bounds(int i, double bound);
  double max_grip(double length) const;

  void warm_start(const Attempt& step);
  void remember_forces(const Attempt& step);

  const collision::StaticWorld& world_;
  solver::RegularizedQp& qp_;
  StepTrajectories trajectories_;

  Memory memory_;
  std::array<Twist, max_bodies> twist_before_;  // of each body, before its latest step

  // The attempt that is being made.
  collision::ContactList contacts_;
  std::array<BodyState, max_bodies> start_;          // members, with the twists of the step
  std::array<BodyState, max_bodies> end_;            // candidates, with the twists of the step
  std::array<BodyState, max_bodies> unconstrained_;  // twists after a step without contacts
  std::array<double, solver::max_unknowns> allowed_overlap_;  // m, of each contact at the end
  std::array<trajectory::Box, max_bodies> boxes_;

  // The attempt's QP: for each unknown the row, impulse (N s) and rate (m/s) without impulses.
  UnknownRange normals_, tangents_, wheels_;
  std::array<const solver::ConstraintRow*, solver::max_unknowns> row_;
  std::array<double*, solver::max_unknowns> impulse_;
  solver::Unknowns unconstrained_rate_;
  std::array<solver::ConstraintRow, solver::max_unknowns> tangent_rows_;
  solver::Unknowns tangent_impulse_;                          // N s
  std::array<int, solver::max_unknowns> normal_of_tangent_;   // index of the normal's unknown
  std::array<solver::ConstraintRow, max_robots> wheel_rows_;  // of each robot
  std::array<double, max_robots> wheel_impulse_{};            // N s, of each robot
};

}  // namespace mirocup::simulator::stepping
