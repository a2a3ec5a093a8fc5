// SPDX-License-Identifier: MIT
#include "labs/pitch/identify.hpp"

#include "labs/pitch/validate.hpp"
#include "labs/tests/support/driven_pitch.hpp"
#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mirocup::pitch {
namespace {

// Catches an identification that is off by more than its intervals say, or whose intervals are too
// wide to be of use: build/identify_bars has 200 pitches.
TEST(Identify, FindsThePitchOfARecording) {
  test_support::DrivenPitch driven;
  driven.truth = test_support::random_pitch(6);
  driven.seconds = 20.0;
  const auto found = identify({test_support::recording_of(driven)}, {});
  ASSERT_TRUE(test_support::is_ok(found));
  for (const int u : {0, 1, 2}) {
    ASSERT_TRUE(found->known[u]) << unknowns()[u].name;
    const Estimate& e = *found->known[u];
    Guess plain = driven.truth;
    const double truth = std::exp(value_of(plain, u));
    EXPECT_NEAR(e.value, truth, 1.5 * (e.high - e.low)) << unknowns()[u].name;
    EXPECT_LT(e.high - e.low, 0.2 * truth) << unknowns()[u].name;
  }
  EXPECT_NEAR(found->position_noise.value, 0.002, 0.0003);
}

// Catches a number that the recording does not carry: of a ball that touches nothing.
TEST(Identify, SaysWhatARecordingDoesNotTell) {
  CameraLog recording;
  recording.path = "roll";
  recording.robots = 1;
  const double a = 0.2;  // m/s^2
  for (int i = 0; i < 90; ++i) {
    const double t = i / 60.0;
    Frame frame;
    frame.t = t;
    frame.ball = Vec2{-0.6 + 0.8 * t - 0.5 * a * t * t, 0.1};
    for (auto& team : frame.robots) team.resize(1);
    recording.frames.push_back(frame);
  }
  look_through({.position = 0.001, .heading = 0.0, .gaps = 0.0, .outliers = 0.0, .seed = 3},
               recording);
  const auto found = identify({recording}, {});
  ASSERT_TRUE(test_support::is_ok(found));
  EXPECT_FALSE(found->known[8]);
  EXPECT_EQ(found->why_not[8], "the recordings need a ball that hits a wall");
  EXPECT_FALSE(found->known[0]);
  ASSERT_TRUE(found->has_deceleration);
  EXPECT_NEAR(found->deceleration.value, a, 0.02);
}

// Catches restitutions of walls that nothing hits: two robots and no wall.
TEST(Identify, SaysNothingOfWallsThatNothingHits) {
  simulator::World world(nullptr, {}, simulator::Tolerances{}, 2, false);
  world.set_robot(0, {{-0.3, 0.0}, Heading{}, {}});
  world.set_robot(1, {{0.3, 0.0}, Heading::from_angle(1.0), {}});
  CameraLog recording;
  recording.path = "middle";
  recording.robots = 1;
  recording.period = 1.0 / 60.0;
  for (int i = 0; i < 600; ++i) {
    // Each quarter of a second something else, and back.
    constexpr std::array<simulator::WheelSpeeds, 6> kinds{
        {{40.0, 40.0}, {-40.0, -40.0}, {25.0, -25.0}, {0.0, 0.0}, {-25.0, 25.0}, {0.0, 0.0}}};
    const simulator::WheelSpeeds wheels = kinds[static_cast<std::size_t>(i / 15) % kinds.size()];
    Frame frame;
    frame.t = i / 60.0;
    for (int body = 0; body < 2; ++body) {
      const simulator::BodyState robot = world.robot(body);
      frame.robots[body].push_back(SeenPose{robot.position, robot.heading.angle()});
      frame.commands[body].push_back(wheels);
    }
    recording.frames.push_back(frame);
    const std::array<simulator::WheelCommand, 2> commands{wheels, wheels};
    world.advance(commands, 1.0 / 60.0);
  }
  look_through({.seed = 3}, recording);
  const auto found = identify({recording}, {});
  ASSERT_TRUE(test_support::is_ok(found));
  ASSERT_TRUE(found->known[0]);
  EXPECT_NEAR(found->known[0]->value, 0.0225, 0.001);
  for (const int u : {ball_on_wall, ball_on_robot, robot_on_wall, robot_on_robot}) {
    EXPECT_FALSE(found->known[u]) << unknowns()[u].name;
  }
  EXPECT_EQ(found->why_not[robot_on_wall], "the recordings need a robot that hits a wall");
}

// Catches a validation that cannot fail: of a pitch that is wrong.
TEST(Validate, SaysWhereTheSimulatorIsWorseThanGoingStraightOn) {
  test_support::DrivenPitch driven;
  driven.seconds = 25.0;
  const CameraLog recording = test_support::recording_of(driven);
  const Validation right = validate({recording}, driven.truth);
  const ErrorCell& drives = right.cells[static_cast<std::size_t>(EventKind::drive)][4];
  ASSERT_GT(drives.count, 20);
  EXPECT_LT(drives.rms[0], 0.5 * drives.rms[1]);
  Guess wrong = driven.truth;
  wrong.parameters.wheel_radius *= 3.0;
  EXPECT_FALSE(validate({recording}, wrong).objections.empty());
}

// Catches a yardstick that is not compared: another engine that knows where everything goes.
TEST(Validate, SaysWhereAnotherEngineIsBetter) {
  test_support::DrivenPitch driven;
  driven.seconds = 25.0;
  const CameraLog recording = test_support::recording_of(driven);
  const Peer peer{"oracle",
                  [](const CameraLog&, const Footage& footage, const Guess&, const Window& window,
                     const std::vector<simulator::BodyState>& start, const Peer::See& see) {
                    std::vector<Vec2> at;
                    for (const simulator::BodyState& s : start) at.push_back(s.position);
                    for (int f = window.first + 1; f <= window.last; ++f) {
                      for (std::size_t i = 0; i < at.size(); ++i) {
                        const Footage::Sight& seen = footage.sight(window.bodies[i], f);
                        if (seen.is_seen) at[i] = seen.position;
                        see(f, i, at[i]);
                      }
                    }
                  }};
  Guess wrong = driven.truth;
  wrong.parameters.wheel_radius *= 1.5;
  const Validation found = validate({recording}, wrong, &peer);
  EXPECT_EQ(found.peer, "oracle");
  const ErrorCell& drives = found.cells[static_cast<std::size_t>(EventKind::drive)][4];
  EXPECT_TRUE(drives.beats_simulator[static_cast<std::size_t>(Predictor::peer)]);
  EXPECT_TRUE(std::any_of(
      found.objections.begin(), found.objections.end(),
      [](const std::string& o) { return o.find("worse than oracle") != std::string::npos; }));
}

}  // namespace
}  // namespace mirocup::pitch
