// SPDX-License-Identifier: MIT
//
// Lasting contact by small steps: bodies that press on each other where following every event would
// take too long, and wherever bodies rub.
//
// Within a step every body keeps its twist. All impulses of the step, of contacts and of the ground
// on wheels, are one convex problem: contacts only push, wheels hold sideways up to their grip, and
// no gap may be closed further than to zero at the step's end. Which contacts there are, and along
// which normals, is seen where the bodies would be if they kept their twists. The problem is solved
// again with the gaps that are found where they come instead, until every contact that pushes touches
// and none overlaps: so overlaps do not build up and are never pushed out afterwards. How they move
// between the ends of a step is for step_paths.hpp, and may ask for a shorter one. First order in the
// step. What meets in a step does not bounce.
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
  // Both outlive it.
  TimeStepper(const collision::StaticWorld& world, solver::RegularizedQp& problem);

  // Who steps together, and for how long, s; nobody, if no contact lasts.
  struct Step {
    BodySet members;
    double length = 0.0;
  };

  // Of the candidates, the first that touches another or may before the step ends, and all that are so
  // connected with it. Sets the twists of the members to what they keep during the step, which is no
  // longer than `longest`, s.
  Step take_step(const BodySet& candidates, std::span<const collision::Contact> touching,
                 std::span<const trajectory::DriveReference> drives,
                 std::span<const solver::InverseMass> mass, double longest,
                 std::span<BodyState> bodies);

  // How far a body is beside its arc in the middle of the step that it takes, m.
  const Vec2& correction(int member) const { return trajectories_.correction_of(member); }
  // A body keeps one twist for a whole step, with all that the step's forces give it. From that one,
  // what it would be after that part of the step if they gave it bit by bit: for who is interrupted.
  Twist twist_after(int member, const Twist& kept, double part) const;
  // Of the last step, if it had members: a member at its end, and the contacts that press.
  const BodyState& end(int member) const { return end_[member]; }
  std::span<const collision::Contact> pressing() const { return contacts_.contacts(); }

  // Who was in no step of the last tick may take a long one again.
  void begin_tick();
  // The next step begins from nothing: bodies were moved.
  void forget_forces();

 private:
  // A contact that pressed in a step: the next one begins with its force, but with no more than it gave
  // then. Of a short one that stopped something, the force says nothing about a longer one.
  struct RememberedForce {
    Pair pair;
    collision::ContactPoint point;
    double force;    // N
    double impulse;  // N s
  };

  double max_point_speed(const BodySet& some, std::span<const BodyState> bodies) const;
  double max_step_length(const BodySet& some, std::span<const BodyState> bodies) const;
  double proposed_length(const BodySet& some) const;
  double motor_reach(const BodySet& candidates, double length,
                     std::span<const BodyState> bodies) const;
  bool attempt(const BodySet& candidates, std::span<const collision::Contact> touching,
               std::span<const trajectory::DriveReference> drives,
               std::span<const solver::InverseMass> mass, double length,
               std::span<const BodyState> bodies, Step& step);
  void predict_contacts(const BodySet& candidates, std::span<const collision::Contact> touching,
                        double length, std::span<const BodyState> bodies);
  bool solve_until_settled(const BodySet& members,
                           std::span<const trajectory::DriveReference> drives,
                           std::span<const solver::InverseMass> mass, double length,
                           std::span<const BodyState> bodies);
  void build_problem(const BodySet& members, std::span<const trajectory::DriveReference> drives,
                     std::span<const solver::InverseMass> mass, double length);
  void solve_impulses(const BodySet& members, std::span<const solver::InverseMass> mass,
                      double length);
  void set_bounds(int i, double bound);
  double max_grip(double length) const;  // N s
  void allow_initial_overlaps(double length, std::span<const BodyState> bodies);
  bool has_settled(double touch) const;
  bool check_trajectories(const BodySet& members, double length);
  void warm_start(const BodySet& members, double length);
  void remember_forces(const Step& step);

  const collision::StaticWorld& world_;
  solver::RegularizedQp& qp_;
  collision::ContactList contacts_;
  std::array<solver::ConstraintRow, solver::max_unknowns>
      tangent_rows_;                  // of contacts with friction
  solver::Unknowns tangent_impulse_;  // N s, of those
  int tangent_count_ = 0;
  std::array<double, solver::max_unknowns>
      allowed_overlap_;  // m, of each contact's overlap at the begin, that stays
  std::array<solver::ConstraintRow, max_robots> wheel_rows_;
  std::array<double, max_robots> wheel_force_;      // N, of each robot in its last step
  std::array<double, max_robots> wheel_impulse_{};  // N s, of each robot in this step
  std::array<RememberedForce, solver::max_unknowns> remembered_;  // of each body in its last step
  int remembered_count_ = 0;
  BodySet stepped_;           // in this tick
  double next_length_ = 0.0;  // s, by what the last attempt at a step was like
  std::array<double, max_bodies>
      proposed_length_of_;  // s, of each body, by what its last one was like
  // Of each unknown, contacts first, then tangents, then wheels: its row and its impulse, N s.
  std::array<const solver::ConstraintRow*, solver::max_unknowns> row_;
  std::array<double*, solver::max_unknowns> impulse_;
  std::array<BodyState, max_bodies> start_;          // with the twists of the step
  std::array<Twist, max_bodies> twist_before_;       // of each body, before its last step
  std::array<BodyState, max_bodies> end_;            // with the twists of the step
  std::array<BodyState, max_bodies> unconstrained_;  // twists at the end if there were no contacts
  solver::Unknowns unconstrained_rate_;              // m/s, of each unknown: its rate then
  std::array<trajectory::Box, max_bodies> boxes_;
  StepTrajectories trajectories_;
};

}  // namespace mirocup::simulator::stepping
