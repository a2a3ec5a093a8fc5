// SPDX-License-Identifier: MIT
//
// The messages of FIRASim and VSSReferee as bytes: protobuf's encoding, written by hand because six
// small messages need no library. Comments give the field numbers.
//
// The frame on the wire has its origin at the centre of the field; blue is left and attacks +x.
// Units are metres and seconds, and rad/s for wheels. Headings are in radians in vision and in
// degrees in placements.
//
// A missing number is 0, so a missing colour is blue. Like protobuf, decoding accepts fields in any
// order, skips unknown fields and joins messages that come in parts.
#pragma once

#include "core/field/league.hpp"
#include "core/field/team.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::firasim {

// The most entries of a team's datagram. A datagram with more entries is malformed.
inline constexpr std::size_t max_entries = 64;

// Robot of a Frame.
struct SeenRobot {
  double x = 0.0, y = 0.0;                // 2, 3
  double orientation = 0.0;               // field 4; rad in (-pi, pi]
  double vx = 0.0, vy = 0.0, turn = 0.0;  // fields 5, 6, 7; m/s, rad/s
};

// Field: the sizes, m, with which a client draws the field and plans.
struct FieldSizes {
  double width = 0.0, length = 0.0;                 // 1, 2
  double goal_width = 0.0, goal_depth = 0.0;        // 3, 4
  double center_radius = 0.0;                       // 5
  double penalty_width = 0.0, penalty_depth = 0.0;  // 6, 7
  double penalty_point = 0.0;                       // 8
};

// Environment: the vision of one tick.
struct Vision {
  std::uint32_t step = 0;                           // field 1; ms of simulated time
  double ball_x = 0.0, ball_y = 0.0, ball_z = 0.0;  // Frame 1: Ball 1, 2, 3
  double ball_vx = 0.0, ball_vy = 0.0;              // Ball 4, 5
  std::array<std::array<SeenRobot, max_robots_per_team>, 2> robots;  // [team]: blue 3, yellow 2
  int robots_per_team = 0;
  FieldSizes field;                      // 3
  std::array<std::uint32_t, 2> goals{};  // blue 4, yellow 5
};
std::string encode(const Vision& vision);

// Command of one robot.
struct WheelCommand {
  std::uint32_t id = 0;            // 1
  Team team = Team::blue;          // field 2, bool yellowteam
  double left = 0.0, right = 0.0;  // 6, 7
};

// Packet: the commands of a team.
struct Packet {
  std::vector<WheelCommand> commands;  // cmd 1: robot_commands 1
  bool has_replacement = false;        // replace 2
  // Field 15, an extension that FIRASim skips: the step of the vision that the commands answer.
  // With this field, lock-step need not guess which vision the commands answer.
  std::optional<std::uint32_t> step;
};
// Returns nothing if the bytes are not a Packet.
std::optional<Packet> decode_packet(std::string_view bytes);

enum class Foul {
  FREE_KICK,
  PENALTY_KICK,
  GOAL_KICK,
  FREE_BALL,
  KICKOFF,
  STOP,
  GAME_ON,
  HALT,
};
enum class Colour { BLUE, YELLOW, NONE };

// VSSRef_Command.
struct RefereeCommand {
  Foul foul = Foul::FREE_KICK;   // 1
  Colour colour = Colour::NONE;  // 2
  int quadrant = 0;              // field 3; quadrant 1: x, y > 0, then counter-clockwise; 0: none
  double timestamp = 0.0;        // field 4; time of the half, s
  int half = 0;                  // field 5; halves: 1 and 2, extra time: 3 and 4, shoot-out: 5
};
std::string encode(const RefereeCommand& command);

struct PlacedRobot {
  std::uint32_t id = 0;      // 1
  double x = 0.0, y = 0.0;   // 2, 3
  double orientation = 0.0;  // field 4; degrees
};

// VSSRef_Placement.
struct TeamPlacement {
  Team team = Team::blue;           // world 1: teamColor 1
  std::vector<PlacedRobot> robots;  // world 1: robots 2
};
// Returns nothing if the bytes are not a placement of one of the two teams.
std::optional<TeamPlacement> decode_placement(std::string_view bytes);

}  // namespace mirocup::firasim
