// SPDX-License-Identifier: MIT
//
// Recordings of a pitch whose numbers are known: two robots that play the recipe of
// labs/docs/pitches.md (chase the ball, rush about, stop from full speed, run against walls and
// against each other), seen by a camera. For tests of identification, and for its bars.
#pragma once

#include "core/base/random.hpp"
#include "core/simulator/statistics.hpp"
#include "labs/pitch/camera_log.hpp"
#include "labs/pitch/unknowns.hpp"

#include <array>

namespace mirocup::test_support {

struct DrivenPitch {
  pitch::Guess truth;
  double seconds = 60.0;
  double period = 1.0 / 60.0;  // s, between two pictures
  pitch::CameraNoise noise;
  bool has_walls = true;  // false: the ball is put down in the middle and hits nothing
  std::uint64_t seed = 1;
};

// Draws numbers of a pitch: lags of 0.03 to 0.2 s, restitutions of 0.2 to 0.9, and so on; every
// second one with two lags, every third with a brake.
pitch::Guess random_pitch(std::uint64_t seed);

// The commands of two robots, one of each team.
inline constexpr int driven_robots = 2;
using DrivenWheels = std::array<simulator::WheelSpeeds, driven_robots>;
using DrivenStates = std::array<simulator::BodyState, driven_robots>;

class Driver {
 public:
  explicit Driver(double fastest) : fastest_(fastest) {}  // rad/s
  // Returns the commands at t seconds, which never goes back.
  DrivenWheels at(double t, const DrivenStates& robots, const Vec2& ball, Random& random);

 private:
  // rush: any wheel speeds. dash: straight on, then told to stop. knock: straight on until a wall
  // is near, duel: towards each other; then both are told to stop or to go back.
  enum class Mode { rush, dash, knock, duel, chase };

  void begin(double t, const DrivenStates& robots, Random& random);
  bool arrives(int robot, const DrivenStates& robots) const;

  double fastest_;
  Mode mode_ = Mode::rush;
  double until_ = 0.0;                          // s, end of the mode
  DrivenWheels wheels_{};                       // rad/s, of a rush or on the way
  DrivenWheels back_{};                         // rad/s, after it
  std::array<double, driven_robots> leaves_{};  // s, from which on back_ holds
  double lead_ = 0.0;                           // s, before the hit
};

pitch::CameraLog recording_of(const DrivenPitch& driven,
                              simulator::RunStatistics* statistics = nullptr);

}  // namespace mirocup::test_support
