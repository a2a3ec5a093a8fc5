// SPDX-License-Identifier: MIT
//
// A recorded situation for `mirocup referee`: one line of JSON with key frames.
// docs/referee-traces.md specifies the format. Units are metres, radians and seconds, in the frame
// of the field.
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

// The positions from time `t` on. A value that a frame leaves out stays as in the frame before.
struct KeyFrame {
  double t = 0.0;
  Vec2 ball{0.0, 0.0};
  double ball_since = 0.0;                   // time of the last frame with a ball
  referee::ByEnd<std::vector<Pose>> robots;  // by index; unlisted robots stand far away
  // Pairs that touch: two robots, or a robot and the ball (then `second` is empty). Without a list,
  // the gaps between bodies decide which bodies touch.
  using Contact = std::pair<referee::RobotId, std::optional<referee::RobotId>>;
  std::optional<std::vector<Contact>> contacts;
  referee::ByRobot<std::optional<double>> drive{};  // command towards the touched robot, -1 to 1
  std::optional<referee::RobotId> last_touch;
  referee::ByEnd<referee::RobotSet> fallen;
};

// The motion of the ball since the last frame that places it.
struct Motion {
  enum class Type { none, sine, line };
  Type type = Type::none;
  double amplitude = 0.0;   // amplitude of a sine along x, m
  double frequency = 0.0;   // of a sine, Hz
  Vec2 velocity{0.0, 0.0};  // velocity along a line, m/s
};

enum class TraceState { PLAY, READY, PLACE, HALF_TIME };

// A request of a team: a time-out, or the substitution of a robot.
struct TeamRequest {
  double t = 0.0;
  End team = End::left;
  std::optional<referee::RobotId> to_replace;  // empty: a time-out
};

// A person of a team reaches onto the field.
struct HandOnField {
  double t = 0.0;
  End team = End::left;
};

// A penalty attempt of a shoot-out in progress.
struct Attempt {
  End taker = End::left;
  double t = 0.0;  // s since the start of the attempt
};

struct Trace {
  std::string id;
  RobotLeague league = RobotLeague::small;
  referee::Rules rules;
  TraceState state = TraceState::PLAY;
  referee::LegProgress progress;
  referee::Decision restart;     // the restart in progress; Restart::none if there is none
  std::vector<KeyFrame> frames;  // at least one, in order
  bool is_interpolated = false;
  Motion motion;
  std::optional<double> hold;  // the situation lasts until this time; empty: until the last frame
  std::vector<std::pair<double, double>> clock_stops;     // start and end of each stop of the clock
  std::optional<referee::Placement> requested_placement;  // only with state PLACE
  referee::ByEnd<int> requested_robots{};                 // number of poses that each team gave
  std::vector<TeamRequest> requests;
  std::vector<HandOnField> hands;
  referee::ByEnd<bool> missing{};  // teams that are late, only with state HALF_TIME
  std::optional<Attempt> attempt;
};

// Reads one situation. Errors: Errc::input, which begins with the JSON pointer of the wrong key.
// Unknown keys are ignored.
Result<Trace> trace_from_json(nlohmann::ordered_json json);

}  // namespace mirocup::traces

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 4> enum_names<traces::TraceState>{
    "PLAY", "READY", "PLACE", "HALF_TIME"};

}  // namespace mirocup
