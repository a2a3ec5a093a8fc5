// SPDX-License-Identifier: MIT
//
// The example with a camera and a radio: a control program drives robots that no simulator knows.
#include "tests/programs/dds/network.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace mirocup {
namespace {

using namespace test_support;

// Catches states that differ from the camera's pictures, and commands that do not reach the radio:
// the team would not find the ball, or not push it towards the other goal. The pitch waits for each
// answer, so a busy machine does not change where the ball is.
TEST(PitchExample, IsDrivenByTheProgramThatPlaysAgainstTheSimulator) {
  const std::string id = match_id("pitch");
  const auto control_program = join(id, "blue", "remote", "chaser");

  Running on_the_pitch(control_program);
  const Outcome pitch =
      expect_exit(0, run({program("examples/pitch"), "--wait", id, "2", "remote"}));
  EXPECT_EQ(on_the_pitch.wait().exit_code, 0);
  std::istringstream said(pitch.out);
  std::string the, ball, is, at;
  double x = 0.0;
  said >> the >> ball >> is >> at >> x;
  EXPECT_GT(x, 0.1) << pitch.out;  // it lay in the middle

  Running in_the_simulator(control_program);
  expect_exit(0, run_mirocup({"match", "--blue", "dds:remote", "--yellow", "idle", "--half", "1",
                              "--match", id}));
  EXPECT_EQ(in_the_simulator.wait().exit_code, 0);
}

}  // namespace
}  // namespace mirocup
