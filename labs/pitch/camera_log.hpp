// SPDX-License-Identifier: MIT
//
// A recording: the robots and the ball, seen by a camera, and the commands of the robots. The
// schema is mirocup/recording/1, JSON lines. labs/docs/pitches.md describes the schema, and a
// camera program that writes recordings.
//
// Units are metres, radians counter-clockwise, seconds and rad/s, in the field's frame. `t` is the
// time at which a picture was taken, or a command was sent.
#pragma once

#include "core/base/error.hpp"
#include "core/field/league.hpp"
#include "core/match/snapshot.hpp"
#include "core/replay/recording.hpp"
#include "core/simulator/model/state.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::pitch {

// A robot that a picture shows.
struct SeenPose {
  Vec2 position{0.0, 0.0};
  double heading = 0.0;
};

// One line of a recording: a picture, a command, or both. Values that the camera did not see, or
// that are not known, are empty.
struct Frame {
  double t = 0.0;
  std::optional<Vec2> ball;
  match::ByTeam<std::vector<std::optional<SeenPose>>> robots;
  match::ByTeam<std::vector<simulator::WheelSpeeds>> commands;  // empty: no command to the team
};

struct CameraLog {
  std::string path;  // for messages
  RobotLeague league = RobotLeague::small;
  int robots = 0;                // number of listed robots of each team
  std::optional<double> period;  // time between two pictures, s; empty: it varies
  std::string pitch;             // the name of the pitch; "": not known
  std::vector<Frame> frames;     // in the order of their times

  // Returns the index of a robot among all: blue from 0, yellow from `robots`.
  int body_of(Team team, int robot) const { return index_of(team) * robots + robot; }
  const std::optional<SeenPose>& robot(const Frame& frame, int body) const {
    return frame.robots[body / robots][body % robots];
  }
  // Returns the median time between two pictures, s. Precondition: at least two frames.
  double usual_period() const;
};

// The most pictures of a recording: four hours at 30 Hz, which take half a GiB of memory. In memory
// a picture has all robots, also unseen ones, so it may be a hundred times larger than its line.
inline constexpr std::size_t max_pictures = 450'000;

// Reads a recording. The error, Errc::input, names the file, the line, the key and the reason.
Result<CameraLog> parse_recording(std::string_view text, const std::string& path,
                                  std::size_t most_pictures = max_pictures);
Result<CameraLog> read_recording(const std::string& path);

// Reads a recording from a table with commas and a first line of names: t, ball_x, ball_y, blue0_x,
// blue0_y, blue0_heading, blue0_left, blue0_right, blue1_x, …, yellow0_x, …, in any order. An empty
// field means that the camera did not see the body. read_recording() reads files that end in ".csv"
// this way.
Result<CameraLog> parse_csv(std::string_view text, const std::string& path,
                            std::size_t most_pictures = max_pictures);

std::string print_recording(const CameraLog& recording);

struct CameraNoise {
  double position = 0.002;     // m, standard deviation of each coordinate
  double heading = 0.0174533;  // rad
  double gaps = 0.02;          // share of bodies missing in a picture
  double outliers = 0.01;      // share of bodies seen at a random place of the field
  std::uint64_t seed = 1;
};

// Plays a leg again and returns a recording with a picture at the start of each tick, as a camera
// without noise would have made it. A frame has the commands that drive the robots in that tick;
// while play is stopped, the commands are 0. Errc::damaged if the leg differs from its record.
Result<CameraLog> as_seen(const replay::Recording& leg, const std::string& path);

// Adds noise, gaps and outliers to every pose of the recording.
void look_through(const CameraNoise& noise, CameraLog& recording);

}  // namespace mirocup::pitch
