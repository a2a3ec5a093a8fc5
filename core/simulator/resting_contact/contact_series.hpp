// SPDX-License-Identifier: MIT
//
// A contact that lasts, as power series: its Jacobian rows, its force, and whether it is still on
// its edge.
//
// Seen from the body with the edge, the edge's normal is constant, and the touching point, whose
// distance from the edge is constant too, moves along it. So a contact on an edge needs how the two
// bodies are turned towards each other and where on the edge the point is; all else is linear in
// these. Where the ball presses on a corner, the normal turns for both.
//
// The terms come in this order: start_rows(); then for k = 0, 1, ... extend_rows(k), the twists'
// terms k + 1 without the contact's force term k, gap_rate_term(k + 1), the force term k, and the
// twists' terms k + 1 completed with it.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"

#include <array>
#include <span>

namespace mirocup::simulator::resting_contact {

// Two series that are multiplied by the same others.
struct TwoSeries {
  std::array<std::array<double, 2>, trajectory::max_terms> c;
};

struct ContactSeries {
  // Terms 0 of the rows: rate of the gap = row_a . twist of a - row_b . twist of b.
  solver::JacobianRow first_a{}, first_b{};
  trajectory::Series force;  // N, along the normal

  // On an edge. Frames: the field's for a side that is a wall, and for the ball.
  Vec2 point;         // touching, in the frame of the point's side
  Vec2 normal;        // in the frame of the edge's side
  double distance;    // m, of the touching point from the edge's side's reference point along it
  TwoSeries heading;  // cos and sin: of the point's side seen from the edge's
  trajectory::Series omega;  // rad/s, of the same
  TwoSeries velocity;        // m/s, of the touching point in its own frame
  Vec2
      later_velocity;  // m/s, the newest term of it in the edge's frame, without what heading[0] gives
  trajectory::Series lever_b;   // m: third component of row_b, minus the way along the edge
  double edge_begin, edge_end;  // m along the edge

  // The ball on a corner.
  std::array<trajectory::Series, 3> row_a, row_b;
  std::array<trajectory::Series, 2>
      inside;                 // positive while the corner is what the ball is nearest to
  trajectory::Series x, y;    // of the ball in the frame of the corner's side
  trajectory::Series dx, dy;  // the same position in the field's frame
};

void start_rows(const collision::StaticWorld& world, const collision::Contact& contact,
                std::span<const trajectory::Segment> segments, ContactSeries& rows);

// Terms k + 1 of the geometry, from terms up to k of the twists and, for a corner, k + 1 of the
// poses.
void extend_rows(const collision::StaticWorld& world, const collision::Contact& contact,
                 std::span<const trajectory::Segment> segments, int k, ContactSeries& rows);

// Term k of the rate of the contact's gap.
double gap_rate_term(const collision::Contact& contact,
                     std::span<const trajectory::Segment> segments, int k, ContactSeries& rows);

// Term k of row times force, without the product of the first term of the row.
solver::ConstraintRow later_force_term(const collision::Contact& contact, const ContactSeries& rows,
                                       int k);

// When the point has left the edge, or the ball the corner, by `margin`; at most `length`. Where it
// was out there at the begin it may stay.
double time_on_edge(const collision::Contact& contact, const ContactSeries& rows, double margin,
                    double length);

// Says how many terms the series have.
void set_terms(ContactSeries& rows, int terms);

}  // namespace mirocup::simulator::resting_contact
