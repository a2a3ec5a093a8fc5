// SPDX-License-Identifier: MIT
//
// Segments: the smooth motion of one body between two events, as Taylor series.
#pragma once

#include "core/simulator/model/state.hpp"
#include "core/simulator/trajectory/taylor_series.hpp"

#include <algorithm>

namespace mirocup::simulator::trajectory {

// Which part of the twist is exactly zero at the end of a segment, although its series leave a
// rounding error there: the lateral slip of wheels that grip again, or all of a ball that stops.
enum class TerminalState { nothing, sideways, everything };

// The trajectory of one body for begin <= t <= end, seconds since the start of the tick. The series
// count from `begin`; all have the same number of terms.
struct Segment {
  double begin = 0.0;
  double end = 0.0;

  Series x, y;                  // m, field's frame
  Series cos, sin;              // heading
  Series forward, left, omega;  // twist: m/s, m/s, rad/s in the body's frame

  TerminalState settles = TerminalState::nothing;  // at `end`
};

// Sets the first term of each series: pose and twist at `begin`.
void set_first_terms(const BodyState& body, Segment& segment);

// Returns the segment of a body that keeps its pose; its twist is zero.
Segment still_segment(const BodyState& body, double begin, double end);

// Returns a segment whose series have their first term only: pose and twist at `begin`. The caller
// fills in the other terms, which are zero.
Segment moving_segment(const BodyState& body, double begin, double end);

// Returns the segment of a body that keeps its twist: a straight line or an arc.
Segment steady_segment(const BodyState& body, double begin, double end);

// Returns the state of a body that has kept its twist for `span` seconds, in closed form.
BodyState along_arc(const BodyState& body, double span);

// Adds term k + 1 of the pose, from the terms of pose and twist up to k: dx/dt = v_f cos - v_l
// sin, dy/dt = v_f sin + v_l cos, d(cos)/dt = -omega sin, d(sin)/dt = omega cos. Without
// `drifts`, v_l is zero throughout and is not read.
void integrate_pose(Segment& segment, int k, bool drifts = true);

// Sets the number of terms of all series of the segment, one of term_counts.
void set_terms(Segment& segment, int terms);

// True if the series of the pose have converged over `length` seconds: their last two terms add
// up to at most `truncation` (free_truncation or contact_truncation of solver_settings.hpp), and
// do not grow from one to the next. All terms must be set.
bool has_converged(const Segment& segment, double length, double truncation);

// Returns a length, s, over which the series have converged. It is at most `longest`, and at most
// 15 % shorter than the longest such length.
double converged_length(const Segment& segment, double longest, double truncation);

// Fills the series of a segment that has only its first terms. extend(k) adds term k + 1. The
// series get the fewest terms that converge over `preferred_duration` seconds or the whole segment,
// whichever is shorter; max_terms if no number of terms does. The segment is then cut to the time
// of convergence.
template <class Extend>
void fill_series(Segment& segment, double preferred_duration, Extend extend) {
  const double wanted = segment.end - segment.begin;
  int k = 0;
  for (const int terms : term_counts) {
    for (; k < terms - 1; ++k) extend(k);
    set_terms(segment, terms);
    if (has_converged(segment, std::min(wanted, preferred_duration),
                      settings::segment.free_truncation))
      break;
  }
  const double length = converged_length(segment, wanted, settings::segment.free_truncation);
  if (length < wanted) segment.end = segment.begin + length;
}

// Return the state, or the pose alone at half the cost, at time t of the tick, begin <= t <= end.
// The heading is normalised to length 1.
BodyState body_at(const Segment& segment, double t);
Pose pose_at(const Segment& segment, double t);

// The pose of a segment as series that count from another origin.
struct Track {
  Series x, y, cos, sin;
};
// Returns the track of a segment from `origin`, s of the tick, origin >= segment.begin.
Track track_from(const Segment& segment, double origin);

// An axis-parallel box in the field's frame, m.
struct Box {
  double low_x, high_x, low_y, high_y;
};
// Returns a box that holds the body's reference point over the whole segment.
Box swept_box(const Segment& segment);

}  // namespace mirocup::simulator::trajectory
