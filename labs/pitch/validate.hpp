// SPDX-License-Identifier: MIT
//
// Validation: the simulator predicts the bodies' places some pictures ahead in a recording, and its
// errors are compared with those of yardsticks.
//
// Every few pictures a prediction begins: all bodies start with the positions and velocities that
// the pictures up to that time show. The yardsticks start from the same states:
//   straight  each body keeps its speed and its turn rate, also through other bodies and walls
//   peer      another engine with the same motors, if one is given
//   paper     the simulator with the paper's equations alone: wheels that never slide, motors with
//             one lag, friction of the ball in x and y separately, contacts without friction
// An error is the distance to the place where the body was seen. The camera's noise adds to it
// twice, in the start of the prediction and in the picture ahead; both means are subtracted.
#pragma once

#include "labs/pitch/camera_log.hpp"
#include "labs/pitch/unknowns.hpp"
#include "labs/pitch/windows.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace mirocup::pitch {

// The kind of event that a body has in the simulator between the start and the picture ahead. If a
// body has events of several kinds, the first kind of this list counts.
enum class EventKind { push, robot_and_robot, robot_and_ball, wall, slide, drive, free_roll };

inline constexpr std::array<int, 5> horizons{1, 2, 5, 10, 30};  // pictures ahead

enum class Predictor { simulator, straight, paper, peer };
inline constexpr int predictors = 4;

// The errors of one kind of event at one horizon.
struct ErrorCell {
  int count = 0;
  std::array<double, predictors> rms{};            // m, without the camera's noise
  std::array<bool, predictors> beats_simulator{};  // by two standard errors, and noticeably
};

// One prediction that the page draws: the seen and the predicted places of a body.
struct Track {
  EventKind kind = EventKind::drive;
  bool is_ball = false;
  std::string body;    // "blue 1", "the ball"
  double t = 0.0;      // time of the start in the recording, s
  double error = 0.0;  // error of the simulator at the last horizon, m
  std::vector<Vec2> seen;
  std::array<std::vector<Vec2>, predictors> predicted;
};

struct Validation {
  std::string peer;     // the name of the other engine; "": none
  double noise = 0.0;   // noise of the camera, m
  double period = 0.0;  // time between two pictures, s
  std::array<std::array<ErrorCell, horizons.size()>, 7> cells{};  // [kind][horizon]
  std::vector<Track> examples;  // a prediction of median error for each kind that occurred
  // Sentences about the cells in which a yardstick is better than the simulator.
  std::vector<std::string> objections;
};

// Another engine as a yardstick.
struct Peer {
  std::string name;
  // Sets the bodies to `start`, and calls see(frame, index in window.bodies, position) for each
  // body in each later frame of the window, in the order of frames and bodies.
  using See = std::function<void(int, std::size_t, const Vec2&)>;
  std::function<void(const CameraLog&, const Footage&, const Guess&, const Window&,
                     const std::vector<simulator::BodyState>& start, const See&)>
      play;
};

// Validates a pitch. `peer` may be null.
Validation validate(const std::vector<CameraLog>& recordings, const Guess& pitch,
                    const Peer* peer = nullptr);

}  // namespace mirocup::pitch

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 7> enum_names<pitch::EventKind>{
    "push", "robot_and_robot", "robot_and_ball", "wall", "slide", "drive", "free_roll"};
template <>
inline constexpr std::array<std::string_view, 4> enum_names<pitch::Predictor>{
    "simulator", "straight", "paper", "peer"};

}  // namespace mirocup
