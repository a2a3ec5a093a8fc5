// SPDX-License-Identifier: MIT
//
// The configuration of a batch: the legs that are played, the learners, their observations, actions
// and rewards. labs/docs/training.md describes the keys of its JSON.
#pragma once

#include "core/base/error.hpp"
#include "core/base/random.hpp"
#include "core/match/leg.hpp"
#include "core/match/start.hpp"
#include "core/match/team_parameters.hpp"
#include "labs/training/rewards.hpp"
#include "record/json_reader.hpp"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::training {

// The starts of episodes without a kick-off: situations, also those of drills, with numbers that
// each episode draws.

// A situation, "mirocup/situation/1" (docs/situations.md), whose numbers may be ranges.
struct StartRanges {
  std::string name;  // name of the start in messages
  nlohmann::ordered_json situation;
};

// Reads one start or a list of starts: a situation, the name of a drill, or the file of a situation
// or a drill. `folder` is the folder of the calling library; the drills are in share/mirocup/drills
// in this folder or one or two folders above it. Complains about a start if its numbers cannot be
// drawn, if it is for another league or, with `is_even`, if a team leads.
std::vector<StartRanges> read_starts(const record::JsonReader& json, RobotLeague league,
                                     bool is_even, const std::string& folder);

// Draws one of the starts, and its numbers. Precondition: `starts` is not empty.
Result<match::Start> draw_start(const std::vector<StartRanges>& starts, RobotLeague league,
                                Random& random);

// A learner steers its whole team, or one robot of it.
enum class Agents { team, robot };

enum class ObservationKind {
  standard,  // ball, robots, restart: observations.hpp
  relative,  // like `standard`, in the frame of the robot that learns
  vss,       // the 40 numbers of rSoccer's VSS environment
};

enum class ActionKind {
  wheels,  // left and right wheel, shares of the speed limit
  drive,   // forward and turn; left = forward - turn, right = forward + turn
  vss,     // wheels with the dead zone of rSoccer's VSS environment
};

enum class Autoreset { next_step, same_step, disabled };

// One team of every match.
struct Side {
  std::vector<int> learners;  // indices of the robots that learn, ascending
  // Steers the robots that do not learn: "noise", a house team, or a library.
  std::string mates = "idle";
  std::string library;               // path of the mates' library; "" for "noise" or no mates
  match::TeamParameters parameters;  // of the library

  bool learns() const { return !learners.empty(); }
};

struct Config {
  int matches = 1;
  int threads = 0;     // 0: one for each processor
  match::Setup setup;  // the seed in it is not used
  match::ByTeam<Side> sides;
  Agents agents = Agents::team;
  ObservationKind observation = ObservationKind::standard;
  ActionKind action = ActionKind::wheels;
  Autoreset autoreset = Autoreset::next_step;
  // After this time of play, s, an episode is truncated; infinite: never.
  double episode_s = 30.0;
  std::uint64_t max_steps = std::numeric_limits<std::uint64_t>::max();  // of an episode, likewise
  bool ends_at_goal = true;         // a goal terminates the episode
  bool skips_stops = true;          // a step also plays a stop of play after it; robots then stand
  std::vector<StartRanges> starts;  // starts of episodes; empty: the kick-off
  nlohmann::ordered_json pitch;     // "parameters" of a scene, with ranges; null: as in a match
  int ticks_per_step = 1;           // control periods for which an action holds
  Weights weights = default_weights();
  std::string text;  // the JSON, without the number of matches and threads
};

// Reads a configuration. House teams are also searched in `folder`, besides the places in which
// programs look. Errors: Errc::input, with the JSON pointer of the key.
Result<Config> parse_config(std::string_view json, const std::string& folder);

// Returns the setup of the leg of an episode; `seed` draws start and pitch. The error says that a
// start has no playable draw.
Result<match::Setup> setup_of(const Config& config, std::uint64_t seed);

}  // namespace mirocup::training

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 2> enum_names<training::Agents>{"team", "robot"};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<training::ObservationKind>{
    "standard", "relative", "vss"};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<training::ActionKind>{"wheels", "drive",
                                                                                  "vss"};
template <>
inline constexpr std::array<std::string_view, 3> enum_names<training::Autoreset>{
    "next_step", "same_step", "disabled"};

}  // namespace mirocup
