// SPDX-License-Identifier: MIT
//
// A resting contact as power series: its constraint row, its force, and its place on the edge.
//
// Seen from the body with the edge, the edge's normal is constant, and the contact point moves in
// parallel to the edge. So a contact on an edge needs two series: the heading of one body relative
// to the other, and the place of the point along the edge. Everything else is linear in these two.
// Where the ball presses on a corner, the normal turns for both bodies, and the rows themselves are
// series.
//
// Order of the calls for each contact, in which every term needs the ones before:
//   1. start_rows(): terms 0, from poses.
//   2. For k = 0, 1, ...: extend_rows(k); the caller computes the twists' terms k + 1 without
//      term k of the force; gap_rate_term(k + 1); the caller solves for term k of the force and
//      adds it to the twists' terms k + 1.
//
// Uses collision/, solver/, trajectory/ and model/. Units: m, s, rad, N; series count from the
// begin of the segments. Threads: none.
#pragma once

#include "core/simulator/collision/collision_queries.hpp"

#include <array>
#include <span>

namespace mirocup::simulator::resting_contact {

// Two series that a third one multiplies, such as the cosine and the sine of a heading.
struct TwoSeries {
  std::array<std::array<double, 2>, trajectory::max_terms> c;
};

struct ContactSeries {
  const trajectory::Segment *a, *b;  // the motions of the two sides; null: an obstacle
  // Terms 0 of the rows: rate of the gap = row_a . twist of a - row_b . twist of b.
  solver::JacobianRow first_a{}, first_b{};
  trajectory::Series force;  // N, along the normal

  // Used if a point touches an edge. A wall and the ball have the frame of the field.
  Vec2 point;                  // m: contact point, in the frame of the point's side
  Vec2 normal;                 // unit, in the frame of the edge's side
  Vec2 push;                   // force per N along the normal, with friction; frame of edge's side
  double distance;             // m: of the edge's line from the reference point of the edge's side
  TwoSeries heading;           // cos and sin of the point's side, seen from the edge's side
  trajectory::Series omega;    // rad/s: turn rate of `heading`
  TwoSeries velocity;          // m/s: of the contact point, in the frame of the point's side
  trajectory::Series lever_b;  // m: third component of row_b = -(place along the edge)
  // By the last extend_rows(k), what terms of `heading` and lever_b from 1 on contribute: to term
  // k + 1 of the point's velocity in the frame of the edge's side, m/s, to term k of heading *
  // force, N, and to term k of lever_b * force, N m.
  Vec2 later_velocity, later_force;
  double later_lever_b;
  double edge_begin, edge_end;  // m: places of the edge's ends along the edge

  // Used if the ball touches a corner.
  std::array<trajectory::Series, 3> row_a, row_b;
  std::array<trajectory::Series, 2> inside;  // positive while the ball is in the corner's sector
  trajectory::Series x, y;                   // m: of the ball, in the frame of the corner's side
  trajectory::Series dx, dy;  // m: from that side's reference point to the ball, field's frame
};

// Sets the first term (term 0) of each series of `rows`, from the first terms of the bodies' poses.
void start_rows(const collision::StaticWorld& world, const collision::Contact& contact,
                std::span<const trajectory::Segment> segments, ContactSeries& rows);

// Sets term k + 1 of each series of `rows`. It needs the terms up to k of the bodies' twists, and
// for a corner also term k + 1 of their poses.
void extend_rows(const collision::StaticWorld& world, const collision::Contact& contact, int k,
                 ContactSeries& rows);

// Returns term k of the rate of the contact's gap, from the twists' terms up to k.
double gap_rate_term(const collision::Contact& contact, int k, ContactSeries& rows);

// Returns term k of the speed, m/s, at which the point slides along the edge, from the twists'
// terms up to k. Call after gap_rate_term(k). Not for the ball on a corner.
double slide_term(const ContactSeries& rows, int k);

// Returns the row along which the contact's force acts at the start: its row with friction added.
solver::ConstraintRow first_push(const collision::Contact& contact, const ContactSeries& rows);

// Returns term k of the series row * force, less (term 0 of the row) * (term k of the force). Call
// after extend_rows(k).
struct RowTerms {
  solver::JacobianRow a, b;  // of row_a and of row_b
};
RowTerms later_force_term(const collision::Contact& contact, const ContactSeries& rows, int k);

// Returns when the point has left the edge, or the ball the corner's sector, by `margin` (m, or
// a sine): s after the start, at most `length`. A point or ball that is already that far outside at
// the start is not reported.
double time_on_edge(const collision::Contact& contact, const ContactSeries& rows, double margin,
                    double length);

// Returns when the point, which slides against its friction, comes to rest on the edge: s after the
// start, at most `length`. A slide that is slower than `slow` (m/s) at the start has just begun, so
// its zero speed there does not count.
double time_of_rest(const collision::Contact& contact, const ContactSeries& rows, double slow,
                    double length);

// Sets the number of terms of those series that are searched for roots. The force is known to the
// last term but one: its last term becomes zero.
void set_terms(ContactSeries& rows, int terms);

}  // namespace mirocup::simulator::resting_contact
