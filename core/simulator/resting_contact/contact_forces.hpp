// SPDX-License-Identifier: MIT
//
// At one instant: who presses on whom, which wheels hold and which slide.
//
// Bodies touch and their gaps neither close nor open. Whether they go on together is one convex
// problem in the accelerations, 0 <= force, 0 <= acceleration of the gap, one of them zero, for all
// contacts of all bodies together with the ground's sideways force on wheels, which holds them up
// to grip M g. A ball at rest feels no rolling resistance until it is pushed harder than that.
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

// What the ground does to a body in contact.
enum class Ground { rolls, slides, lifted, ball };

struct Grounding {
  Ground ground = Ground::rolls;
  double slip_sign = 0.0;      // +1: slides to the left, -1: to the right
  double lateral_force = 0.0;  // N to the left, of wheels of finite grip that roll
  Vec2 push{0.0, 0.0};         // N, on a ball that starts from rest against its rolling resistance
};

// Does the ground hold the body sideways by a force of its own?
inline bool is_held_sideways(const collision::StaticWorld& world, const Grounding& grounding) {
  return grounding.ground == Ground::rolls && world.parameters.grip != infinite_grip;
}

class ContactForces {
 public:
  explicit ContactForces(const collision::StaticWorld& world);

  // Sets `holds` and `force` of every contact, and the grounding of every body that has one. Gaps
  // that open faster than the contact's rest speed are left alone. WheelState that slide no faster than
  // `slip_threshold`, and a ball that rolls no faster than `roll_threshold` (m/s), are made to stop that.
  // Velocities are made to fit what was decided.
  void decide(std::span<const trajectory::DriveReference> drives, double slip_threshold,
              double roll_threshold, std::span<BodyState> bodies,
              std::span<collision::Contact> contacts);

  const Grounding& grounding(int body) const { return grounding_[body]; }
  double slip_threshold() const { return slip_threshold_; }

  // What forces change of the body's velocities; the wheels' sideways hold counts as a force unless
  // it is infinite.
  const solver::InverseMass& mass(int body,
                                  std::span<const trajectory::DriveReference> drives) const;

 private:
  void classify_ground(std::span<const trajectory::DriveReference> drives,
                       std::span<BodyState> bodies);
  void build_problem(std::span<const trajectory::DriveReference> drives,
                     std::span<const BodyState> bodies,
                     std::span<const collision::Contact> contacts);
  void start_ball(std::span<const trajectory::DriveReference> drives,
                  std::span<const BodyState> bodies, std::span<const collision::Contact> contacts);
  Vec2 push_on_ball(std::span<const collision::Contact> contacts) const;
  void drop_weak_forces();
  void read_solution(std::span<collision::Contact> contacts);
  void project_velocities(std::span<const trajectory::DriveReference> drives,
                          std::span<BodyState> bodies,
                          std::span<const collision::Contact> contacts);

  const collision::StaticWorld& world_;
  solver::BoxQp qp_;
  double slip_threshold_ = 0.0;
  double roll_threshold_ = 0.0;
  std::array<Grounding, max_bodies> grounding_;
  std::array<trajectory::Segment, max_bodies>
      trial_;  // two terms of the motion without contact forces
  std::vector<ContactSeries> rows_;
  std::vector<solver::ConstraintRow>
      constraints_;  // on the velocities: contacts, then wheels that hold
  std::array<solver::ConstraintRow, max_robots> wheel_rows_;  // of each robot
  std::array<int, solver::max_unknowns> candidate_;           // contacts whose gaps do not open
  int candidate_count_ = 0;
  std::array<int, max_bodies> member_;  // bodies with a candidate
  std::array<int, max_bodies> wheels_;  // robots whose wheels may hold
  int member_count_ = 0;
  int wheel_count_ = 0;
};

}  // namespace mirocup::simulator::resting_contact
