// SPDX-License-Identifier: MIT
//
// The smooth motion of one body between two events.
#pragma once

#include "core/simulator/model/state.hpp"
#include "core/simulator/trajectory/taylor_series.hpp"

#include <algorithm>

namespace mirocup::simulator::trajectory {

// What is exactly zero at the end of a segment although its series leave a rounding error there.
enum class TerminalState { nothing, sideways, everything };

// Valid for begin <= t <= end, seconds since the begin of the tick. The series count from `begin`.
struct Segment {
  double begin = 0.0;
  double end = 0.0;

  Series x, y;                  // m
  Series cos, sin;              // heading
  Series forward, left, omega;  // twist

  TerminalState settles =
      TerminalState::nothing;  // sliding wheels that grip again, a ball that stops
};

// A body that keeps its place: pose, and a twist of zero.
Segment still_segment(const BodyState& body, double begin, double end);

// The first term of every series: pose and twist at the begin. The others are zero.
Segment moving_segment(const BodyState& body, double begin, double end);

// A body that keeps its twist: a straight line or an arc.
Segment steady_segment(const BodyState& body, double begin, double end);

// Where such a body is after `span` seconds.
BodyState along_arc(const BodyState& body, double span);

// One more term of the pose from the twist's terms up to k: dx/dt = v_f cos - v_l sin, d(cos)/dt =
// -omega sin. Without `drifts`, v_l is zero throughout.
void integrate_pose(Segment& segment, int k, bool drifts = true);

// Says how many terms the segment's series have.
void set_terms(Segment& segment, int terms);

// What the last two terms of a pose's series may come to together, m or of 1; what they leave out
// is a hundredth of that or less. Bodies that press on each other can do with less than one alone:
// where they press, their gaps are zero whatever is left out.
inline constexpr double free_truncation = 1e-10;
inline constexpr double contact_truncation = 4e-10;

// Have the pose's series converged to that over that length? All terms must be there.
bool has_converged(const Segment& segment, double length, double to);

// The longest length, at most `longest`, over which they have, or 15 % less.
double converged_length(const Segment& segment, double longest, double to);

// Fills the series of a segment of which only the first terms are there: extend(k) adds term k + 1.
// As few terms as hold for `enough` seconds or the whole segment; the length is cut to what the
// terms hold for.
template <class Extend>
void fill_series(Segment& segment, double preferred_duration, Extend extend) {
  const double wanted = segment.end - segment.begin;
  int k = 0;
  for (const int terms : term_counts) {
    for (; k < terms - 1; ++k) extend(k);
    set_terms(segment, terms);
    if (has_converged(segment, std::min(wanted, preferred_duration), free_truncation)) break;
  }
  const double length = converged_length(segment, wanted, free_truncation);
  if (length < wanted) segment.end = segment.begin + length;
}

// The body at time t of the segment, with a heading of length 1; and the same with a twist of zero, for
// which only half the work is done.
BodyState body_at(const Segment& segment, double t);
Pose pose_at(const Segment& segment, double t);

// The same motion with its series counted from `origin` >= segment.begin.
struct Track {
  Series x, y, cos, sin;
};
Track track_from(const Segment& segment, double origin);

// A box that holds the body's reference point over the whole segment.
struct Box {
  double low_x, high_x, low_y, high_y;
};
Box swept_box(const Segment& segment);

}  // namespace mirocup::simulator::trajectory
