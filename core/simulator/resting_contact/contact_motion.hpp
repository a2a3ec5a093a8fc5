// SPDX-License-Identifier: MIT
//
// How a contact cluster moves: exactly, as one power series for all its bodies.
//
// A contact cluster is a set of bodies that keep each other's contacts closed. As long as the
// same contacts press and the same wheels hold (contact_forces.hpp), the gaps of these contacts
// stay zero: an index-1 reduction of a differential-algebraic equation, solved term by term. Term
// k of all forces is the solution of one linear system, whose matrix J M^-1 J' is the same for
// every k. Friction of contacts that slide is added in rounds. The segment ends where a force would
// pull, a grip is used up, a slide ends, a ball stops or starts, or a corner leaves its edge.
//
// Uses impact/, collision/, solver/, trajectory/ and model/. Units: m, s, rad, N. Threads: none.
#pragma once

#include "core/simulator/resting_contact/contact_forces.hpp"
#include "core/simulator/solver/pivoted_cholesky.hpp"

#include <array>
#include <span>
#include <vector>

namespace mirocup::simulator::resting_contact {

// The time over which a segment is wanted.
struct SegmentRequest {
  double begin;               // s of the tick
  double horizon;             // s of the tick: the segment ends there at the latest
  double preferred_duration;  // s: a series that holds for this time needs no more terms
  double min_duration;        // s after `begin`: no contact opens and no wheels slide earlier
};

// Computes the segments of clusters. Kept and reused: construction allocates, move() does not.
class ContactMotion {
 public:
  // The world outlives this object.
  explicit ContactMotion(const collision::StaticWorld& world);

  // Sets the segments of the cluster's bodies, all with the same end. First moves the bodies, by
  // less than a nanometre, so that pressing gaps are zero, and changes their velocities so that the
  // rates of these gaps are zero as well. `forces` has decided the cluster's contacts
  // (Contact::resting) and the grounding of its bodies. Sets is_persistent of its pressing
  // contacts.
  void move(const BodySet& cluster, const ContactForces& forces,
            std::span<collision::Contact> contacts,
            std::span<const trajectory::DriveReference> drives, const SegmentRequest& request,
            std::span<BodyState> bodies, std::span<trajectory::Segment> segments);

 private:
  // The equations of a cluster: first the contacts that press, then the wheels that hold sideways.
  int equations() const { return held_count_ + wheel_count_; }
  int wheel_state(int equation) const { return wheels_[equation - held_count_]; }
  std::span<const int> members() const {
    return {members_.data(), static_cast<std::size_t>(member_count_)};
  }
  // Returns the largest lateral force of the ground on a robot's wheels, N.
  double max_grip() const {
    return trajectory::lateral_acceleration_limit(world_.parameters) * world_.parameters.robot_mass;
  }

  void set_members(const BodySet& cluster, const ContactForces& forces);
  void select_active(std::span<const collision::Contact> contacts);
  template <class IsMarginal>
  bool arrest_slip(std::span<const collision::Contact> contacts,
                   std::span<const trajectory::Segment> segments, IsMarginal is_marginal);
  bool arrest_reversed_slip(std::span<const collision::Contact> contacts,
                            std::span<const trajectory::Segment> segments);
  bool arrest_brief_slip(const SegmentRequest& request,
                         std::span<const collision::Contact> contacts,
                         std::span<const trajectory::Segment> segments);
  void stand_still(const SegmentRequest& request, std::span<const BodyState> bodies,
                   std::span<trajectory::Segment> segments) const;
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
  void apply_redundant_forces(std::span<trajectory::Segment> segments);
  void add_force(int i, int k, double force, std::span<trajectory::Segment> segments) const;
  void add_to_twist(int body, const solver::JacobianRow& row, double amount, int term,
                    std::span<trajectory::Segment> segments) const;
  bool is_at_rest(std::span<const trajectory::Segment> segments) const;
  void set_terms_of_all(int terms, std::span<trajectory::Segment> segments);
  double converged_length_of_all(std::span<const trajectory::Segment> segments) const;
  // `time`, s after the segment's begin, is when a body's motion ends the segment. `settles` is
  // true if the body then comes to rest exactly.
  struct OwnEnd {
    double time;
    bool settles;
  };
  void find_end(const SegmentRequest& request, std::span<trajectory::Segment> segments) const;
  OwnEnd own_end(int body, const trajectory::Segment& segment, double length,
                 double min_duration) const;
  double time_of_release(double min_duration, double length) const;
  double time_of_slip(double min_duration, double length) const;
  double time_of_stick(double length) const;

  const collision::StaticWorld& world_;

  // The cluster that is being moved: everything below is valid during move() only.
  std::span<const trajectory::DriveReference> drives_;

  std::array<int, max_bodies> members_;  // bodies of the cluster
  int member_count_ = 0;
  // By body:
  std::array<solver::InverseMass, max_bodies> mass_;
  std::array<trajectory::Braking, max_bodies> braking_;
  std::array<double, max_bodies> slip_sign_;
  std::array<Grounding, max_bodies> grounding_;

  std::array<collision::Contact, solver::max_unknowns> held_;  // contacts that press
  std::array<int, solver::max_unknowns> held_index_;           // of held_, among all contacts
  int held_count_ = 0;
  bool have_friction_ = false;          // true if some of held_ have friction
  std::vector<ContactSeries> rows_;     // of held_
  std::array<int, max_bodies> wheels_;  // robots whose wheels hold
  int wheel_count_ = 0;
  std::array<trajectory::Series, max_bodies> lateral_force_;  // N to the left, of wheels_

  solver::PivotedCholesky cholesky_;  // forces of redundant equations stay as they were decided
  std::array<double, solver::max_unknowns> rhs_;
};

}  // namespace mirocup::simulator::resting_contact
