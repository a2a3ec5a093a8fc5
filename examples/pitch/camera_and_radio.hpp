// SPDX-License-Identifier: MIT
//
// The interfaces of a real pitch, which pitch.cpp uses in place of a simulator. Units are metres,
// radians and seconds, in the frame of the field: the origin is its centre, x points to the right
// goal.
#pragma once

#include "core/match/command.hpp"

#include <array>

namespace pitch {

struct Place {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
};

// One picture of the camera: positions and headings, without speeds.
struct Picture {
  Place ball;
  std::array<std::array<Place, mirocup::max_robots_per_team>, 2> robots;  // blue, yellow
};

class Camera {
 public:
  virtual ~Camera() = default;
  // Returns the next picture. Called once for each tick.
  virtual Picture next_picture() = 0;
};

class Radio {
 public:
  virtual ~Radio() = default;
  // Sends wheel speeds to the robots of a team, which keep them until the next call.
  virtual void send(int colour, const mirocup::match::Command& command) = 0;
};

}  // namespace pitch
