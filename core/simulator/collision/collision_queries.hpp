// SPDX-License-Identifier: MIT
//
// What does not change while a world runs: outlines, masses, walls; and what a pair can be asked:
// its gap, its contact points, its next touch.
#pragma once

#include "core/geometry/outline.hpp"
#include "core/geometry/separation.hpp"
#include "core/simulator/collision/contact_constraint.hpp"
#include "core/simulator/model/body_pair.hpp"
#include "core/simulator/model/parameters.hpp"
#include "core/simulator/model/tolerances.hpp"
#include "core/simulator/trajectory/segment.hpp"

#include <array>
#include <span>

namespace mirocup::simulator::collision {

struct StaticWorld {
  Parameters parameters;
  Tolerances tolerances;
  int robots = 0;
  bool has_ball = false;
  const field::Field* field = nullptr;  // null: no obstacles

  geometry::Outline robot_outline;
  geometry::Outline ball_outline;
  std::array<geometry::Outline, end_walls> end_wall_outlines;
  solver::InverseMass free_robot, grounded_robot, ball;
  double reach_of_robots = 0.0;  // m between reference points: beyond, two robots do not touch
  double reach_of_ball = 0.0;    // m: beyond, the ball and a robot do not

  int bodies() const { return robots + (has_ball ? 1 : 0); }
  bool is_ball(int body) const { return body == robots; }
  const geometry::Outline& shape(int body) const {
    return is_ball(body) ? ball_outline : robot_outline;
  }
  double reach(int i, int j) const {
    return is_ball(i) || is_ball(j) ? reach_of_ball : reach_of_robots;
  }
};

StaticWorld make_static_world(const field::Field* field, const Parameters& parameters,
                              const Tolerances& tolerances, int robots, bool has_ball);

// What the parameters say of this kind of pair.
double restitution(const StaticWorld& world, const Pair& pair);
double contact_friction(const StaticWorld& world, const Pair& pair);

// The pair's second outline, of a body or an end wall, and where it is.
const geometry::Outline& partner_outline(const StaticWorld& world, const Pair& pair);
BodyState partner_body(const Pair& pair, std::span<const BodyState> bodies);

geometry::Separation separation(const StaticWorld& world, const Pair& pair, const Pose& a,
                                const Pose& b);
inline double gap(const StaticWorld& world, const Pair& pair, const Pose& a, const Pose& b) {
  return separation(world, pair, a, b).gap;
}

// Where these bodies are.
inline double gap(const StaticWorld& world, const Pair& pair, std::span<const BodyState> bodies) {
  return gap(world, pair, bodies[pair.a], bodies[pair.with_obstacle() ? pair.a : pair.partner]);
}

// The pair's contacts with a gap of at most `margin`, appended with their Jacobian rows. For an
// obstacle `bodies` needs only a.
void add_contacts(const StaticWorld& world, const Pair& pair, std::span<const BodyState> bodies,
                  double margin, ContactList& list);
// The same of points that were found for it.
void add_points(const StaticWorld& world, const Pair& pair, std::span<const BodyState> bodies,
                const ContactPoints& found, ContactList& list);

// A contact of the pair where the bodies are now: the same corner and edge once more, or what of the
// other side the ball is nearest to.
void refresh_contact(const StaticWorld& world, std::span<const BodyState> bodies, const Pair& pair,
                     ContactPoint& contact);

// The gap of a contact where its bodies are now, m. The corner is behind its edge's line, too, while it
// is still beside the edge; so what is deeper than `line`, m, is at most as deep as the pair overlaps.
double clamped_gap(const StaticWorld& world, std::span<const BodyState> bodies,
                   const Contact& contact, double line);

// The first time from t on at which the pair's gap is `level` or less, m, or never; t and the segments
// as in contact_time().
double first_time_below(const StaticWorld& world, const Pair& pair, double level,
                        std::span<const trajectory::Segment> segments, double t);

// When the pair first touches in [t, end of both segments], or never. A pair that touches at t
// already is looked at until it has come closer by `sink`, m.
double contact_time(const StaticWorld& world, const Pair& pair,
                    std::span<const trajectory::Segment> segments, double t, double sink);

}  // namespace mirocup::simulator::collision
