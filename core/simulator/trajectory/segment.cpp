// SPDX-License-Identifier: MIT
#include "core/simulator/trajectory/segment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirocup::simulator::trajectory {

void set_first_terms(const BodyState& body, Segment& s) {
  s.x[0] = body.position.x();
  s.y[0] = body.position.y();
  s.cos[0] = body.heading.cos;
  s.sin[0] = body.heading.sin;
  s.forward[0] = body.twist.forward;
  s.left[0] = body.twist.left;
  s.omega[0] = body.twist.omega;
}

Segment still_segment(const BodyState& body, double begin, double end) {
  Segment s = moving_segment({body.position, body.heading, {}}, begin, end);
  set_terms(s, min_terms);
  return s;
}

Segment moving_segment(const BodyState& body, double begin, double end) {
  Segment s;
  s.begin = begin;
  s.end = end;
  set_first_terms(body, s);
  return s;
}

Segment steady_segment(const BodyState& body, double begin, double end) {
  Segment s = moving_segment(body, begin, end);
  for (int k = 0; k < max_terms - 1; ++k) integrate_pose(s, k);
  return s;
}

BodyState along_arc(const BodyState& body, double span) {
  const Twist& v = body.twist;
  const double angle = v.omega * span;
  const SinCos turned = sincos(angle);
  // The mean of the heading over the arc: sin(angle) / angle along it, (1 - cos(angle)) / angle
  // across it. Both are 0/0 for a straight line.
  constexpr double small = settings::segment.small_turn;
  const double square = angle * angle;
  const bool is_small = square < small * small;
  const double along = is_small ? 1.0 - square / 6.0 : turned.sin / angle;
  const double across = is_small ? 0.5 * angle : along * turned.sin / (1.0 + turned.cos);
  BodyState end = body;
  end.position += span * body.heading.to_world({along * v.forward - across * v.left,
                                                across * v.forward + along * v.left});
  end.heading = body.heading.turned(turned);
  return end;
}

void integrate_pose(Segment& s, int k, bool drifts) {
  // Six calls of product_term() in one loop.
  double cos = 0.0;
  double sin = 0.0;
  double x = 0.0;
  double y = 0.0;
  double drift_x = 0.0;
  double drift_y = 0.0;
  for (int j = 0; j <= k; ++j) {
    cos += s.omega[j] * s.sin[k - j];
    sin += s.omega[j] * s.cos[k - j];
    x += s.forward[j] * s.cos[k - j];
    y += s.forward[j] * s.sin[k - j];
    if (!drifts) continue;
    drift_x += s.left[j] * s.sin[k - j];
    drift_y += s.left[j] * s.cos[k - j];
  }
  const double next = k + 1;
  s.cos[k + 1] = -cos / next;
  s.sin[k + 1] = sin / next;
  s.x[k + 1] = (x - drift_x) / next;
  s.y[k + 1] = (y + drift_y) / next;
}

void set_terms(Segment& s, int terms) {
  s.x.terms = s.y.terms = s.cos.terms = s.sin.terms = terms;
  s.forward.terms = s.left.terms = s.omega.terms = terms;
}

namespace {

// The sizes of the last two coefficients of position and heading, which say how far the series
// converge. The index of the last one is odd.
struct LastTerms {
  int last;
  std::array<double, 4> before_of, last_of;
  double largest_before = 0.0;
  double largest_last = 0.0;

  explicit LastTerms(const Segment& s) : last(s.x.terms - 1) {
    int i = 0;
    for (const Series* p : {&s.x, &s.y, &s.cos, &s.sin}) {
      last_of[i] = std::abs((*p)[last]);
      before_of[i] = std::abs((*p)[last - 1]);
      largest_last = std::max(largest_last, last_of[i]);
      largest_before = std::max(largest_before, before_of[i]);
      ++i;
    }
  }

  bool converge_over(double length, double truncation) const {
    const double square = length * length;
    double power = square * square;
    for (int k = 4; k < last - 1; k += 2) power *= square;
    return power * (largest_before + length * largest_last) <= truncation &&
           !grow_over(length, power);
  }

  // True if a series grows from its last term but one to its last. Beyond the length to which a
  // series converges, a rounding error at the start is multiplied by each term: in a straight push,
  // for example, the lateral motion. It is too small yet to fail the test of `truncation`.
  bool grow_over(double length, double power) const {
    for (int i = 0; i < 4; ++i) {
      if (length * last_of[i] > before_of[i] &&
          power * length * last_of[i] > settings::segment.min_growth)
        return true;
    }
    return false;
  }
};

}  // namespace

bool has_converged(const Segment& s, double length, double truncation) {
  return LastTerms(s).converge_over(length, truncation);
}

double converged_length(const Segment& s, double longest, double truncation) {
  const LastTerms terms(s);
  double length = longest;
  while (!terms.converge_over(length, truncation)) length *= settings::segment.length_shrink;
  return length;
}

namespace {

template <int terms>
Pose pose_of_terms(const Segment& s, double u) {
  return {.position = {s.x.at<terms>(u), s.y.at<terms>(u)},
          .heading = Heading{s.cos.at<terms>(u), s.sin.at<terms>(u)}.normalised()};
}

}  // namespace

Pose pose_at(const Segment& s, double t) {
  const double u = t - s.begin;
  if (u == 0.0) return pose_of_terms<1>(s, u);
  return with_terms(s.x.terms, [&](auto n) { return pose_of_terms<n>(s, u); });
}

BodyState body_at(const Segment& segment, double t) {
  const double u = t - segment.begin;
  BodyState body = with_terms(segment.x.terms, [&](auto n) {
    const Pose pose = pose_of_terms<n>(segment, u);
    return BodyState{pose.position,
                     pose.heading,
                     {segment.forward.at<n>(u), segment.left.at<n>(u), segment.omega.at<n>(u)}};
  });
  if (t == segment.end && segment.settles != TerminalState::nothing) {
    body.twist.left = 0.0;
    if (segment.settles == TerminalState::everything) body.twist.forward = 0.0;
  }
  return body;
}

Track track_from(const Segment& segment, double origin) {
  const double by = origin - segment.begin;
  return {shifted(segment.x, by), shifted(segment.y, by), shifted(segment.cos, by),
          shifted(segment.sin, by)};
}

Box swept_box(const Segment& segment) {
  const double length = segment.end - segment.begin;
  const Range x = change_over(segment.x, length);
  const Range y = change_over(segment.y, length);
  return {segment.x[0] + x.low, segment.x[0] + x.high, segment.y[0] + y.low, segment.y[0] + y.high};
}

}  // namespace mirocup::simulator::trajectory
