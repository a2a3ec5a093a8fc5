// SPDX-License-Identifier: MIT
#include "core/simulator/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::simulator {
namespace {

const Tolerances standard = tolerances_of(Accuracy::standard);

Scene ball_scene(const Vec2& position, const Vec2& velocity, double duration) {
  Scene scene;
  scene.ball = BallState{position, velocity};
  scene.duration = duration;
  return scene;
}

SceneRobot robot_at(double x, double y, double angle, double wheels) {
  SceneRobot robot;
  robot.state.position = {x, y};
  robot.state.heading = Heading::from_angle(angle);
  robot.wheels = {{0.0, {wheels, wheels}}};
  return robot;
}

// The paper's (8) and (9), one axis: linear resistance below k, constant above.
double per_axis_speed(const Parameters& p, double v, double t) {
  const double constant = p.rolling_resistance * p.ball_mass * gravity / p.effective_ball_mass();
  const double linear = p.viscous_friction / p.effective_ball_mass();
  const double slow =
      std::log((linear * v + constant) / (linear * p.k + constant)) / linear;  // v reaches k
  if (t < slow) return (v + constant / linear) * std::exp(-linear * t) - constant / linear;
  return p.k * std::exp(-(linear + constant / p.k) * (t - slow));
}

// Catches a ball that brakes along its direction, and one that forgets (9) below k.
TEST(Scene, BallBrakesEachAxisByItselfWithPerAxisFriction) {
  Scene scene = ball_scene({0.0, 0.0}, {0.05, 0.5}, 2.0);
  scene.has_walls = false;
  scene.parameters.rolling_friction = RollingFriction::per_axis;
  scene.parameters.k = 0.01;
  scene.sample_at = {0.1, 0.7, 1.3};
  for (const Sample& s : run_scene(scene, standard).samples) {
    if (s.time == 0.0) continue;
    EXPECT_NEAR(s.ball->velocity.x(), per_axis_speed(scene.parameters, 0.05, s.time), 1e-12);
    EXPECT_NEAR(s.ball->velocity.y(), per_axis_speed(scene.parameters, 0.5, s.time), 1e-12);
  }
}

// Catches a ball that waits at the speed k, in event after event.
TEST(Scene, BallIsPushedThroughTheSlowSpeedOfOneAxis) {
  Scene scene = ball_scene({0.06, 0.0}, {0.0, 0.0}, 1.0);
  scene.has_walls = false;
  scene.parameters.rolling_friction = RollingFriction::per_axis;
  scene.robots = {robot_at(0.0, 0.0, 0.0, 20.0)};
  const SceneResult result = run_scene(scene, standard);
  EXPECT_NEAR(result.samples.back().ball->velocity.x(), 0.45, 0.01);
  EXPECT_LT(result.statistics.position_evaluations, 1000);
}

// A ball at 45 degrees against the side: the normal part turns by restitution, the other loses the
// coefficient times the normal impulse. Catches a bound without the restitution's share, and
// friction that pushes the ball along or back.
TEST(Scene, WallFrictionFollowsCoulombsLaw) {
  for (const double side : {1.0, -1.0}) {
    Scene scene = ball_scene({0.5, 0.0}, {1.0, side}, 0.4);
    scene.parameters.rolling_resistance = scene.parameters.viscous_friction = 0.0;
    const double e = scene.parameters.restitution.ball_wall;
    const auto velocity_after = [&](double friction) {
      scene.parameters.contact_friction.ball_wall = friction;
      return run_scene(scene, standard).samples.back().ball->velocity;
    };
    EXPECT_NEAR(velocity_after(0.2).x(), -e, 1e-14);
    EXPECT_NEAR(velocity_after(0.2).y(), side * (1.0 - 0.2 * (1.0 + e)), 1e-14);
    EXPECT_NEAR(velocity_after(10.0).y(), 0.0, 1e-14) << "more than enough to stop the sliding";
  }
}

// Two robots side by side, one pushes along the other's flank: with friction it drags it along.
TEST(Scene, RobotDragsAnotherAlongByFriction) {
  Scene scene;
  scene.has_walls = false;
  scene.duration = 0.5;
  SceneRobot pusher = robot_at(0.0, 0.0, 0.3, 30.0);
  SceneRobot pushed = robot_at(0.0, 0.085, 0.0, 0.0);
  pushed.wheels_on_ground = false;
  scene.robots = {pusher, pushed};
  const double smooth = run_scene(scene, standard).samples.back().robots[1].position.x();
  scene.parameters.contact_friction.robot_robot = 0.5;
  const double rough = run_scene(scene, standard).samples.back().robots[1].position.x();
  EXPECT_GT(rough, smooth + 0.005);
}

TEST(Scene, HexagonsMeetAtTheirSidesAndStay) {
  Scene scene;
  scene.has_walls = false;
  scene.duration = 1.0;
  geometry::OutlineCorners& hexagon = scene.parameters.robot_corners;
  hexagon.corners = 6;
  for (int i = 0; i < 6; ++i) {
    hexagon.x[i] = 0.04 * std::cos((i + 0.5) * std::acos(-1.0) / 3.0);
    hexagon.y[i] = 0.04 * std::sin((i + 0.5) * std::acos(-1.0) / 3.0);
  }
  // 5/12 M R^2 for a regular hexagon of radius R.
  EXPECT_NEAR(scene.parameters.robot_inertia(), 5.0 / 12.0 * 0.5 * 0.04 * 0.04, 1e-15);

  // Flat side on flat side, head-on: they meet where their sides do, and stay.
  scene.robots = {robot_at(-0.2, 0.0, 0.0, 40.0), robot_at(0.2, 0.0, 0.0, -40.0)};
  const SceneResult result = run_scene(scene, standard);
  const Sample& end = result.samples.back();
  const double apothem = 0.04 * std::sqrt(0.75);
  EXPECT_NEAR(end.robots[0].position.x(), -apothem, 1e-9);
  EXPECT_NEAR(end.robots[1].position.x(), apothem, 1e-9);
  EXPECT_LT(std::abs(end.robots[0].twist.forward), 1e-9);
  EXPECT_LT(result.statistics.deepest_overlap, 1e-9);
}

TEST(Scene, SampleAtTheTimeOfAnImpactIsTheStateAfterIt) {
  Scene scene = ball_scene({0.75 - 0.02135 - 0.25, 0.5}, {1.0, 0.0}, 1.0);
  scene.parameters.rolling_resistance = 0.0;
  scene.parameters.viscous_friction = 0.0;
  scene.sample_at = {0.25};
  const SceneResult result = run_scene(scene, standard);
  EXPECT_NEAR(result.samples[1].ball->velocity.x(), -0.8, 1e-14);
  ASSERT_EQ(result.statistics.impacts.size(), 1u);
  EXPECT_NEAR(result.statistics.impacts[0].time, 0.25, 1e-9);
  EXPECT_EQ(result.statistics.impacts[0].second, no_body);
  EXPECT_EQ(result.statistics.impacts[0].normal.x(), -1.0);
  EXPECT_NEAR(result.statistics.impacts[0].impulse, 1.8 * scene.parameters.effective_ball_mass(),
              1e-14);
}

// More samples change nothing but rounding: ticks of any length play the same scene.
TEST(Scene, MoreSamplesChangeOnlyRounding) {
  Scene scene = ball_scene({0.1, 0.05}, {-0.4, 0.2}, 0.6);
  scene.robots = {robot_at(-0.2, 0.0, 0.2, 50.0), robot_at(0.3, 0.1, 2.0, 30.0)};
  const Sample once = run_scene(scene, standard).samples.back();
  for (int i = 1; i < 600; ++i) scene.sample_at.push_back(i * 1e-3);
  const Sample often = run_scene(scene, standard).samples.back();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((once.robots[i].position - often.robots[i].position).norm(), 1e-9);
  }
  EXPECT_LT((once.ball->position - often.ball->position).norm(), 1e-9);
}

TEST(Scene, OverlapsAndBodiesOutsideTheFieldAreFound) {
  Scene scene = ball_scene({0.0, 0.0}, {0.0, 0.0}, 1.0);
  scene.robots = {robot_at(0.05, 0.0, 0.0, 0.0)};
  ASSERT_TRUE(find_overlap(scene));
  EXPECT_EQ(find_overlap(scene)->first, 1);
  EXPECT_EQ(find_overlap(scene)->second, 0);
  scene.robots = {robot_at(0.0375 + 0.02135, 0.0, 0.0, 0.0)};  // touches
  EXPECT_FALSE(find_overlap(scene));
  for (const Vec2& place : {Vec2{0.74, 0.4}, Vec2{5.0, 0.0}, Vec2{0.0, -0.65}, Vec2{0.84, 0.0}}) {
    scene.ball->position = place;
    ASSERT_TRUE(find_overlap(scene)) << place.x() << " " << place.y();
    EXPECT_EQ(find_overlap(scene)->second, no_body);
  }
  scene.has_walls = false;
  EXPECT_FALSE(find_overlap(scene));
}

// Six robots squeeze the ball: every level keeps its own bound, and they agree.
TEST(Scene, OverlapStaysBelowTheBoundOfEachAccuracy) {
  Scene scene = ball_scene({0.0, 0.0}, {0.0, 0.0}, 1.0);
  for (int i = 0; i < 6; ++i) {
    const double angle = i * std::acos(-1.0) / 3.0;
    scene.robots.push_back(robot_at(0.15 * std::cos(angle), 0.15 * std::sin(angle),
                                    angle + std::acos(-1.0) + 0.05 * i, 40.0 + 2.0 * i));
  }
  const auto overlap = [&](Accuracy a) {
    return run_scene(scene, tolerances_of(a)).statistics.deepest_overlap;
  };
  EXPECT_LT(overlap(Accuracy::coarse), 1e-6);
  EXPECT_LT(overlap(Accuracy::standard), 1e-9);
  EXPECT_LT(overlap(Accuracy::reference), 1e-9);
}

// Catches a sample that ends the run's tick: at every level, also in the middle of contacts.
TEST(Scene, LookingChangesNoBit) {
  Scene scene = ball_scene({0.0, 0.01}, {0.0, 0.0}, 0.3);
  for (int i = 0; i < 4; ++i) {
    const double angle = 1.5 * i + 0.1;
    scene.robots.push_back(
        robot_at(-0.09 * std::cos(angle), -0.09 * std::sin(angle), angle, 50.0 + 5.0 * i));
  }
  for (const Accuracy level : {Accuracy::coarse, Accuracy::standard, Accuracy::reference}) {
    scene.sample_at.clear();
    const SceneResult blind = run_scene(scene, tolerances_of(level));
    for (int i = 1; i < 90; ++i) scene.sample_at.push_back(0.0033 * i);
    const SceneResult watched = run_scene(scene, tolerances_of(level));
    ASSERT_EQ(watched.samples.size(), scene.sample_at.size() + 2);
    EXPECT_EQ(watched.statistics.impacts.size(), blind.statistics.impacts.size());
    EXPECT_GT(blind.statistics.impacts.size(), 3U);
    for (int i = 0; i < 4; ++i) {
      const BodyState& a = blind.samples.back().robots[i];
      const BodyState& b = watched.samples.back().robots[i];
      EXPECT_EQ(a.position, b.position);
      EXPECT_EQ(a.heading.cos, b.heading.cos);
      EXPECT_EQ(a.twist.forward, b.twist.forward);
      EXPECT_EQ(a.twist.omega, b.twist.omega);
    }
    EXPECT_EQ(blind.samples.back().ball->position, watched.samples.back().ball->position);
  }
}

}  // namespace
}  // namespace mirocup::simulator
