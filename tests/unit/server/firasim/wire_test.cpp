// SPDX-License-Identifier: MIT
#include "server/firasim/wire.hpp"

#include "core/base/random.hpp"
#include "server/firasim/convert.hpp"
#include "server/firasim/server.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace mirocup::firasim {
namespace {

std::string bytes_of(std::initializer_list<int> values) {
  std::string bytes;
  for (const int value : values) bytes.push_back(static_cast<char>(value));
  return bytes;
}

// Robot 1 of yellow, wheels +10 and -10 rad/s, as FIRASim's clients send it.
const std::string one_command =
    bytes_of({0x0A, 0x18, 0x0A, 0x16, 0x08, 0x01, 0x10, 0x01, 0x31, 0, 0, 0,    0,
              0,    0,    0x24, 0x40, 0x39, 0,    0,    0,    0,    0, 0, 0x24, 0xC0});

// Catches a wrong field number, a missing zero, and a byte order of its own.
TEST(FirasimWire, ReadsACommandAsClientsSendIt) {
  const auto packet = decode_packet(one_command);
  ASSERT_TRUE(packet);
  ASSERT_EQ(packet->commands.size(), 1U);
  EXPECT_EQ(packet->commands[0].id, 1U);
  EXPECT_EQ(packet->commands[0].team, Team::yellow);
  EXPECT_EQ(packet->commands[0].left, 10.0);
  EXPECT_EQ(packet->commands[0].right, -10.0);
  EXPECT_FALSE(packet->step);

  // What is left out is 0: robot 0 of blue stands still.
  const auto zeros = decode_packet(bytes_of({0x0A, 0x02, 0x0A, 0x00}));
  ASSERT_TRUE(zeros);
  EXPECT_EQ(zeros->commands.at(0).id, 0U);
  EXPECT_EQ(zeros->commands.at(0).team, Team::blue);
  EXPECT_EQ(zeros->commands.at(0).left, 0.0);

  // Two parts of cmd are one message; unknown fields are skipped; 15 is the step.
  const auto joined = decode_packet(bytes_of({0x78, 0x20, 0x3D, 1, 2, 3, 4}) + one_command +
                                    bytes_of({0x22, 0x01, 0x07}) + one_command);
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->commands.size(), 2U);
  EXPECT_EQ(joined->step, 32U);
}

// Catches a length that is believed, a message that ends early, a list without an end.
TEST(FirasimWire, RefusesWhatIsNoMessage) {
  for (std::size_t cut = 1; cut < one_command.size(); ++cut) {
    EXPECT_FALSE(decode_packet(one_command.substr(0, cut))) << cut;
  }
  EXPECT_FALSE(decode_packet(""));
  EXPECT_FALSE(
      decode_packet(bytes_of({0x0A, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x7F})));
  EXPECT_FALSE(decode_packet(std::string(64, '\xFF')));
  EXPECT_FALSE(decode_packet(bytes_of({0x0B})));  // a group
  std::string many;
  for (std::size_t i = 0; i <= max_entries; ++i) many += one_command;
  EXPECT_FALSE(decode_packet(many));
}

// Catches reads beyond the end (with the sanitizers of the debug build) and numbers that a mutation
// smuggles past the conversion.
TEST(FirasimWire, MutatedDatagramsAreReadOrRefused) {
  Random dice(7);
  simulator::Parameters parameters;
  for (int i = 0; i < 20000; ++i) {
    std::string bytes = one_command + one_command;
    for (std::uint64_t k = dice.below(6); k-- > 0;) {
      bytes[dice.below(bytes.size())] = static_cast<char>(dice.below(256));
    }
    bytes.resize(dice.below(bytes.size() + 1));
    if (const auto packet = decode_packet(bytes)) {
      for (const WheelCommand& command : packet->commands) {
        if (!std::isfinite(command.left) || !std::isfinite(command.right)) continue;
        const auto wheels = to_wheels(command.left, command.right, parameters);
        EXPECT_LE(std::abs(wheels.left), parameters.wheel_speed_limit);
        EXPECT_LE(std::abs(wheels.right), parameters.wheel_speed_limit);
      }
    }
    decode_placement(bytes);
  }
}

// Catches a wheel of another radius, a turn to the wrong side, and a curve that the limit bends.
TEST(FirasimWire, RobotsMoveAsFirasimsWould) {
  simulator::Parameters parameters;
  const auto motion = [&](double left, double right) {
    const auto wheels = to_wheels(left, right, parameters);
    return std::pair(
        parameters.wheel_radius * (wheels.left + wheels.right) / 2.0,
        parameters.wheel_radius * (wheels.right - wheels.left) / parameters.wheel_distance);
  };
  EXPECT_NEAR(motion(40.0, 40.0).first, 0.8, 1e-12);
  EXPECT_NEAR(motion(-10.0, 10.0).second, 5.0, 1e-12);
  const auto [forward, turn] = motion(3000.0, 5000.0);
  EXPECT_NEAR(forward / turn, (0.01 * 8000.0) / (0.25 * 2000.0), 1e-9);
}

// Catches lists of robots that are swapped or out of order: clients take them by their place.
TEST(FirasimWire, VisionHasYellowFirstAndAllRobots) {
  Vision vision;
  vision.step = 300;
  vision.robots_per_team = 2;
  vision.robots[index_of(Team::yellow)][1].x = 1.0;
  const std::string bytes = encode(vision);
  EXPECT_EQ(bytes.substr(0, 4), bytes_of({0x08, 0xAC, 0x02, 0x12}));
  // Frame: ball (empty), yellow 0 (empty), yellow 1 {id 1, x 1.0}, blue 0, blue 1.
  EXPECT_EQ(bytes.substr(5), bytes_of({0x0A, 0, 0x12, 0,    0x12, 11, 0x08, 1, 0x11, 0, 0,    0, 0,
                                       0,    0, 0xF0, 0x3F, 0x1A, 0,  0x1A, 2, 0x08, 1, 0x1A, 0}));
}

TEST(FirasimWire, AddressesOfAnInstance) {
  const auto first = addresses_of(0, {.vision = "", .referee = "", .command = "", .placement = ""});
  ASSERT_TRUE(first);
  EXPECT_EQ(first->vision, "224.0.0.1:10002");
  EXPECT_EQ(first->command, "20011");
  EXPECT_EQ(first->referee, "224.5.23.2:10003");
  EXPECT_EQ(first->placement, "224.5.23.2:10004");
  const auto third =
      addresses_of(2, {.vision = "127.0.0.1:9", .referee = "", .command = "", .placement = ""});
  ASSERT_TRUE(third);
  EXPECT_EQ(third->vision, "127.0.0.1:9");
  EXPECT_EQ(third->command, "20013");
  EXPECT_EQ(third->referee, "224.5.23.2:40002");
  EXPECT_EQ(third->placement, "224.5.23.2:50002");
  EXPECT_FALSE(parse_endpoint("127.0.0.1:0", "--x"));
  EXPECT_FALSE(parse_endpoint("localhost:1", "--x"));
  EXPECT_TRUE(parse_endpoints("224.0.0.1:10002,127.0.0.1:10002", "--x"));
}

}  // namespace
}  // namespace mirocup::firasim
