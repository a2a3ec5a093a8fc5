// SPDX-License-Identifier: MIT
#include "core/simulator/collision/time_of_impact.hpp"

#include "core/base/assert.hpp"
#include "core/simulator/model/solver_settings.hpp"

#include <algorithm>
#include <array>

namespace mirocup::simulator::collision {

namespace {

// How far beyond the border of a corner's sector, m, the centre must be to have left it: rounding
// must not end the search while the centre is on the border.
constexpr double sector_round_off =
    settings::time_of_impact.sector_round_off * settings::taylor_series.root_tolerance;

// A vector whose components are series.
struct SeriesPoint {
  trajectory::Series x, y;

  Vec2 at(double t) const { return {x.at(t), y.at(t)}; }
};

SeriesPoint difference(const trajectory::Track& a, const trajectory::Track& b) {
  return {a.x - b.x, a.y - b.y};
}

// Return the components of v in a frame that turns: along its heading, and to its left.
trajectory::Series forward_in(const trajectory::Track& frame, const SeriesPoint& v) {
  return sum_of_products(frame.cos, v.x, frame.sin, v.y);
}
trajectory::Series left_in(const trajectory::Track& frame, const SeriesPoint& v) {
  return difference_of_products(frame.cos, v.y, frame.sin, v.x);
}

// The distances of a body's corners along a fixed normal n: n . (q + R corner) as a series in time,
// where q is the body's centre and R its rotation, with the heading (cos, sin). It refers to cos
// and sin, which must outlive it.
class DistanceAlong {
 public:
  DistanceAlong(const Vec2& n, const trajectory::Series& of_centre, const trajectory::Series& cos,
                const trajectory::Series& sin)
      : n_(n), of_centre_(of_centre), cos_(cos), sin_(sin) {}

  // Returns the distance of a corner, which is given in the body's frame.
  trajectory::Series operator()(const Vec2& corner) const {
    const double of_cos = n_.dot(corner);
    const double of_sin = cross(corner, n_);
    return trajectory::with_terms(terms_, [&](auto n) {
      trajectory::Series distance;
      distance.terms = n;
      for (int k = 0; k < n; ++k) distance[k] = of_centre_[k] + of_cos * cos_[k] + of_sin * sin_[k];
      return distance;
    });
  }

  // Returns lower bounds of the distances over [0, end] for batch_size corners at once, from corner
  // `from` on: the first coefficient plus all terms that can become negative.
  static constexpr int batch_size = 4;  // doubles in two vector registers
  std::array<double, batch_size> lower_bounds(const geometry::Outline& shape, int from,
                                              double end) const {
    std::array<double, batch_size> of_cos, of_sin;
    for (int i = 0; i < batch_size; ++i) {
      const Vec2& corner = shape.corner[std::min(from + i, shape.corners - 1)];
      of_cos[i] = n_.dot(corner);
      of_sin[i] = cross(corner, n_);
    }
    return trajectory::with_terms(terms_, [&](auto n) {
      std::array<double, batch_size> low;
      for (int i = 0; i < batch_size; ++i) {
        low[i] = of_centre_[0] + of_cos[i] * cos_[0] + of_sin[i] * sin_[0];
      }
      double power = 1.0;
      for (int k = 1; k < n; ++k) {
        power *= end;
        for (int i = 0; i < batch_size; ++i) {
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
  int terms_ = std::max({of_centre_.terms, cos_.terms, sin_.terms});
};

// A polygon's motion in the frame of another. Most edges are parallel to an axis of the frame, so
// each component of the position is computed only when it is needed.
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
    if (n.y() != 0.0 && !left_) left_ = left_in(frame_, apart_);
    if (n.x() == 0.0) return n.y() * *left_;
    if (n.y() == 0.0) return n.x() * *forward_;
    return n.x() * *forward_ + n.y() * *left_;
  }

  const trajectory::Track& frame_;
  SeriesPoint apart_;
  trajectory::Series cos_, sin_;
  std::optional<trajectory::Series> forward_, left_;
};

// Returns the first time in [begin, end] at which a corner of the shape has come down to `level`.
// Corners whose lower bound stays above it are ruled out without a search.
double first_corner_crossing(const DistanceAlong& distance, const geometry::Outline& shape,
                             double level, double begin, double end) {
  double first = trajectory::never;
  for (int from = 0; from < shape.corners; from += DistanceAlong::batch_size) {
    const auto lowest = distance.lower_bounds(shape, from, end);
    for (int i = 0; i < DistanceAlong::batch_size && from + i < shape.corners; ++i) {
      if (lowest[i] > level) continue;
      const trajectory::Series d = distance(shape.corner[from + i]);
      first = std::min(first, first_crossing(d, level, begin, std::min(first, end)));
    }
  }
  return first;
}

// Returns the first time at which a corner of `other` is at most `level` above an edge of
// `reference`. `motion` is that of `other` in the frame of `reference`.
double first_crossing_of_edge(const geometry::Outline& reference, int edge,
                              const geometry::Outline& other, RelativeTrack& motion, double level,
                              double begin, double end) {
  const DistanceAlong distance = motion.distance_along(reference.normal[edge]);
  return first_corner_crossing(distance, other, reference.offset[edge] + level, begin, end);
}

// Returns the first time from t on at which the centre comes within `reach` of a corner, or leaves
// the sector between the normals of the corner's edges, in which the corner is the nearest feature.
double first_change_at_corner(const geometry::Outline& polygon, int corner,
                              const SeriesPoint& centre, double reach, double t, double end) {
  SeriesPoint away = centre;
  away.x[0] -= polygon.corner[corner].x();
  away.y[0] -= polygon.corner[corner].y();
  // (distance^2 - reach^2) / 2 reach is the gap where that is small; so distance^2 / 2 reach has to
  // fall to reach / 2.
  const trajectory::Series scaled = (0.5 / reach) * (away.x * away.x + away.y * away.y);
  const Vec2& before = polygon.normal[corner == 0 ? polygon.corners - 1 : corner - 1];
  const Vec2& after = polygon.normal[corner];
  const double touches = first_crossing(scaled, 0.5 * reach, t, end);
  const double leaves_before =
      first_crossing(before.x() * away.y - before.y() * away.x, -sector_round_off, t, end);
  const double leaves_after =
      first_crossing(after.y() * away.x - after.x() * away.y, -sector_round_off, t, end);
  return std::min({touches, leaves_before, leaves_after});
}

double time_of_impact_of_circle(const MovingOutline& a, const MovingOutline& b, double level,
                                double begin, double end) {
  const trajectory::Track track_b = track_from(b.segment, begin);
  const SeriesPoint apart = difference(track_from(a.segment, begin), track_b);
  const SeriesPoint centre{forward_in(track_b, apart), left_in(track_b, apart)};
  const double length = end - begin;
  const double reach = a.shape.radius + level;
  double t = 0.0;
  for (int axes = 0; axes < settings::time_of_impact.max_axes; ++axes) {
    const geometry::Axis axis = nearest_axis(b.shape, centre.at(t));
    if (axis.separation <= reach + settings::taylor_series.root_tolerance) break;
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

// Like time_of_impact(). `reference` is the reference edge at `begin`.
double time_of_impact_of_polygons(const MovingOutline& a, const MovingOutline& b,
                                  geometry::Reference reference, double level, double begin,
                                  double end) {
  if (reference.best.separation <= level + settings::taylor_series.root_tolerance) return begin;
  const trajectory::Track track_a = track_from(a.segment, begin);
  const trajectory::Track track_b = track_from(b.segment, begin);
  // Each is computed when an edge of that side is needed.
  std::optional<RelativeTrack> a_in_b, b_in_a;
  const double length = end - begin;
  double t = 0.0;
  for (int axes = 0; axes < settings::time_of_impact.max_axes; ++axes) {
    if (axes > 0) reference = reference_at(a, b, begin + t);
    if (reference.best.separation <= level + settings::taylor_series.root_tolerance) break;
    if (reference.is_a) {
      if (!b_in_a) b_in_a.emplace(track_b, track_a);
      t = first_crossing_of_edge(a.shape, reference.best.edge, b.shape, *b_in_a, level, t, length);
    } else {
      if (!a_in_b) a_in_b.emplace(track_a, track_b);
      t = first_crossing_of_edge(b.shape, reference.best.edge, a.shape, *a_in_b, level, t, length);
    }
    if (t == trajectory::never) return trajectory::never;
  }
  return begin + t;
}

// Returns the time of impact or of penetration from the gap at `begin`. time_at_level(level) is the
// first time at which the gap has fallen to a level.
template <class TimeAtLevel>
double impact_or_penetration(double gap_at_begin, double penetration, double begin,
                             TimeAtLevel time_at_level) {
  if (gap_at_begin > std::max(settings::taylor_series.root_tolerance, penetration)) {
    const double impact = time_at_level(0.0);
    if (impact > begin) return impact;
  }
  return time_at_level(std::min(gap_at_begin, 0.0) - penetration);
}

}  // namespace

double time_of_impact(const MovingOutline& a, const MovingOutline& b, double level, double begin,
                      double end) {
  MIROCUP_ASSERT(!b.shape.is_circle());
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
  return begin + first_corner_crossing(distance, a.shape, target, 0.0, length);
}

double time_of_impact_or_penetration(const MovingOutline& a, const MovingOutline& b,
                                     double penetration, double begin, double end,
                                     const std::optional<geometry::Reference>& reference) {
  if (a.shape.is_circle()) {
    const double now = gap(a.shape, pose_at(a.segment, begin), b.shape, pose_at(b.segment, begin));
    return impact_or_penetration(now, penetration, begin, [&](double level) {
      return time_of_impact_of_circle(a, b, level, begin, end);
    });
  }
  const geometry::Reference now = reference ? *reference : reference_at(a, b, begin);
  return impact_or_penetration(now.best.separation, penetration, begin, [&](double level) {
    return time_of_impact_of_polygons(a, b, now, level, begin, end);
  });
}

double time_of_impact_or_penetration(const MovingOutline& a, const field::Wall& wall,
                                     double penetration, double begin, double end,
                                     const std::optional<geometry::Reference>&) {
  const double now = gap(a.shape, pose_at(a.segment, begin), wall);
  return impact_or_penetration(now, penetration, begin, [&](double level) {
    return time_of_impact(a, wall, level, begin, end);
  });
}

}  // namespace mirocup::simulator::collision
