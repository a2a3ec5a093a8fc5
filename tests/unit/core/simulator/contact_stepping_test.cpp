// SPDX-License-Identifier: MIT
//
// What a small step promises: its end fits, and so does the way there.
#include "core/simulator/contact_stepping.hpp"

#include "core/base/math.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

namespace mirocup::simulator {
namespace {

// Two robots on their corners, one on its way past the other, so that the corners, apart at both ends
// of a step, would pass 0.05 mm deep through each other. Catches a step that only looks at its ends.
TEST(ContactStepping, CornersDoNotPassThroughEachOther) {
  const Parameters p;
  const Arena arena = make_arena(nullptr, p, Tolerances{}, 2, false);
  SoftProblem problem;
  ContactStepping steps(arena, problem);
  const double reach = arena.robot_shape.radius;
  const double step = arena.tolerances.step;
  std::array<Body, 2> bodies;
  for (const bool turned : {false, true}) {
    const double side = turned ? -1.0 : 1.0;
    bodies[0] = {{0.0, 0.0}, Heading::from_angle(pi / 4.0), {}};
    bodies[1] = {{side * (2.0 * reach - 5e-5), -side * 0.55 * step},
                 Heading::from_angle(pi / 4.0),
                 {side * std::sqrt(0.5), side * std::sqrt(0.5), 0.0}};
    const std::array<Drive, 2> lifted{drive_of(p, std::nullopt), drive_of(p, std::nullopt)};
    const std::array<InverseMass, 2> mass{arena.free_robot, arena.free_robot};
    BodySet both;
    both.set(0).set(1);
    const auto [members, length] = steps.take(both, {}, lifted, mass, step, bodies);
    ASSERT_EQ(members, both);
    for (int part = 0; part <= 1000; ++part) {
      const double t = length * part / 1000.0;
      const Body a = along_bent_arc(bodies[0], steps.bend(0), length, t);
      const Body b = along_bent_arc(bodies[1], steps.bend(1), length, t);
      ASSERT_GT(gap(arena, pair_of(0, 1), b, a), -1e-6) << "after " << t << " s";
    }
  }
}

// A robot spins with a corner on another's side: it touches at both ends of a step and would be 10 µm
// inside between, where somebody may run into it. Catches arcs that are not bent, or the wrong way, and
// steps that are short instead.
TEST(ContactStepping, TurningRobotsStayTogetherWithinAStep) {
  const Parameters p;
  const Arena arena = make_arena(nullptr, p, Tolerances{}, 2, false);
  SoftProblem problem;
  ContactStepping steps(arena, problem);
  std::array<Body, 2> bodies;
  for (const double side : {1.0, -1.0}) {
    const double reach = 0.5 * p.robot_side + arena.robot_shape.radius;
    const double out = side > 0.0 ? 0.0 : pi;
    bodies[0] = {{0.0, 0.0}, Heading::from_angle(out), {}};
    bodies[1] = {{side * reach, 0.0}, Heading::from_angle(out + pi / 4.0), {-0.2, 0.2, 20.0}};
    const std::array<Drive, 2> lifted{drive_of(p, std::nullopt), drive_of(p, std::nullopt)};
    const std::array<InverseMass, 2> mass{arena.free_robot, arena.free_robot};
    const auto [members, length] = steps.take(BodySet(3), {}, lifted, mass, 2e-3, bodies);
    ASSERT_EQ(members, BodySet(3));
    EXPECT_EQ(length, 2e-3);
    EXPECT_GT(steps.bend(1).norm(), 1e-6);
    for (int part = 0; part <= 20; ++part) {
      const double t = length * part / 20.0;
      const Body a = along_bent_arc(bodies[0], steps.bend(0), length, t);
      const Body b = along_bent_arc(bodies[1], steps.bend(1), length, t);
      EXPECT_GT(gap(arena, pair_of(0, 1), b, a), -1e-6) << t << " s";
    }
  }
}

// What is left of a tick may be next to nothing, and two robots that overlap by a hair must not be
// thrown apart within it. Catches a step that undoes all overlap at once: 0.3 m/s here.
TEST(ContactStepping, ShortStepsDoNotThrowApart) {
  const Parameters p;
  const Arena arena = make_arena(nullptr, p, Tolerances{}, 2, false);
  SoftProblem problem;
  ContactStepping steps(arena, problem);
  for (const double overlap : {1e-12, -1e-12, 5e-7, -5e-7}) {
    const double side = overlap > 0.0 ? 1.0 : -1.0;
    std::array<Body, 2> bodies{Body{}, Body{{side * p.robot_side - overlap, 0.01}, Heading{}, {}}};
    const std::array<Drive, 2> drives{drive_of(p, WheelSpeeds{}), drive_of(p, WheelSpeeds{})};
    const std::array<InverseMass, 2> mass{arena.grounded_robot, arena.grounded_robot};
    const auto [members, length] = steps.take(BodySet(3), {}, drives, mass, 3e-12, bodies);
    ASSERT_EQ(members, BodySet(3));
    EXPECT_EQ(length, 3e-12);
    for (const Body& body : bodies) EXPECT_LT(std::abs(body.twist.forward), 1e-3);
  }
}

// The ball rolls round a robot's corner: the contact is looked at again on the other side. Catches a
// ball that is still held off the corner when the edge is nearer.
TEST(Arena, LooksAgainRoundACorner) {
  const Arena arena = make_arena(nullptr, Parameters{}, Tolerances{}, 1, true);
  const double half = 0.5 * arena.parameters.robot_side;
  const double radius = arena.parameters.ball_radius;
  std::array<Body, 2> bodies{Body{{0.0, 0.0}, Heading{}, {}}, Body{}};
  const Pair pair = pair_of(1, 0);
  for (const double end : {1.0, -1.0}) {
    bodies[1].position = {end * (half + 0.6 * radius), end * (half + 0.8 * radius)};
    ContactList list;
    add_contacts(arena, pair, bodies, 1e-3, list);
    ASSERT_EQ(list.count, 1);
    ASSERT_EQ(list.list[0].at.kind, Touching::circle_on_corner);
    bodies[1].position = {end * (half - 0.001), end * (half + radius - 1e-6)};
    look_again(arena, bodies, pair, list.list[0].at);
    EXPECT_EQ(list.list[0].at.kind, Touching::circle_on_edge);
    EXPECT_NEAR(list.list[0].at.gap, -1e-6, 1e-15);
  }
}

}  // namespace
}  // namespace mirocup::simulator
