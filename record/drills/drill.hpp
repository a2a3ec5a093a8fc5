// SPDX-License-Identifier: MIT
//
// A drill: a situation that is tried many times, the events that count in a try, and their marks.
// The JSON of a drill is "mirocup/drill/1", specified in docs/drills.md.
//
// The tested team is blue. Places and areas are in the tested team's frame, in which it attacks +x.
// Units are metres, seconds and radians.
#pragma once

#include "core/base/error.hpp"
#include "core/match/leg.hpp"
#include "core/match/team_parameters.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::drills {

inline constexpr Team tested = Team::blue;

enum class EventKind { goal, no_goal, save, touch, pass, pose, in_area, no_foul };

// The frame of a pose. `ball`: the origin is the ball, and +x points from the ball to the middle of
// the opponents' goal.
enum class Frame { field, ball };

// An event that must happen in a try, or must not. The comment of a member names the kinds of
// events for which the member counts. If a drill has an event that must happen, its events that
// must not happen give no marks; if one of these happens, it takes all marks of the try.
struct Event {
  EventKind kind = EventKind::goal;
  double marks = 1.0;
  double by = std::numeric_limits<double>::infinity();  // the latest time, s since the start
  int count = 1;                                        // goal, save, touch, pass: the least number
  int most = 0;                                         // no_goal, no_foul: the greatest number
  std::optional<int> robot;      // touch, pose, in_area: this robot; empty: any robot
  bool first = false;            // touch: true: before an opponent touches the ball
  bool is_of_ball = true;        // in_area: true: the ball must be there; false: a robot
  std::array<double, 4> area{};  // in_area: low x, low y, high x, high y
  Frame frame = Frame::field;    // pose
  Pose pose;                     // pose
  double within = 0.005;         // pose: greatest distance from `pose`, m
  double within_angle = 0.2;     // pose: greatest difference of heading, rad
  double hold = 0.0;             // pose, in_area: least time without a break, s

  // Returns false if the event must not happen; the end of the try decides such an event.
  bool has_to_happen() const { return kind != EventKind::no_goal && kind != EventKind::no_foul; }
};

// Deductions from the marks of a try, as shares of full marks.
struct Deductions {
  double time = 0.0;  // for a success in the last moment; less for an earlier success
  double foul = 0.0;  // for each foul
};

struct Drill {
  std::string name;  // name of the file without its suffix
  std::string title;
  std::string teaches;
  int version = 1;  // only scores of one version can be compared
  RobotLeague league = RobotLeague::small;
  referee::Rules rules;
  match::Conditions conditions;
  nlohmann::ordered_json situation;  // numbers may be ranges
  std::string opponent;              // the opponent, as on the command line
  std::string mates;                 // the team that steers the other robots; "": none
  referee::RobotSet robots;          // robots of the tested team; the mates have the others
  match::TeamParameters parameters;  // parameters of the tested team
  double seconds = 10.0;             // time of play in a try, s
  int tries = 60;
  bool plays_on = false;  // false: the try ends when the referee stops play
  std::vector<Event> success;
  Deductions deductions;
};

// Reads a drill. An error is Errc::input and names file and key.
Result<Drill> parse_drill(std::string_view text, const std::string& path);

// Returns the setup of one try. The seed draws the numbers of the situation that have a range, and
// disturbs the leg. The leg ends by itself after the drill's seconds of play. The error says why no
// drawn situation could be played.
Result<match::Setup> setup_of(const Drill& drill, std::uint64_t seed);

}  // namespace mirocup::drills

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 8> enum_names<drills::EventKind>{
    "goal", "no_goal", "save", "touch", "pass", "pose", "in_area", "no_foul"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<drills::Frame>{"field", "ball"};

}  // namespace mirocup
