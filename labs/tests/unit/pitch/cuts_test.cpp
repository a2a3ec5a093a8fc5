// SPDX-License-Identifier: MIT
#include "labs/pitch/cuts.hpp"

#include "labs/pitch/fit.hpp"
#include "labs/tests/support/driven_pitch.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace mirocup::pitch {
namespace {

// Two robots for 40 s, one of each team: bodies 0 and 1, and the ball.
CameraLog forty_seconds() {
  test_support::DrivenPitch driven;
  driven.truth = test_support::random_pitch(10);
  driven.seconds = 40.0;
  return test_support::recording_of(driven);
}

bool overlap(const Window& a, const Window& b) {
  const bool share = std::any_of(a.bodies.begin(), a.bodies.end(), [&](int body) {
    return std::find(b.bodies.begin(), b.bodies.end(), body) != b.bodies.end();
  });
  return share && a.first <= b.last && b.first <= a.last;
}

// Catches hits that are left out because wheels slide before them, which most do: then a minute
// tells no restitution of robots. And pictures that count twice.
TEST(Cuts, HitsHaveWindowsWhetherWheelsHoldOrSlide) {
  const CameraLog recording = forty_seconds();
  const Footage footage(recording);
  const std::vector<Window> meet = meetings(footage, {});
  EXPECT_GT(meet.size(), 8U);
  const auto slides =
      std::count_if(meet.begin(), meet.end(), [](const Window& w) { return w.may_slide; });
  EXPECT_GT(slides, 0);
  EXPECT_LT(slides, static_cast<std::ptrdiff_t>(meet.size()));
  for (const auto& windows : {meet, drives(footage, {})}) {
    for (std::size_t i = 0; i < windows.size(); ++i) {
      EXPECT_LT(windows[i].first, windows[i].last);
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(windows[i], windows[j]));
    }
  }
}

// Pictures of a robot that slides sideways at first.
CameraLog sliding_robot(const simulator::Parameters& parameters) {
  simulator::World world(nullptr, parameters, simulator::Tolerances{}, 1, false);
  world.set_robot(0, {{-0.3, 0.1}, Heading::from_angle(0.4), {0.5, 0.4, 1.0}});
  CameraLog recording;
  recording.path = "slide";
  recording.robots = 1;
  recording.period = 1.0 / 60.0;
  for (int i = 0; i < 30; ++i) {
    const simulator::BodyState robot = world.robot(0);
    Frame frame;
    frame.t = i / 60.0;
    for (auto& team : frame.robots) team.resize(1);
    frame.robots[0][0] = SeenPose{robot.position, robot.heading.angle()};
    for (auto& commands : frame.commands) commands.push_back({30.0, 30.0});
    recording.frames.push_back(frame);
    const std::array<simulator::WheelCommand, 1> wheels{simulator::WheelSpeeds{30.0, 30.0}};
    world.advance(wheels, 1.0 / 60.0);
  }
  look_through({.position = 0.0005, .heading = 0.005, .gaps = 0.0, .outliers = 0.0, .seed = 3},
               recording);
  return recording;
}

// Catches a sideways speed that is not searched, or that is taken for wheels that hold.
TEST(Fit, FindsTheSidewaysSpeedOfASlide) {
  Guess truth;
  truth.parameters.grip = 0.5;
  truth.parameters.turn_time_constant = truth.parameters.turn_lag();
  truth.parameters.brake_time_constant = truth.parameters.brake_lag();
  const CameraLog recording = sliding_robot(truth.parameters);
  const Footage footage(recording);
  double square[2];
  for (const bool may_slide : {false, true}) {
    Fit fit(truth, {0.0005, 0.005});
    fit.set_noise_known(true);
    fit.add(footage, {0, 29, {0}, may_slide});
    ASSERT_EQ(fit.pieces().size(), 1U);
    fit.retry();
    fit.run(true);
    const Piece& piece = fit.pieces().front();
    square[may_slide ? 1 : 0] = piece.square;
    if (!may_slide) continue;
    EXPECT_TRUE(piece.counts);
    EXPECT_NEAR(piece.start.front().twist.left, 0.4, 0.05);
  }
  EXPECT_GT(square[0], square[1] + 50.0);
}

}  // namespace
}  // namespace mirocup::pitch
