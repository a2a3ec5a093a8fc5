// SPDX-License-Identifier: MIT
//
// The forces of resting contacts at one instant: a mixed LCP.
//
// Bodies touch, and their gaps neither close nor open. Which contacts press, and which wheels
// hold or slide, is one convex problem in accelerations (Baraff 1994): 0 <= force, 0 <=
// acceleration of the gap, and one of the two is zero. The problem holds all contacts of an
// island and the ground's lateral force on wheels, which is at most grip M g. A ball at rest
// stays at rest until it is pushed harder than its rolling resistance.
//
// Contacts with friction (an option) slide: their tangential forces are the coefficient times the
// normal forces, against the slide. The problem is solved again with them until normal and
// tangential forces agree.
//
// Uses impact/, collision/, solver/, trajectory/ and model/. Units: m, s, rad, N. Threads: none.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"
#include "core/simulator/resting_contact/contact_series.hpp"
#include "core/simulator/solver/box_qp.hpp"
#include "core/simulator/trajectory/differential_drive.hpp"
#include "core/simulator/trajectory/rolling_ball.hpp"

#include <array>
#include <span>
#include <vector>

namespace mirocup::simulator::resting_contact {

// What the ground does to a body in contact: wheels that roll, wheels that slide, wheels off the
// ground, and the ball.
enum class Ground { rolls, slides, lifted, ball };

struct Grounding {
  Ground ground = Ground::rolls;
  double slip_sign = 0.0;      // +1: slides to the left, -1: to the right
  double lateral_force = 0.0;  // N to the left, of wheels of finite grip that roll
  Vec2 push{0.0, 0.0};         // N, on a ball that starts from rest against its rolling resistance
};

// True if the ground holds the body laterally by a finite force: wheels that roll, of finite grip.
inline bool is_held_sideways(const collision::StaticWorld& world, const Grounding& grounding) {
  return grounding.ground == Ground::rolls && world.parameters.grip != infinite_grip;
}

// Decides which contacts press. Kept and reused: construction allocates, decide() does not.
class ContactForces {
 public:
  // The world outlives this object.
  explicit ContactForces(const collision::StaticWorld& world);

  // Decides for the contacts of one island. Sets each Contact::resting, and grounding() of each
  // body with a contact whose gap does not open. Changes the velocities of these bodies so that
  // they fit the decision; the change never adds energy.
  //
  // A gap counts as opening if it opens faster than the contact's restitution threshold. Sliding
  // wheels and a rolling ball that move no faster than Tolerances::slow_motion are stopped first.
  // `drives` has one entry per robot, `bodies` one per body.
  //
  // Returns false if the friction of a pressing contact has no constant direction: the contact does
  // not slide, or it is a contact of the ball. Then there is no decision for the island, and its
  // bodies need time steps.
  bool decide(std::span<const trajectory::DriveReference> drives, std::span<BodyState> bodies,
              std::span<collision::Contact> contacts);

  // Returns what the ground does to a body by the latest decision for its island.
  const Grounding& grounding(int body) const { return grounding_[body]; }

  // Returns the inverse masses by which forces accelerate a body. Wheels of infinite grip make the
  // sideways one zero; wheels of finite grip hold by a force.
  const solver::InverseMass& mass(int body,
                                  std::span<const trajectory::DriveReference> drives) const;

 private:
  // A constraint on velocities: the rate of the row is zero (is_equality) or at least zero.
  struct VelocityConstraint {
    const solver::ConstraintRow* row;
    bool is_equality;
  };

  void classify_ground(std::span<const trajectory::DriveReference> drives,
                       std::span<BodyState> bodies);
  void build_problem(std::span<const trajectory::DriveReference> drives,
                     std::span<const BodyState> bodies,
                     std::span<const collision::Contact> contacts);
  void start_ball(std::span<const trajectory::DriveReference> drives,
                  std::span<const BodyState> bodies, std::span<const collision::Contact> contacts);
  Vec2 push_on_ball(std::span<const collision::Contact> contacts) const;
  bool add_friction(std::span<const BodyState> bodies, std::span<collision::Contact> contacts);
  bool find_friction(const solver::Unknowns& without, std::span<const collision::Contact> contacts);
  std::array<BodyState, max_bodies> pushed_by_forces(std::span<const collision::Contact> contacts,
                                                     bool by_all) const;
  void drop_weak_forces();
  void read_solution(std::span<collision::Contact> contacts);
  void project_velocities(std::span<BodyState> bodies,
                          std::span<const collision::Contact> contacts);
  bool are_admissible(std::span<const BodyState> bodies) const;

  const collision::StaticWorld& world_;
  solver::BoxQp qp_;
  std::array<Grounding, max_bodies> grounding_;

  // The decision that is being made: valid during decide() only.
  std::array<solver::InverseMass, max_bodies> mass_;   // of the bodies with a contact
  std::array<trajectory::Segment, max_bodies> trial_;  // two terms of the motion without forces
  std::vector<ContactSeries> rows_;                    // of the candidates
  std::vector<VelocityConstraint> constraints_;        // contacts, then wheels that hold
  std::array<solver::ConstraintRow, max_robots> wheel_rows_;  // of each robot; never change
  std::array<int, solver::max_unknowns> candidate_;  // indices of contacts whose gaps do not open
  BodySet members_;                                  // bodies with a candidate
  std::array<int, max_bodies> wheels_;               // robots whose wheels may hold
  std::array<solver::ConstraintRow, collision::max_contacts> tangents_;  // of the candidates
  int candidate_count_ = 0;
  int wheel_count_ = 0;
};

}  // namespace mirocup::simulator::resting_contact
