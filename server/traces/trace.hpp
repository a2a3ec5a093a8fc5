// SPDX-License-Identifier: MIT
//
// A recorded situation, as `mirocup referee` reads it: key frames of a film, at one line of JSON
// each. docs/referee-traces.md has the format.
#pragma once

#include "core/base/error.hpp"
#include "core/referee/placement.hpp"
#include "core/referee/referee.hpp"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mirocup::traces {

// What one film shows from `t` on. What a frame does not give, it takes over from the one before.
struct KeyFrame {
  double t = 0.0;
  Vec2 ball{0.0, 0.0};
  double ball_since = 0.0;                   // the time of the frame that gave the ball
  referee::ByEnd<std::vector<Pose>> robots;  // by index; those that are not listed stand far away
  // Pairs that touch; nothing: judged by their gaps. Without a second robot it is the ball.
  using Contact = std::pair<referee::RobotId, std::optional<referee::RobotId>>;
  std::optional<std::vector<Contact>> contacts;
  referee::ByRobot<std::optional<double>> drive{};  // towards the robot that it touches
  std::optional<referee::RobotId> last_touch;
  referee::ByEnd<referee::RobotSet> fallen;
};

// How the ball moves on from its frame.
struct Motion {
  enum class Type { none, sine, line };
  Type type = Type::none;
  double amplitude = 0.0;   // m along x, of a sine
  double frequency = 0.0;   // Hz
  Vec2 velocity{0.0, 0.0};  // m/s, of a line
};

enum class TraceState { PLAY, READY, PLACE, HALF_TIME };

// What a team asks for: a time-out, or another robot in the place of one.
struct TeamRequest {
  double t = 0.0;
  End team = End::left;
  std::optional<referee::RobotId> to_replace;
};

// Somebody of a team reaches onto the field.
struct HandOnField {
  double t = 0.0;
  End team = End::left;
};

// A penalty attempt of a shoot-out at one moment.
struct Attempt {
  End taker = End::left;
  double t = 0.0;  // since it began
};

struct Trace {
  std::string id;
  League league = League::small;
  referee::Rules rules;
  TraceState state = TraceState::PLAY;
  referee::LegProgress progress;
  referee::Decision restart;     // in progress, or none
  std::vector<KeyFrame> frames;  // at least one, in order
  bool is_interpolated = false;
  Motion motion;
  std::optional<double> hold;
  std::vector<std::pair<double, double>> clock_stops;
  std::optional<referee::Placement> requested_placement;  // with state PLACE
  referee::ByEnd<int> requested_robots{};                 // how many poses each team gave
  std::vector<TeamRequest> requests;
  std::vector<HandOnField> hands;
  referee::ByEnd<bool> missing{};  // with state HALF_TIME: teams that do not come back
  std::optional<Attempt> attempt;
};

// Reads one situation. An error, Errc::input, begins with the JSON pointer of the key that is wrong.
// Unknown keys are ignored.
Result<Trace> trace_from_json(nlohmann::ordered_json json);

}  // namespace mirocup::traces

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 4> enum_names<traces::TraceState>{
    "PLAY", "READY", "PLACE", "HALF_TIME"};

}  // namespace mirocup
