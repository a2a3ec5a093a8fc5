// SPDX-License-Identifier: MIT
//
// How the members of a step move between its start and its end: each on the arc of its constant
// twist, plus a mid-step correction.
//
// The impulses of a step leave no overlap at its end (time_stepper.hpp). Inside the step, a body
// that turns while it touches another would still penetrate that body, by an amount of second order
// in the step's length. That amount is measured in the middle of the step and taken away there by a
// displacement, which fades to start and end as a parabola. The overlap that remains is of third
// order. The correction matters because bodies from outside the step may collide with a member at
// any time of the step.
//
// Uses impact/, collision/, solver/, trajectory/ and model/. Units: m, s, rad. Threads: none.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"
#include "core/simulator/solver/regularized_qp.hpp"
#include "core/simulator/trajectory/motion_bound.hpp"
#include "core/simulator/trajectory/segment.hpp"

#include <array>
#include <span>
#include <vector>

namespace mirocup::simulator::stepping {

// Returns the body `span` seconds after the start of a step of `length` seconds. The body follows
// the arc of its twist; `correction` (m, field frame) is its displacement in the middle of the
// step.
BodyState along_corrected_arc(const BodyState& start, const Vec2& correction, double length,
                              double span);

// Returns a motion bound of that trajectory over a step of `length` seconds from time t, in seconds
// of the tick. `end` is the body's position at the end of the step, m.
trajectory::MotionBound bound_of_corrected_arc(const BodyState& start, const Vec2& end,
                                               const Vec2& correction, double t, double length);

// Returns the rest of that trajectory as a segment [begin, end], in seconds of the tick: from the
// body's state `now` at time `begin` to the end of the step, which started at `step_start`.
trajectory::Segment corrected_segment(const BodyState& now, const Vec2& correction,
                                      double step_start, double begin, double end);

// Checks and corrects the trajectories inside one step. Keeps each body's correction until the next
// attempt at a step with that body.
class StepTrajectories {
 public:
  // World and problem outlive this object. is_clear() and correct_middle() use the problem as
  // scratch: they reset it.
  StepTrajectories(const collision::StaticWorld& world, solver::RegularizedQp& problem);

  // A step to be checked. The members' states at both ends carry the twist of the step. The
  // contacts are those at the end, with their impulses; the contacts of a pair follow each other.
  struct Step {
    BodySet members;
    std::span<const BodyState> start, end;
    std::span<const collision::Contact> contacts;
    double length;  // s
  };

  // Sets the corrections of the members to zero. To be called before each attempt at a step.
  void clear_corrections(const BodySet& members);

  // True if no pair tunnels during the step: if a pair starts apart, neither body may pass through
  // an edge of the other. Pairs that touch or nearly touch at the start are left to
  // correct_middle(), which is called next.
  bool is_clear(const Step& step);

  // Sets the corrections of the members so that no pair that presses, or nearly touched at the
  // start, overlaps in the middle of the step. All of them stay zero if the deepest overlap is
  // negligible or would take too large a correction. Returns the deepest overlap that remains
  // inside the step, m. Call after is_clear().
  double correct_middle(const Step& step);

  // Returns the deepest overlap at the start of the step, m. Call after correct_middle().
  double overlap_at_start(const Step& step) { return overlap_at(step, 0.0); }

  // Returns a length (s) for the next step of these bodies with which the overlap inside that step
  // should stay below Tolerances::intermediate_penetration. `overlap` is what correct_middle()
  // returned for this step.
  double next_length(const Step& step, double overlap) const;

  // Returns a body's displacement in the middle of its latest step (m, field frame).
  const Vec2& correction_of(int member) const { return correction_[member]; }

 private:
  bool tunnels(const Step& step, const Pair& pair);
  double overlap_at(const Step& step, double share);
  double sampled_gap(const collision::Contact& contact) const;
  double project_middle(const Step& step);

  const collision::StaticWorld& world_;
  solver::RegularizedQp& qp_;
  // Robots and ball as bodies that do not turn: corrections are translations.
  std::array<solver::InverseMass, max_bodies> translation_mass_;
  bool is_corrected_ = false;        // the latest step has corrections
  double largest_correction_ = 0.0;  // m: asked for in the latest step, whether applied or not
  std::array<Vec2, max_bodies> correction_;
  std::array<BodyState, max_bodies> sampled_;  // the members at the sampled time of the step
  // Contacts of pairs that may overlap inside the step.
  std::array<const collision::Contact*, solver::max_unknowns> near_contacts_;
  int near_contact_count_ = 0;
  std::vector<trajectory::Segment> arcs_;  // of the pair that is tested for tunnelling
};

}  // namespace mirocup::simulator::stepping
