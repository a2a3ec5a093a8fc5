// SPDX-License-Identifier: MIT
//
// How those who take a small step together move between its ends: each along the arc of the twist that
// it keeps, and a little beside it. Who touches at both ends and turns would overlap between them, by
// what grows with the step's square; that is taken away from the middle and, as a parabola, from the
// rest. What stays grows with its cube. Anybody may run into them half way.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"
#include "core/simulator/solver/regularized_qp.hpp"
#include "core/simulator/trajectory/motion_bound.hpp"
#include "core/simulator/trajectory/segment.hpp"

#include <array>
#include <span>
#include <vector>

namespace mirocup::simulator::stepping {

// A step of `length` seconds along an arc, in the middle of which the body is `bend` (m, in the field's
// frame) beside it: where it is `span` seconds after the begin.
BodyState along_corrected_arc(const BodyState& begin, const Vec2& correction, double length,
                              double span);

// The way that such a step of `length` seconds takes from its begin, at time t, to where it ends.
trajectory::MotionBound bound_of_corrected_arc(const BodyState& begin, const Vec2& end,
                                               const Vec2& correction, double t, double length);

// The rest of such a step, which began at `step_begin`, s of the tick, from where the body is now.
trajectory::Segment corrected_segment(const BodyState& now, const Vec2& correction,
                                      double step_begin, double begin, double end);

class StepTrajectories {
 public:
  // Both outlive it. Looking at a step resets the problem.
  StepTrajectories(const collision::StaticWorld& world, solver::RegularizedQp& problem);

  // What a step is judged by: its members, each at the begin with the twist of the step, its contacts
  // at the end with their impulses.
  struct Step {
    BodySet members;
    std::span<const BodyState> begin, end;
    std::span<const collision::Contact> contacts;
    double length;  // s
  };

  // Does nobody pass through anybody on the way to an end where they are apart, or touch from another
  // side? Only what opens at the end, and by that was behind the edge at the begin, is looked at; and not
  // who nearly touches at the begin, or presses: that is for bend(), which comes next.
  bool is_clear(const Step& step);
  // None of them is beside an arc, until bend() says so: for the begin of each attempt at a step.
  void clear_corrections(const BodySet& members);
  // Bends the arcs of the members where those who press or touched would overlap. Returns how deep two
  // of them still do, m.
  double correct_middle(const Step& step);
  // How deep two of them did when the step began, m.
  double overlap_at_begin(const Step& step) { return overlap_at(step, 0.0); }
  // How long the next such step may be, s, to overlap by a little less than is allowed.
  double next_length(const Step& step, double overlap) const;

  // Of a body's last step; stays until the next attempt at one with that body.
  const Vec2& correction_of(int member) const { return correction_[member]; }

 private:
  bool tunnels(const Step& step, const Pair& pair);
  double overlap_at(const Step& step, double part);
  double sampled_gap(const collision::Contact& contact) const;
  double project_middle(const Step& step);

  const collision::StaticWorld& world_;
  solver::RegularizedQp& qp_;
  std::array<solver::InverseMass, max_bodies> translation_mass_;  // bodies that do not turn
  bool is_corrected_ = false;
  double largest_correction_ =
      0.0;  // m: how far the last bend() wanted to take somebody beside an arc
  std::array<Vec2, max_bodies> correction_;    // m, of each member
  std::array<BodyState, max_bodies> sampled_;  // at the part of the step that is looked at
  std::array<const collision::Contact*, solver::max_unknowns>
      near_contacts_;  // contacts of pairs that may overlap there
  int near_contact_count_ = 0;
  std::vector<trajectory::Segment> arcs_;  // of two that may pass through each other
};

}  // namespace mirocup::simulator::stepping
