// SPDX-License-Identifier: MIT
#include "core/simulator/time_of_impact.hpp"

#include "core/simulator/contact.hpp"

#include <algorithm>
#include <optional>

namespace mirocup::simulator {

namespace {

// Separating lines are tried at most this often; two or three are usual. Beyond, the time reached
// is returned as if it were a touch: the caller finds none there and looks again from it.
constexpr int most_lines = 64;

struct SeriesPoint {
  Series x, y;

  Vec2 at(double t) const { return {x.at(t), y.at(t)}; }
};

// The direction v in a frame with the given heading.
SeriesPoint to_body(const Track& frame, const SeriesPoint& v) {
  return {frame.cos * v.x + frame.sin * v.y, frame.cos * v.y - frame.sin * v.x};
}

SeriesPoint difference(const Track& a, const Track& b) {
  return {a.x - b.x, a.y - b.y};
}

// A body's motion seen from a line with the normal n: n . (q + R corner) for each of its corners,
// where the heading of R is (cos, sin).
class DistanceAlong {
 public:
  DistanceAlong(const Vec2& n, const SeriesPoint& q, const Series& cos, const Series& sin)
      : n_(n), of_centre_(n.x() * q.x + n.y() * q.y), cos_(cos), sin_(sin) {}

  Series operator()(const Vec2& corner) const {
    return of_centre_ + n_.dot(corner) * cos_ + cross(corner, n_) * sin_;
  }

 private:
  Vec2 n_;
  Series of_centre_;
  const Series& cos_;
  const Series& sin_;
};

// A polygon's motion in the frame of another: position and heading.
struct RelativeTrack {
  SeriesPoint position;
  Series cos, sin;
};

RelativeTrack relative_track(const Track& moving, const Track& frame) {
  return {to_body(frame, difference(moving, frame)),
          frame.cos * moving.cos + frame.sin * moving.sin,
          frame.cos * moving.sin - frame.sin * moving.cos};
}

// When the first corner of `other` comes down to `level` over one edge of `reference`.
double first_corner_over(const Shape& reference, int edge, const Shape& other,
                         const RelativeTrack& motion, double level, double begin, double end) {
  const DistanceAlong distance(reference.normal[edge], motion.position, motion.cos, motion.sin);
  const double target = reference.offset[edge] + level;
  double first = never;
  for (int i = 0; i < other.corners; ++i) {
    const Series d = distance(other.corner[i]);
    first = std::min(first, first_fall(d, target, begin, std::min(first, end)));
  }
  return first;
}

// From t on, the first time at which the centre comes within `reach` of a corner or leaves the
// sector in which that corner is what it is nearest to.
double first_change_at_corner(const Shape& polygon, int corner, const SeriesPoint& centre,
                              double reach, double t, double end) {
  SeriesPoint away = centre;
  away.x[0] -= polygon.corner[corner].x();
  away.y[0] -= polygon.corner[corner].y();
  // (distance^2 - reach^2) / 2 reach: for small gaps, the gap.
  const Series gap = (0.5 / reach) * (away.x * away.x + away.y * away.y);
  const Vec2& before = polygon.normal[corner == 0 ? polygon.corners - 1 : corner - 1];
  const Vec2& after = polygon.normal[corner];
  const double first = first_fall(gap, 0.5 * reach, t, end);
  const double over_before =
      first_fall(before.x() * away.y - before.y() * away.x, -4.0 * closeness, t, end);
  const double over_after =
      first_fall(after.y() * away.x - after.x() * away.y, -4.0 * closeness, t, end);
  return std::min({first, over_before, over_after});
}

double first_touch_of_circle(const Mover& a, const Mover& b, double level, double begin,
                             double end) {
  const Track track_b = track_from(b.segment, begin);
  const SeriesPoint centre = to_body(track_b, difference(track_from(a.segment, begin), track_b));
  const double length = end - begin;
  const double reach = a.shape.radius + level;
  double t = 0.0;
  for (int line = 0; line < most_lines; ++line) {
    const Axis axis = nearest_axis(b.shape, centre.at(t));
    if (axis.separation <= reach + closeness) break;
    if (axis.corner >= 0) {
      t = first_change_at_corner(b.shape, axis.corner, centre, reach, t, length);
    } else {
      const Series d = axis.normal.x() * centre.x + axis.normal.y() * centre.y;
      t = first_fall(d, axis.offset + reach, t, length);
    }
    if (t == never) return never;
  }
  return begin + t;
}

double first_touch_of_polygons(const Mover& a, const Mover& b, double level, double begin,
                               double end) {
  const auto reference_at = [&](double t) {
    return reference_of(a.shape, body_at(a.segment, t), b.shape, body_at(b.segment, t));
  };
  Reference reference = reference_at(begin);
  // Made when an edge of that side is needed.
  std::optional<RelativeTrack> a_in_b, b_in_a;
  const auto seen_from = [begin](const Mover& frame, const Mover& moving) {
    return relative_track(track_from(moving.segment, begin), track_from(frame.segment, begin));
  };

  const double length = end - begin;
  double t = 0.0;
  for (int line = 0; line < most_lines; ++line) {
    if (line > 0) reference = reference_at(begin + t);
    if (reference.best.separation <= level + closeness) break;
    if (reference.is_a) {
      if (!b_in_a) b_in_a = seen_from(a, b);
      t = first_corner_over(a.shape, reference.best.edge, b.shape, *b_in_a, level, t, length);
    } else {
      if (!a_in_b) a_in_b = seen_from(b, a);
      t = first_corner_over(b.shape, reference.best.edge, a.shape, *a_in_b, level, t, length);
    }
    if (t == never) return never;
  }
  return begin + t;
}

}  // namespace

double first_touch(const Mover& a, const Mover& b, double level, double begin, double end) {
  return a.shape.is_circle() ? first_touch_of_circle(a, b, level, begin, end)
                             : first_touch_of_polygons(a, b, level, begin, end);
}

double first_touch(const Mover& a, const field::Wall& wall, double level, double begin,
                   double end) {
  const Track track = track_from(a.segment, begin);
  const double target = wall.offset + level;
  if (a.shape.is_circle()) {
    const Series d = wall.normal.x() * track.x + wall.normal.y() * track.y;
    return begin + first_fall(d, target + a.shape.radius, 0.0, end - begin);
  }
  const DistanceAlong distance(wall.normal, {track.x, track.y}, track.cos, track.sin);
  double first = never;
  for (int i = 0; i < a.shape.corners; ++i) {
    const Series d = distance(a.shape.corner[i]);
    first = std::min(first, first_fall(d, target, 0.0, std::min(first, end - begin)));
  }
  return begin + first;
}

}  // namespace mirocup::simulator
