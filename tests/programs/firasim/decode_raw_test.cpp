// SPDX-License-Identifier: MIT
//
// The bytes of each kind of message, as protobuf's own program reads them: the numbers of the
// fields are those that FIRASim and VSSReferee have.
#include "server/firasim/wire.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

namespace mirocup::firasim {
namespace {

using namespace test_support;

// Returns the fields that `protoc --decode_raw` finds, without spaces: "1:16 2{1{...}}".
std::string fields_of(const std::string& bytes) {
  const TemporaryFolder folder;
  write_file(folder / "packet", bytes);
  const Outcome decoded =
      run({"/bin/sh", "-c", "protoc --decode_raw < '" + (folder / "packet") + "'"});
  EXPECT_EQ(decoded.exit_code, 0) << decoded.err;
  std::string words;
  for (const char c : decoded.out) {
    if (c == '\n') words.push_back(' ');
    if (c != '\n' && c != ' ') words.push_back(c);
  }
  return words;
}

bool has_protoc() {
  return run({"/bin/sh", "-c", "command -v protoc"}).exit_code == 0;
}

// Returns what a team's library (examples/firasim/firasim.py) sends by a call, to either port.
std::string sent_by(const std::string& call) {
  const TemporaryFolder folder;
  const std::string script =
      "import sys, socket\n"
      "sys.dont_write_bytecode = True\n"
      "sys.path.insert(0, '" MIROCUP_SOURCE_FOLDER
      "/examples/firasim')\n"
      "import firasim\n"
      "ear = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)\n"
      "ear.bind(('127.0.0.1', 0))\n"
      "here = '127.0.0.1:%d' % ear.getsockname()[1]\n"
      "client = firasim.Client(True, vision='127.0.0.1:0', referee='127.0.0.1:0', command=here,\n"
      "                        placement=here)\n" +
      call + "\nopen('" + (folder / "sent") + "', 'wb').write(ear.recv(4096))\n";
  const Outcome outcome = run({"/usr/bin/env", "python3", "-c", script});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return read_file(folder / "sent");
}

// As protoc prints a double.
constexpr const char* half = "0x3fe0000000000000";
constexpr const char* one = "0x3ff0000000000000";
constexpr const char* two = "0x4000000000000000";
constexpr const char* minus_two = "0xc000000000000000";

std::string filled(std::string text) {
  const std::pair<const char*, const char*> names[] = {
      {"HALF", half}, {"ONE", one}, {"MINUS", minus_two}, {"TWO", two}};
  for (const auto& [name, value] : names) {
    for (std::size_t at = 0; (at = text.find(name)) != std::string::npos;) {
      text.replace(at, std::string(name).size(), value);
    }
  }
  return text;
}

// Catches a field number, a wire type or an order of the lists that no client of FIRASim has.
TEST(FirasimWire, ProtocFindsTheFieldsOfVision) {
  if (!has_protoc()) GTEST_SKIP() << "protoc is not installed";
  Vision vision;
  vision.step = 16;
  vision.ball_x = 0.5;
  vision.ball_y = 1.0;
  vision.ball_z = 2.0;
  vision.ball_vx = -2.0;
  vision.ball_vy = 0.5;
  vision.robots_per_team = 2;
  vision.robots[index_of(Team::yellow)][1] = {0.5, 1.0, 2.0, -2.0, 0.5, 1.0};
  vision.robots[index_of(Team::blue)][1] = {1.0, 2.0, -2.0, 0.5, 1.0, 2.0};
  vision.field = {.width = 0.5,
                  .length = 1.0,
                  .goal_width = 2.0,
                  .goal_depth = -2.0,
                  .center_radius = 0.5,
                  .penalty_width = 1.0,
                  .penalty_depth = 2.0,
                  .penalty_point = -2.0};
  vision.goals = {3, 4};
  EXPECT_EQ(fields_of(encode(vision)),
            filled("1:16 2{ 1{ 1:HALF 2:ONE 3:TWO 4:MINUS 5:HALF } 2:\"\" "
                   "2{ 1:1 2:HALF 3:ONE 4:TWO 5:MINUS 6:HALF 7:ONE } 3:\"\" "
                   "3{ 1:1 2:ONE 3:TWO 4:MINUS 5:HALF 6:ONE 7:TWO } } "
                   "3{ 1:HALF 2:ONE 3:TWO 4:MINUS 5:HALF 6:ONE 7:TWO 8:MINUS } 4:3 5:4 "));
}

TEST(FirasimWire, ProtocFindsTheFieldsOfACall) {
  if (!has_protoc()) GTEST_SKIP() << "protoc is not installed";
  EXPECT_EQ(fields_of(encode(RefereeCommand{.foul = Foul::FREE_BALL,
                                            .colour = Colour::NONE,
                                            .quadrant = 4,
                                            .timestamp = 2.0,
                                            .half = 1})),
            filled("1:3 2:2 3:4 4:TWO 5:1 "));
}

// Catches an example that speaks to this program only.
TEST(FirasimWire, ProtocFindsTheFieldsOfWhatATeamSends) {
  if (!has_protoc()) GTEST_SKIP() << "protoc is not installed";
  EXPECT_EQ(fields_of(sent_by("client.drive([(2.0, -2.0), (0.5, 1.0)], 32)")),
            filled("1{ 1{ 1:0 2:1 6:TWO 7:MINUS } 1{ 1:1 2:1 6:HALF 7:ONE } } 15:32 "));
  EXPECT_EQ(fields_of(sent_by("client.place([(0.5, 1.0, 2.0)])")),
            filled("1{ 1:1 2{ 1:0 2:HALF 3:ONE 4:TWO } } "));
}

}  // namespace
}  // namespace mirocup::firasim
