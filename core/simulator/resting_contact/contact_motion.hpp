// SPDX-License-Identifier: MIT
//
// How bodies move while they press on each other: exactly, as one power series for the whole
// cluster.
//
// As long as the same contacts press and the same wheels hold (see contact_forces.hpp), the gaps of
// those contacts stay zero. That makes each term of the motion a linear system for the same term of
// the forces, whose matrix is that of the first term. The segment ends where a force would pull, a
// wheel's grip is used up, a slide ends, a ball stops or starts, or a corner leaves its edge.
#pragma once

#include "core/simulator/resting_contact/contact_forces.hpp"
#include "core/simulator/solver/pivoted_cholesky.hpp"

#include <array>
#include <span>
#include <vector>

namespace mirocup::simulator::resting_contact {

// How long a curve is wanted, s.
struct SegmentRequest {
  double begin;               // of the tick
  double horizon;             // of the tick; at most until then
  double preferred_duration;  // a curve that holds for so long needs no more terms
  double min_duration;        // so long no contact lets go and no wheels begin to slide
};

class ContactMotion {
 public:
  // Allocates its scratch; moving does not allocate. The arena outlives it.
  explicit ContactMotion(const collision::StaticWorld& world);

  // Moves a cluster of bodies that hold each other: sets the segments of its bodies, all with the
  // same end. What their gaps and velocities are off by rounding is put right first. Sets `is_kept`
  // of the cluster's contacts.
  void move(const BodySet& cluster, const ContactForces& forces,
            std::span<collision::Contact> contacts,
            std::span<const trajectory::DriveReference> drives, const SegmentRequest& request,
            std::span<BodyState> bodies, std::span<trajectory::Segment> segments);

 private:
  // The equations of a cluster: first the contacts that press, then the wheels that hold sideways.
  int equations() const { return held_count_ + wheel_count_; }
  int wheel_state(int equation) const { return wheels_[equation - held_count_]; }
  // What the ground gives wheels sideways at most, N.
  double max_grip() const {
    return trajectory::lateral_acceleration_limit(world_.parameters) * world_.parameters.robot_mass;
  }

  void set_members(const BodySet& cluster, const ContactForces& forces);
  void select_active(std::span<const collision::Contact> contacts);
  bool arrest_marginal_slip(const SegmentRequest& request,
                            std::span<const collision::Contact> contacts,
                            std::span<const trajectory::Segment> segments);
  void extend_until_converged(const SegmentRequest& request,
                              std::span<trajectory::Segment> segments);
  void mark_persistent(std::span<collision::Contact> contacts) const;
  void start_series(const SegmentRequest& request, std::span<BodyState> bodies,
                    std::span<trajectory::Segment> segments);
  void close_gaps(std::span<BodyState> bodies);
  void project_velocities(std::span<BodyState> bodies);
  void factorise();
  void extend(int k, std::span<trajectory::Segment> segments);
  void extend_twists(int k, std::span<trajectory::Segment> segments);
  void solve_for_forces(int k, std::span<trajectory::Segment> segments);
  void add_force(int i, int k, std::span<trajectory::Segment> segments) const;
  void add_to_twists(const solver::ConstraintRow& row, double amount, int term,
                     std::span<trajectory::Segment> segments) const;
  bool is_at_rest(std::span<const trajectory::Segment> segments) const;
  void set_terms_of_all(int terms, std::span<trajectory::Segment> segments);
  double converged_length_of_all(std::span<const trajectory::Segment> segments) const;
  void find_end(const SegmentRequest& request, std::span<trajectory::Segment> segments) const;
  double time_of_release(double min_duration, double length) const;
  double time_of_slip(double min_duration, double length) const;

  const collision::StaticWorld& world_;
  double slip_threshold_ = 0.0;
  std::span<const trajectory::DriveReference> drives_;

  std::array<int, max_bodies> members_;
  int member_count_ = 0;
  std::array<solver::InverseMass, max_bodies> mass_;
  std::array<trajectory::Braking, max_bodies> braking_;
  std::array<double, max_bodies> slip_sign_;
  std::array<Grounding, max_bodies> grounding_;

  std::array<collision::Contact, solver::max_unknowns> held_;
  std::array<int, solver::max_unknowns> held_index_;  // of held_, among all contacts
  int held_count_ = 0;
  std::vector<ContactSeries> rows_;  // of held_
  std::array<int, max_bodies> wheels_;
  int wheel_count_ = 0;
  std::array<trajectory::Series, max_bodies> lateral_force_;  // N to the left, of wheels_

  solver::PivotedCholesky
      cholesky_;  // where equations follow from others, their forces stay as they are
  std::array<double, solver::max_unknowns> rhs_;
};

}  // namespace mirocup::simulator::resting_contact
