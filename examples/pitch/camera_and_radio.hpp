// SPDX-License-Identifier: MIT
//
// What a real pitch has in place of a simulator, and all that pitch.cpp asks of it. Metres, radians
// and seconds in the frame of the field: origin at its centre, x towards the right goal.
#pragma once

#include "core/match/command.hpp"

#include <array>

namespace pitch {

struct Place {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
};

// A camera knows where things are, and neither their speeds nor their spin.
struct Picture {
  Place ball;
  std::array<std::array<Place, mirocup::max_robots_per_team>, 2> robots;  // blue, yellow
};

class Camera {
 public:
  virtual ~Camera() = default;
  // The next picture, once for each tick.
  virtual Picture next_picture() = 0;
};

class Radio {
 public:
  virtual ~Radio() = default;
  // Wheel speeds for a team's robots. They drive so until the next word.
  virtual void send(int colour, const mirocup::match::Command& command) = 0;
};

}  // namespace pitch
