// SPDX-License-Identifier: MIT
//
// Worlds whose bodies in contact are time-stepped: which bodies share a step, and what happens
// when a step is interrupted. The steps themselves are tested without a world.
#include "core/simulator/world.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace mirocup::simulator {
namespace {

// No event budget: every body in contact is time-stepped.
Tolerances without_event_budget() {
  Tolerances tolerances;
  tolerances.event_budget = 0;
  return tolerances;
}

// Expects no two robots to overlap by more than this, m.
void expect_apart(const World& world, double most) {
  for (int i = 0; i < world.robots(); ++i) {
    for (int j = 0; j < i; ++j)
      EXPECT_GT(gap(world.static_world(), pair_of(i, j), world.robot(i), world.robot(j)), -most);
  }
}

// Six robots around the ball, each turned by that angle (rad) against the direction to it.
void set_around_ball(World& world, double distance, double turned) {
  for (int i = 0; i < 6; ++i) {
    const double angle = pi / 3.0 * i;
    const Heading inwards = Heading::from_angle(angle);
    world.set_robot(i, {-distance * inwards.forward(), Heading::from_angle(angle + turned), {}});
  }
  world.set_ball({});
}

// Returns commands with which six robots whirl; they change every ten ticks.
std::array<WheelCommand, 6> whirl(int tick) {
  std::array<WheelCommand, 6> commands;
  for (int i = 0; i < 6; ++i) {
    const double turn = 12.0 * ((tick / 10 + i) % 3 - 1);
    commands[i] = WheelSpeeds{30.0 - turn, 30.0 + turn};
  }
  return commands;
}

// Six robots whirl into each other around the ball. Catches a step that takes the gaps at its
// start for those at its end: corners turn into neighbours by micrometres.
TEST(World, TimeSteppedCrowdHasNoOverlaps) {
  const field::Field field = field::make_field(RobotLeague::small);
  World world(&field, Parameters{}, without_event_budget(), 6, true);
  set_around_ball(world, 0.12, 0.0);
  int stepped = 0;
  for (int tick = 0; tick < 60; ++tick) {
    stepped += world.advance(whirl(tick), 0.033).stepped;
    expect_apart(world, 1e-9);
  }
  EXPECT_GT(stepped, 50);
}

// Twenty-two robots side by side have more contacts within reach of a step than most crowds.
// Catches a contact list that is too short for them.
TEST(World, TimeSteppedCrowdOfAllRobotsHasNoOverlaps) {
  const field::Field field = field::make_field(RobotLeague::large);
  World world(&field, Parameters{}, without_event_budget(), max_robots, true);
  const double side = world.parameters().robot_side + 1e-4;
  const auto place = [&](int i) { return Vec2{side * (i % 5 - 2), side * (i / 5 - 2)}; };
  for (int i = 0; i < max_robots; ++i) world.set_robot(i, {place(i), Heading{}, {}});
  world.set_ball({{0.5, 0.5}, {0.0, 0.0}});
  for (int tick = 0; tick < 30; ++tick) {
    std::array<WheelCommand, max_robots> commands;
    for (int i = 0; i < max_robots; ++i) {
      const double forward = i % 5 < 2 ? 30.0 : -30.0;
      const double turn = 10.0 * ((tick / 5 + i) % 3 - 1);
      commands[i] = WheelSpeeds{forward - turn, forward + turn};
    }
    world.advance(commands, 0.033);
    expect_apart(world, 1e-6);
  }
}

// Scenes are sampled by ticks of duration zero. Catches a step that divides by it: states become
// NaN.
TEST(World, TickOfDurationZeroMovesNoSteppedBody) {
  World world(nullptr, Parameters{}, without_event_budget(), 6, true);
  set_around_ball(world, 0.09, 0.3);
  for (int tick = 0; tick < 20; ++tick) {
    world.advance(whirl(tick), 0.033);
    const BodyState before = world.robot(0);
    EXPECT_FALSE(world.advance(whirl(tick), 0.0).stepped);
    EXPECT_NEAR((world.robot(0).position - before.position).norm(), 0.0, 1e-9);
    EXPECT_TRUE(std::isfinite(world.robot(0).twist.omega));
  }
}

// Catches a step that starts from the remembered forces of bodies that have been set since.
TEST(World, BodiesThatAreSetPlayAsInANewWorld) {
  const field::Field field = field::make_field(RobotLeague::small);
  World used(&field, Parameters{}, without_event_budget(), 6, true);
  World fresh(&field, Parameters{}, without_event_budget(), 6, true);
  const auto play = [](World& world) {
    for (int tick = 0; tick < 20; ++tick) world.advance(whirl(tick), 0.033);
  };
  set_around_ball(used, 0.09, 0.3);
  play(used);
  set_around_ball(used, 0.09, 0.1);
  set_around_ball(fresh, 0.09, 0.1);
  play(used);
  play(fresh);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(used.robot(i).position.x(), fresh.robot(i).position.x());
    EXPECT_EQ(used.robot(i).position.y(), fresh.robot(i).position.y());
    EXPECT_EQ(used.robot(i).heading.sin, fresh.robot(i).heading.sin);
  }
}

// A robot shares steps with others and is alone later. Catches one that goes on as if it still
// were in their step: it passes through a wall.
TEST(World, RobotThatLeavesItsStepIslandStaysInsideTheWalls) {
  const field::Field field = field::make_field(RobotLeague::small);
  Tolerances tolerances;
  tolerances.event_budget = 1;
  World world(&field, Parameters{}, tolerances, 3, true);
  for (int i = 0; i < 3; ++i) {
    const Heading heading = Heading::from_angle(0.4 * (i - 1));
    world.set_robot(i, {{0.6 - 0.1 * i, 0.3 + 0.05 * i}, heading, {1.0, 0.0, 3.0 * (i - 1)}});
  }
  world.set_ball({{0.65, 0.2}, {0.0, 0.0}});
  for (int tick = 0; tick < 200; ++tick) {
    std::array<WheelCommand, 3> commands;
    for (int i = 0; i < 3; ++i) {
      const double turn = 30.0 * ((tick / 7 + 2 * i) % 5 - 2);
      commands[i] = WheelSpeeds{40.0 - turn, 40.0 + turn};
    }
    world.advance(commands, 0.033);
    for (int i = 0; i < 3; ++i) {
      const BodyState body = world.robot(i);
      for (int k = 0; k < plane_walls + end_walls; ++k) {
        EXPECT_GT(gap(world.static_world(), pair_with_obstacle(i, k), body, BodyState{}), -1e-9)
            << tick;
      }
    }
  }
}

// One robot pushes another, and a ball hits the first in the middle of their step. Catches a
// robot that keeps the motors' impulse of the whole step and gets the rest of it again: it is a
// tenth or more too fast. The share is taken as linear in time, which is up to 4 % off.
TEST(World, InterruptedStepGivesItsShareOfTheMotorImpulse) {
  Tolerances tolerances = without_event_budget();
  tolerances.max_step = 0.04;
  const Parameters p;
  const double radii = 0.5 * p.robot_side + p.ball_radius;
  const std::array<WheelCommand, 2> commands{WheelSpeeds{40.0, 40.0}, WheelSpeeds{40.0, 40.0}};
  const auto speed = [&](double ball_speed) {
    World world(nullptr, p, tolerances, 2, true);
    world.set_robot(0, {{0.0, 0.0}, Heading{}, {}});
    world.set_robot(1, {{p.robot_side, 0.0}, Heading{}, {}});
    world.set_ball({{p.robot_side, radii + 0.02}, {0.0, -ball_speed}});
    EXPECT_EQ(world.advance(commands, 0.033).impacts, ball_speed > 0.0 ? 1 : 0);
    return world.robot(0).twist.forward;
  };
  const double asked = p.speed_reference(40.0, 40.0);
  EXPECT_NEAR(speed(0.0), -expm1(-0.033 / p.motor_time_constant) * asked, 1e-12);
  for (const double ball_speed : {1.0, 2.0, 5.0}) {
    EXPECT_NEAR(speed(ball_speed), speed(0.0), 0.04 * asked) << ball_speed;
  }
}

// Two pairs push far from each other, and a ball hits one of them in the middle of a step. Catches
// one step for all islands: the other pair would be interrupted, too.
TEST(World, CollisionWithOneStepIslandLeavesOthersUnchanged) {
  const Parameters p;
  const double radii = 0.5 * p.robot_side + p.ball_radius;
  const auto far_pair = [&](double ball_speed) {
    World world(nullptr, p, without_event_budget(), 4, true);
    for (int i = 0; i < 4; ++i) {
      const Vec2 place{p.robot_side * (i % 2), i < 2 ? 0.0 : 1.0};
      world.set_robot(i, {place, Heading::from_angle(i % 2 == 0 ? 0.0 : 0.3), {}});
    }
    world.set_ball({{p.robot_side, -radii - 0.02}, {0.0, ball_speed}});
    const std::array<WheelCommand, 4> commands{WheelSpeeds{30.0, 35.0}, WheelSpeeds{-20.0, -10.0},
                                               WheelSpeeds{30.0, 35.0}, WheelSpeeds{-20.0, -10.0}};
    for (int tick = 0; tick < 3; ++tick) world.advance(commands, 0.033);
    EXPECT_EQ(world.ball().velocity.y() < 0.0, ball_speed > 0.0) << "the ball hits and comes back";
    return std::array<BodyState, 2>{world.robot(2), world.robot(3)};
  };
  const auto undisturbed = far_pair(0.0);
  const auto disturbed = far_pair(2.0);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(disturbed[i].position, undisturbed[i].position);
    EXPECT_EQ(disturbed[i].twist.omega, undisturbed[i].twist.omega);
  }
}

}  // namespace
}  // namespace mirocup::simulator
