// SPDX-License-Identifier: MIT
//
// Robots that press with one corner and turn towards the edge: when the other corner is down is a
// closed form.
#include "core/simulator/collision/next_contact.hpp"

#include "core/simulator/resting_contact/contact_series.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace mirocup::simulator::collision {
namespace {

// Robot 1 has one corner on the front of robot 0, which stands still at the origin; its edge is
// tilted against that front by `tilt` and turns at `rate` around the corner, which slides along the
// front at `slide`, m/s.
struct Tilted {
  StaticWorld world = make_static_world(nullptr, Parameters{}, Tolerances{}, 2, false);
  std::array<trajectory::Segment, 2> segments;
  Contact contact;

  Tilted(double tilt, double rate, double slide, double length) {
    const double half = world.parameters.robot_side / 2.0;
    segments[0] = trajectory::still_segment(BodyState{}, 0.0, length);
    // Corner 2 of a square is its left end behind, where its edge at the back begins.
    const geometry::Outline& shape = world.robot_outline;
    const Vec2 corner = shape.corner[2];
    const Heading heading = Heading::from_angle(tilt);
    const Vec2 touching{half, -0.01};
    BodyState body;
    body.heading = heading;
    body.position = touching - heading.to_world(corner);
    trajectory::Segment s = trajectory::moving_segment(body, 0.0, length);
    s.omega[0] = rate;
    // The centre's speed in its own frame: the corner's, minus what turning gives the corner.
    double cos = std::cos(tilt);
    double sin = std::sin(tilt);
    double factor = 1.0;
    for (int k = 0; k < trajectory::max_terms; ++k) {
      s.forward[k] = factor * slide * sin;
      s.left[k] = factor * slide * cos;
      const double turned_cos = -sin;  // derivatives of cos(tilt + rate t), sin(tilt + rate t)
      sin = cos;
      cos = turned_cos;
      factor *= rate / (k + 1);
    }
    s.forward[0] += rate * corner.y();
    s.left[0] -= rate * corner.x();
    for (int k = 0; k + 1 < trajectory::max_terms; ++k) integrate_pose(s, k);
    segments[1] = s;

    contact.pair = pair_of(0, 1);
    contact.a = 1;
    contact.b = 0;
    contact.point = {.point = touching,
                     .normal = {1.0, 0.0},
                     .gap = 0.0,
                     .kind = Touching::corner_on_edge,
                     .point_on_a = true,
                     .corner = 2,
                     .edge = 0};
    contact.row = solver::difference_row(contact.a, contact.b, contact_row(body, contact.point),
                                         contact_row(BodyState{}, contact.point));
    contact.resting = {.is_active = true, .is_persistent = true};
  }

  double next(bool others = false) const {
    return next_corner_contact(world, contact, others, segments, 1e-12);
  }
};

TEST(NextContact, FindsTheOtherCorner) {
  for (const double rate : {0.5, 4.0, 20.0}) {
    const Tilted down(0.02, -rate, 0.0, 0.05);
    ASSERT_TRUE(is_separating_edge(down.world, down.contact));
    EXPECT_NEAR(down.next(), 0.02 / rate < 0.05 ? 0.02 / rate : trajectory::never, 1e-9) << rate;
    EXPECT_EQ(Tilted(0.02, rate, 0.0, 0.01).next(), trajectory::never) << rate;
  }
}

TEST(NextContact, SlidingDoesNotChangeIt) {
  EXPECT_NEAR(Tilted(0.02, -4.0, 0.3, 0.02).next(), 0.005, 1e-9);
  EXPECT_EQ(Tilted(0.02, 0.0, 0.3, 0.02).next(), trajectory::never);
}

// With two contacts between the same two nothing turns: rounding must not be taken for a touch.
TEST(NextContact, FlushEdgesStayFlush) {
  EXPECT_EQ(Tilted(0.0, -1e-9, 0.0, 0.02).next(true), trajectory::never);
}

TEST(NextContact, OnlyPersistentContactsSeparate) {
  Tilted tilted(0.02, -4.0, 0.0, 0.02);
  tilted.contact.resting.is_persistent = false;
  EXPECT_FALSE(is_separating_edge(tilted.world, tilted.contact));
  tilted.contact.resting.is_active = false;
  EXPECT_FALSE(is_separating_edge(tilted.world, tilted.contact));
  // Tilted the other way, the corner that touches is at the end of the front: beside it the other
  // one is beyond the front's line already, and comes down on nothing.
  const Tilted off_diagonal(-0.02, -4.0, 0.0, 0.02);
  EXPECT_FALSE(is_separating_edge(off_diagonal.world, off_diagonal.contact));
}

// The rows of such a contact: the gap stays, the lever on the edge's side grows as the corner
// slides, the edge's normal turns in the robot's frame. Catches an edge whose ends are mixed up.
TEST(ContactSeries, FollowACornerAlongAnEdge) {
  constexpr double tilt = 0.02;
  constexpr double rate = -4.0;
  for (const double slide : {0.3, -0.3}) {
    const Tilted t(tilt, rate, slide, 0.02);
    resting_contact::ContactSeries rows;
    start_rows(t.world, t.contact, t.segments, rows);
    EXPECT_NEAR(rows.first_a[2], t.contact.row.on_a[2], 1e-15);
    EXPECT_NEAR(rows.first_b[2], -t.contact.row.on_b[2], 1e-15);
    double factor = 1.0;  // of term k of a function of the angle: its derivative times this
    for (int k = 0; k + 1 < trajectory::max_terms; ++k) {
      EXPECT_NEAR(rows.heading.c[k][0], factor * std::cos(tilt + k * pi / 2.0), 1e-12) << k;
      EXPECT_NEAR(rows.heading.c[k][1], factor * std::sin(tilt + k * pi / 2.0), 1e-12) << k;
      extend_rows(t.world, t.contact, k, rows);
      EXPECT_NEAR(rows.lever_b[k + 1], k == 0 ? -slide : 0.0, 1e-12) << k;
      EXPECT_NEAR(gap_rate_term(t.contact, k + 1, rows), 0.0, 1e-12) << k;
      factor *= rate / (k + 1);
    }
    set_terms(rows, trajectory::max_terms);
    // From y = -0.01 at 0.3 m/s to the end of the edge, upwards or downwards.
    EXPECT_EQ(time_on_edge(t.contact, rows, 0.0, 0.02), 0.02);
    const double path = t.world.parameters.robot_side / 2.0 + (slide > 0.0 ? 0.01 : -0.01);
    EXPECT_NEAR(time_on_edge(t.contact, rows, 0.0, 1.0), path / 0.3, 1e-12);
  }
}

}  // namespace
}  // namespace mirocup::simulator::collision
