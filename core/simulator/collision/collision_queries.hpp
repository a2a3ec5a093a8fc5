// SPDX-License-Identifier: MIT
//
// Questions about one pair of a static world: its gap, its contacts, and when it next touches. The
// functions choose between body, end wall and plane wall, so callers need not.
//
// Units are m and s, points and normals are in the field's frame, times are s of the tick. All
// functions are pure, except that some append to a ContactList. Uses model, trajectory and solver.
#pragma once

#include "core/geometry/separation.hpp"
#include "core/simulator/collision/contact_constraint.hpp"
#include "core/simulator/collision/static_world.hpp"
#include "core/simulator/trajectory/segment.hpp"

#include <optional>
#include <span>

namespace mirocup::simulator::collision {

// Returns pose and twist of the pair's partner. Obstacles stand still at the origin.
BodyState partner_body(const Pair& pair, std::span<const BodyState> bodies);

// Returns the separation of the pair's outlines at these poses. For an obstacle, b is ignored.
geometry::Separation separation(const StaticWorld& world, const Pair& pair, const Pose& a,
                                const Pose& b);

// Returns the pair's gap, m, negative if the outlines overlap.
inline double gap(const StaticWorld& world, const Pair& pair, const Pose& a, const Pose& b) {
  return separation(world, pair, a, b).gap;
}
inline double gap(const StaticWorld& world, const Pair& pair, std::span<const BodyState> bodies) {
  return gap(world, pair, bodies[pair.a], bodies[pair.with_obstacle() ? pair.a : pair.partner]);
}

// Appends the pair's contacts with a gap of at most `margin`, m, with their rows. If the list is
// full, further contacts are ignored and counted in its `overflows`.
void add_contacts(const StaticWorld& world, const Pair& pair, std::span<const BodyState> bodies,
                  double margin, ContactList& list);

// Appends contacts like add_contacts(), but at the contact points of the pair in `found`.
void add_points(const StaticWorld& world, const Pair& pair, std::span<const BodyState> bodies,
                const ContactPoints& found, ContactList& list);

// Updates point, normal and gap of a contact to where its bodies are now. A corner keeps its edge;
// for the ball, the nearest edge or corner is determined again.
void refresh_contact(const StaticWorld& world, std::span<const BodyState> bodies, const Pair& pair,
                     ContactPoint& contact);

// Returns the gap of a contact where its bodies are now, m: the signed distance of its point from
// its edge's line. A corner beside the edge's end can lie behind the line without penetrating. So
// if this distance is below -`trusted_depth`, m, the result is the larger of the distance and
// the pair's gap.
double clamped_gap(const StaticWorld& world, std::span<const BodyState> bodies,
                   const Contact& contact, double trusted_depth);

// Returns the first time, from t to the earlier end of the pair's two segments, at which the pair's
// gap is `level`, m, or less; trajectory::never if there is none. A level of 0 finds the touch of
// separated bodies; a negative level finds an overlap of that depth. `segments` has one segment per
// body, and all of them must hold at t.
double first_time_below(const StaticWorld& world, const Pair& pair, double level,
                        std::span<const trajectory::Segment> segments, double t);

// Returns the first time, from t to the earlier end of the pair's two segments, at which the pair
// touches, or trajectory::never. If the pair touches at t already, returns the first time at which
// its bodies have come closer by `penetration`, m. `reference` is that of robots at t, if known.
double contact_time(const StaticWorld& world, const Pair& pair,
                    std::span<const trajectory::Segment> segments, double t, double penetration,
                    const std::optional<geometry::Reference>& reference = {});

}  // namespace mirocup::simulator::collision
