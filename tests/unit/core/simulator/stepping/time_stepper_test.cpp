// SPDX-License-Identifier: MIT
//
// What a step promises: no overlap at its end, and none between its ends.
#include "core/simulator/stepping/time_stepper.hpp"

#include "core/base/math.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

namespace mirocup::simulator::stepping {
namespace {

// Two robots on a floor without walls, and steps of both.
struct TwoRobots {
  Parameters p;
  collision::StaticWorld world = collision::make_static_world(nullptr, p, Tolerances{}, 2, false);
  solver::RegularizedQp problem;
  TimeStepper steps{world, problem};
  std::array<BodyState, 2> bodies{};

  // Both have this command, or are lifted.
  void step(const WheelCommand& command, double length) {
    const trajectory::DriveReference drive = trajectory::drive_reference(p, command);
    const solver::InverseMass mass = command ? world.grounded_robot : world.free_robot;
    const auto taken = steps.take_step(BodySet(3), {}, std::array{drive, drive},
                                       std::array{mass, mass}, length, bodies);
    ASSERT_EQ(taken.members, BodySet(3));
    EXPECT_EQ(taken.length, length);
  }

  // After a step: their gap is checked all along it.
  void expect_apart(double length) const {
    for (int part = 0; part <= 1000; ++part) {
      const double t = length * part / 1000.0;
      const BodyState a = along_corrected_arc(bodies[0], steps.correction(0), length, t);
      const BodyState b = along_corrected_arc(bodies[1], steps.correction(1), length, t);
      ASSERT_GT(gap(world, pair_of(0, 1), b, a), -1e-6) << "after " << t << " s";
    }
  }
};

// Robots on their corners, one moving past the other at 1 m/s, from `before` metres before it, so
// that the corners would pass 0.05 mm deep through each other. Catches a step that checks its ends
// only, where they are apart. At the end of the other one, a corner is just past the other and a
// hair inside: by the edge that is nearest there it would be pushed on. Catches a step that tests
// only contacts which do not press.
TEST(TimeStepper, PassingCornersNeitherTunnelNorAreTheyPushedOutOnTheOtherSide) {
  const double length = Tolerances{}.max_step;
  for (const double before : {0.55 * length, length - 2e-5}) {
    for (const double side : {1.0, -1.0}) {
      TwoRobots two;
      const double reach = two.world.robot_outline.radius;
      two.bodies = {BodyState{{0.0, 0.0}, Heading::from_angle(pi / 4.0), {}},
                    BodyState{{side * (2.0 * reach - 5e-5), -side * before},
                              Heading::from_angle(pi / 4.0),
                              {side * std::sqrt(0.5), side * std::sqrt(0.5), 0.0}}};
      two.step(std::nullopt, length);
      two.expect_apart(length);
    }
  }
}

// Two robots in touch turn as they roll, and a mirror image that rounding lets slide at 1e-17 m/s
// does the same. Catches one whose frame turns away from its velocity: a ten thousandth slower
// after a step.
TEST(TimeStepper, LateralSpeedOfRoundingCountsAsRolling) {
  const auto speed = [](double left) {
    TwoRobots two;
    two.bodies = {BodyState{{0.0, 0.0}, Heading{}, {0.3, left, 5.0}},
                  BodyState{{two.p.robot_side, 0.01}, Heading{}, {0.3, 0.0, 5.0}}};
    two.step(WheelSpeeds{10.0, 14.0}, 2e-3);
    return two.bodies[0].twist.forward;
  };
  EXPECT_NEAR(speed(1e-17), speed(0.0), 1e-12);
}

// A robot between two walls that stop it from turning within next to no time, and nothing to
// press it afterwards. Catches a step that begins with the force of the one before, however long
// it is itself: forces of which bodies feel nothing stay, and would drive them apart where they
// can move.
TEST(TimeStepper, LongStepDoesNotStartWithTheForceOfAShortStop) {
  const field::Field field = field::make_field(RobotLeague::small);
  Parameters p;
  p.robot_side = 2.0 * field.half_width;
  p.robot_corners = {};
  const collision::StaticWorld world =
      collision::make_static_world(&field, p, Tolerances{}, 1, false);
  solver::RegularizedQp problem;
  TimeStepper steps(world, problem);
  std::array<BodyState, 1> bodies{BodyState{{0.0, 0.0}, Heading{}, {0.0, 0.0, 0.01}}};
  const std::array<trajectory::DriveReference, 1> lifted{
      trajectory::drive_reference(p, std::nullopt)};
  const std::array<solver::InverseMass, 1> mass{world.free_robot};
  const auto impulse_of_step = [&](double length) {
    EXPECT_EQ(steps.take_step(BodySet(1), {}, lifted, mass, length, bodies).members, BodySet(1));
    bodies[0] = steps.end(0);
    double sum = 0.0;
    for (const collision::Contact& c : steps.pressing()) sum += c.impact.impulse;
    return sum;
  };
  const double stopped = impulse_of_step(1e-7);
  EXPECT_GT(stopped, 1e-5);
  EXPECT_LT(impulse_of_step(1e-3), 1.01 * stopped);
  EXPECT_LT(std::abs(bodies[0].twist.omega), 1e-6);
}

// A robot spins with a corner on another's side: it touches at both ends of a step and would be
// 10 µm inside between, where a body from outside may collide with it. Catches arcs without a
// correction or with the wrong sign, and steps that are shortened instead.
TEST(TimeStepper, TurningRobotsDoNotOverlapInsideAStep) {
  for (const double side : {1.0, -1.0}) {
    TwoRobots two;
    const double reach = 0.5 * two.p.robot_side + two.world.robot_outline.radius;
    const double out = side > 0.0 ? 0.0 : pi;
    two.bodies = {
        BodyState{{0.0, 0.0}, Heading::from_angle(out), {}},
        BodyState{{side * reach, 0.0}, Heading::from_angle(out + pi / 4.0), {-0.2, 0.2, 20.0}}};
    two.step(std::nullopt, 2e-3);
    EXPECT_GT(two.steps.correction(1).norm(), 1e-6);
    two.expect_apart(2e-3);
  }
}

// What is left of a tick may be next to nothing, and two robots that overlap by a hair must not be
// thrown apart within it. Catches a step that undoes all overlap at once: 0.3 m/s here.
TEST(TimeStepper, ShortStepDoesNotTurnOverlapIntoSpeed) {
  for (const double overlap : {1e-12, -1e-12, 5e-7, -5e-7}) {
    TwoRobots two;
    const double side = overlap > 0.0 ? 1.0 : -1.0;
    two.bodies[1].position = {side * two.p.robot_side - overlap, 0.01};
    two.step(WheelSpeeds{}, 3e-12);
    for (const BodyState& body : two.bodies) EXPECT_LT(std::abs(body.twist.forward), 1e-3);
  }
}

}  // namespace
}  // namespace mirocup::simulator::stepping
