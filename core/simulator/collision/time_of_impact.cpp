// SPDX-License-Identifier: MIT
#include "core/simulator/collision/time_of_impact.hpp"

#include "core/geometry/separation.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace mirocup::simulator::collision {

namespace {

// Separating lines are tried at most this often; two or three are usual. Beyond, the time reached
// is returned as if it were a touch: the caller finds none there and looks again from it.
constexpr int max_axes = 64;

struct SeriesPoint {
  trajectory::Series x, y;

  Vec2 at(double t) const { return {x.at(t), y.at(t)}; }
};

SeriesPoint difference(const trajectory::Track& a, const trajectory::Track& b) {
  return {a.x - b.x, a.y - b.y};
}

// The components of v in a frame with that heading.
trajectory::Series forward_in(const trajectory::Track& frame, const SeriesPoint& v) {
  return sum_of_products(frame.cos, v.x, frame.sin, v.y);
}
trajectory::Series left_in(const trajectory::Track& frame, const SeriesPoint& v) {
  return difference_of_products(frame.cos, v.y, frame.sin, v.x);
}

// A body's motion seen from a line with the normal n: n . (q + R corner) for each of its corners,
// where n . q is that of its centre and the heading of R is (cos, sin).
class DistanceAlong {
 public:
  DistanceAlong(const Vec2& n, const trajectory::Series& of_centre, const trajectory::Series& cos,
                const trajectory::Series& sin)
      : n_(n), of_centre_(of_centre), cos_(cos), sin_(sin) {}

  trajectory::Series operator()(const Vec2& corner) const {
    return of_centre_ + n_.dot(corner) * cos_ + cross(corner, n_) * sin_;
  }

  // Of some corners at once, from the first of these on: over [0, end] none comes lower than this.
  static constexpr int at_once = 4;
  std::array<double, at_once> lowest(const geometry::Outline& shape, int from, double end) const {
    std::array<double, at_once> of_cos, of_sin;
    for (int i = 0; i < at_once; ++i) {
      const Vec2& corner = shape.corner[std::min(from + i, shape.corners - 1)];
      of_cos[i] = n_.dot(corner);
      of_sin[i] = cross(corner, n_);
    }
    return trajectory::with_terms(
        std::max({of_centre_.terms, cos_.terms, sin_.terms}), [&](auto n) {
          std::array<double, at_once> low;
          for (int i = 0; i < at_once; ++i) {
            low[i] = of_centre_[0] + of_cos[i] * cos_[0] + of_sin[i] * sin_[0];
          }
          double power = 1.0;
          for (int k = 1; k < n; ++k) {
            power *= end;
            for (int i = 0; i < at_once; ++i) {
              const double term = of_centre_[k] + of_cos[i] * cos_[k] + of_sin[i] * sin_[k];
              low[i] += std::min(term * power, 0.0);
            }
          }
          return low;
        });
  }

 private:
  Vec2 n_;
  trajectory::Series of_centre_;
  const trajectory::Series& cos_;
  const trajectory::Series& sin_;
};

// A polygon's motion in the frame of another. Most edges lie along one of the frame's axes: the other
// component of the position is made when it is needed.
class RelativeTrack {
 public:
  RelativeTrack(const trajectory::Track& moving, const trajectory::Track& frame)
      : frame_(frame),
        apart_(difference(moving, frame)),
        cos_(sum_of_products(frame.cos, moving.cos, frame.sin, moving.sin)),
        sin_(difference_of_products(frame.cos, moving.sin, frame.sin, moving.cos)) {}

  DistanceAlong distance_along(const Vec2& n) { return {n, position_along(n), cos_, sin_}; }

 private:
  trajectory::Series position_along(const Vec2& n) {
    if (n.x() != 0.0 && !forward_) forward_ = forward_in(frame_, apart_);
    if (n.y() != 0.0 && !allowed_overlap_) allowed_overlap_ = left_in(frame_, apart_);
    if (n.x() == 0.0) return n.y() * *allowed_overlap_;
    if (n.y() == 0.0) return n.x() * *forward_;
    return n.x() * *forward_ + n.y() * *allowed_overlap_;
  }

  const trajectory::Track& frame_;
  SeriesPoint apart_;
  trajectory::Series cos_, sin_;
  std::optional<trajectory::Series> forward_, allowed_overlap_;
};

// From `begin` on, when the first corner of the shape comes down to `level`.
double first_corner_contact(const DistanceAlong& distance, const geometry::Outline& shape,
                            double level, double begin, double end) {
  double first = trajectory::never;
  for (int from = 0; from < shape.corners; from += DistanceAlong::at_once) {
    const auto lowest = distance.lowest(shape, from, end);
    for (int i = 0; i < DistanceAlong::at_once && from + i < shape.corners; ++i) {
      if (lowest[i] > level) continue;
      const trajectory::Series d = distance(shape.corner[from + i]);
      first = std::min(first, first_crossing(d, level, begin, std::min(first, end)));
    }
  }
  return first;
}

// When the first corner of `other` comes down to `level` over one edge of `reference`.
double first_corner_over(const geometry::Outline& reference, int edge,
                         const geometry::Outline& other, RelativeTrack& motion, double level,
                         double begin, double end) {
  const DistanceAlong distance = motion.distance_along(reference.normal[edge]);
  return first_corner_contact(distance, other, reference.offset[edge] + level, begin, end);
}

// From t on, the first time at which the centre comes within `reach` of a corner or leaves the
// sector in which that corner is what it is nearest to.
double first_change_at_corner(const geometry::Outline& polygon, int corner,
                              const SeriesPoint& centre, double reach, double t, double end) {
  SeriesPoint away = centre;
  away.x[0] -= polygon.corner[corner].x();
  away.y[0] -= polygon.corner[corner].y();
  // (distance^2 - reach^2) / 2 reach: for small gaps, the gap.
  const trajectory::Series gap = (0.5 / reach) * (away.x * away.x + away.y * away.y);
  const Vec2& before = polygon.normal[corner == 0 ? polygon.corners - 1 : corner - 1];
  const Vec2& after = polygon.normal[corner];
  const double first = first_crossing(gap, 0.5 * reach, t, end);
  const double over_before = first_crossing(before.x() * away.y - before.y() * away.x,
                                            -4.0 * trajectory::root_tolerance, t, end);
  const double over_after = first_crossing(after.y() * away.x - after.x() * away.y,
                                           -4.0 * trajectory::root_tolerance, t, end);
  return std::min({first, over_before, over_after});
}

double time_of_impact_of_circle(const MovingOutline& a, const MovingOutline& b, double level,
                                double begin, double end) {
  const trajectory::Track track_b = track_from(b.segment, begin);
  const SeriesPoint apart = difference(track_from(a.segment, begin), track_b);
  const SeriesPoint centre{forward_in(track_b, apart), left_in(track_b, apart)};
  const double length = end - begin;
  const double reach = a.shape.radius + level;
  double t = 0.0;
  for (int line = 0; line < max_axes; ++line) {
    const geometry::Axis axis = nearest_axis(b.shape, centre.at(t));
    if (axis.separation <= reach + trajectory::root_tolerance) break;
    if (axis.corner >= 0) {
      t = first_change_at_corner(b.shape, axis.corner, centre, reach, t, length);
    } else {
      const trajectory::Series d = axis.normal.x() * centre.x + axis.normal.y() * centre.y;
      t = first_crossing(d, axis.offset + reach, t, length);
    }
    if (t == trajectory::never) return trajectory::never;
  }
  return begin + t;
}

geometry::Reference reference_at(const MovingOutline& a, const MovingOutline& b, double t) {
  return reference_of(a.shape, pose_at(a.segment, t), b.shape, pose_at(b.segment, t));
}

// The reference is that at the begin.
double time_of_impact_of_polygons(const MovingOutline& a, const MovingOutline& b,
                                  geometry::Reference reference, double level, double begin,
                                  double end) {
  if (reference.best.separation <= level + trajectory::root_tolerance) return begin;
  const trajectory::Track track_a = track_from(a.segment, begin);
  const trajectory::Track track_b = track_from(b.segment, begin);
  // Made when an edge of that side is needed.
  std::optional<RelativeTrack> a_in_b, b_in_a;
  const double length = end - begin;
  double t = 0.0;
  for (int line = 0; line < max_axes; ++line) {
    if (line > 0) reference = reference_at(a, b, begin + t);
    if (reference.best.separation <= level + trajectory::root_tolerance) break;
    if (reference.is_a) {
      if (!b_in_a) b_in_a.emplace(track_b, track_a);
      t = first_corner_over(a.shape, reference.best.edge, b.shape, *b_in_a, level, t, length);
    } else {
      if (!a_in_b) a_in_b.emplace(track_a, track_b);
      t = first_corner_over(b.shape, reference.best.edge, a.shape, *a_in_b, level, t, length);
    }
    if (t == trajectory::never) return trajectory::never;
  }
  return begin + t;
}

// From the gap at the begin and what says when it has fallen to a level.
template <class FirstTouch>
double impact_or_penetration(double now, double sink, double begin, FirstTouch impact_at) {
  if (now > std::max(trajectory::root_tolerance, sink)) {
    const double touch = impact_at(0.0);
    if (touch > begin) return touch;
  }
  return impact_at(std::min(now, 0.0) - sink);
}

}  // namespace

double time_of_impact(const MovingOutline& a, const MovingOutline& b, double level, double begin,
                      double end) {
  if (a.shape.is_circle()) return time_of_impact_of_circle(a, b, level, begin, end);
  return time_of_impact_of_polygons(a, b, reference_at(a, b, begin), level, begin, end);
}

double time_of_impact(const MovingOutline& a, const field::Wall& wall, double level, double begin,
                      double end) {
  const trajectory::Track track = track_from(a.segment, begin);
  const trajectory::Series of_centre = wall.normal.x() * track.x + wall.normal.y() * track.y;
  const double target = wall.offset + level;
  const double length = end - begin;
  if (a.shape.is_circle()) {
    return begin + first_crossing(of_centre, target + a.shape.radius, 0.0, length);
  }
  const DistanceAlong distance(wall.normal, of_centre, track.cos, track.sin);
  return begin + first_corner_contact(distance, a.shape, target, 0.0, length);
}

double time_of_impact_or_penetration(const MovingOutline& a, const MovingOutline& b, double sink,
                                     double begin, double end) {
  if (a.shape.is_circle()) {
    const double now = gap(a.shape, pose_at(a.segment, begin), b.shape, pose_at(b.segment, begin));
    return impact_or_penetration(now, sink, begin, [&](double level) {
      return time_of_impact_of_circle(a, b, level, begin, end);
    });
  }
  const geometry::Reference now = reference_at(a, b, begin);
  return impact_or_penetration(now.best.separation, sink, begin, [&](double level) {
    return time_of_impact_of_polygons(a, b, now, level, begin, end);
  });
}

double time_of_impact_or_penetration(const MovingOutline& a, const field::Wall& wall, double sink,
                                     double begin, double end) {
  const double now = gap(a.shape, pose_at(a.segment, begin), wall);
  return impact_or_penetration(
      now, sink, begin, [&](double level) { return time_of_impact(a, wall, level, begin, end); });
}

}  // namespace mirocup::simulator::collision
