// SPDX-License-Identifier: MIT
//
// A leg that a page plays, with its teams and the marks of a drill. The leg can continue a record.
#pragma once

#include "core/match/controller.hpp"
#include "core/replay/recording.hpp"
#include "core/simulator/world.hpp"
#include "mirocup/strategy.h"
#include "record/drills/judge.hpp"
#include "record/match_record.hpp"
#include "record/thought_line.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace mirocup::browser {

// The teams of a leg in the module. A team is a house team, a recorded team, a team outside of the
// module, or none. A person may drive each robot by hand.

// Returns the house or drill team with a name, or a team outside: "mine", "mine, without place()".
// Null if the module has no such team.
const mirocup_strategy* house_team(std::string_view name);

// Returns the team that the program around the module plays, by the module's imports. Without
// place() its robots stand in the default places at restarts.
const mirocup_strategy* outside_team(bool has_place);

// Steers one team. The constructor's arguments must outlive the object.
class Driver final : public match::Controller {
 public:
  // A strategy drives the robots. Without a strategy, the recording drives the robots. After the
  // recording's end, or without a recording, the robots stand.
  Driver(const match::Briefing& briefing, const mirocup_strategy* strategy,
         const replay::Recording* recording);
  ~Driver() override;
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  void post(const match::Observation& observation) override;
  match::Answer collect() override;

  // Drives a robot with wheel speeds, rad/s. If `wheels` is empty, the team drives the robot again.
  void take(int robot, std::optional<simulator::WheelSpeeds> wheels) { by_hand_[robot] = wheels; }

  // Returns the shapes that the team drew in its last tick, as lines of mirocup/thoughts/1; ""
  // unless the leg is watched.
  const std::string& thoughts() const { return thoughts_; }
  void watch() { is_watched_ = true; }

 private:
  static void draw(void* driver, const match::Thought& shape);
  void give_host();
  match::Command own_command();

  Team team_;
  const mirocup_strategy* strategy_;
  const replay::Recording* recording_;
  mirocup_setup setup_;
  mirocup_observation now_{};
  void* state_ = nullptr;
  std::array<std::optional<simulator::WheelSpeeds>, max_robots_per_team> by_hand_;
  record::ThoughtLine line_;
  std::string thoughts_;
  bool is_watched_ = false;
};

using record::Json;

// Reads a record. `replay` is the content of its replay file, unpacked. Errors: Errc::damaged,
// which names `path`.
Result<record::MatchRecord> read_record(const std::string& text, const std::string& replay,
                                        const std::string& path);

// Verifies the record as `mirocup verify` does. `is_whole`: true if the digests of the record's
// files are right. Returns {reproduced, tick, what, ticks, state_hash, found}.
Result<Json> verify(const std::string& text, const std::string& replay, bool is_whole,
                    const std::string& path);

class Game {
 public:
  // Makes a leg from {league, rules, stage, seed, conditions, pitch, situation, drill, teams}, each
  // in the form and with the default of a record; `drill` is the text of a drill, which sets
  // everything but the seed and the tested team. `teams`: {"blue", "yellow"}, names of house teams,
  // or "" for standing robots. Errors: Errc::input.
  static Result<std::unique_ptr<Game>> make(const Json& options);

  // Plays the record's commands up to `tick`; from `tick` on, `teams` play. The team "recorded"
  // continues with the record's commands. Errors: Errc::input, Errc::damaged.
  static Result<std::unique_ptr<Game>> go_on(record::MatchRecord past, std::uint32_t tick,
                                             const Json& teams);

  // Gives the robots to other teams from the next tick on: {"blue", "yellow"}, as in make(). A team
  // that keeps its robots keeps its memory. Errors: Errc::input.
  Result<void> seat(const Json& teams);

  // Plays at most `ticks` ticks, and stops when the leg or the drill's try is over. Returns the
  // number of played ticks.
  int play(int ticks);

  // From now on records impacts, pressing pairs and thoughts, which makes play() a quarter slower.
  void watch();

  // Ends the leg, so that record() can return its record.
  void stop();

  // Drives a robot by hand, wheel speeds in rad/s. If `wheels` is empty, the team drives the robot
  // again.
  void take(Team team, int robot, std::optional<simulator::WheelSpeeds> wheels);

  const Driver& driver(Team team) const { return *drivers_[index_of(team)]; }
  const match::Leg& leg() const { return *leg_; }
  bool is_over() const { return leg_->is_over() || is_decided_; }

  // Returns the state after the last tick as a situation (docs/situations.md) from which a leg can
  // start.
  Json situation() const;

  // Returns the settings of the leg, except teams and start, with the keys of make().
  Json setup() const;

  // {tick, clock, state, phase, left, score, decisions, counts, impacts, pressing, result, drill}:
  // the data that a page shows besides the bodies. `decisions` has the decisions from number
  // `first` on. `impacts` has the impacts of the last call of play(): [x, y, x and y of the normal,
  // impulse in N s]. `pressing` has the pairs of bodies that push each other, as indices: blue's
  // robots from 0 on, then yellow's, then the ball; -1 is a wall. `impacts` and `pressing` are
  // empty unless the leg is watched.
  Json status(std::size_t first) const;

  // Returns why a team of a leg that is over did not do better, as `mirocup stats` advises it:
  // [{drill, why}], the greatest reason first.
  Json advice(Team team) const;

  // Returns the record of a leg that is over. It names the replay file leg.replay.zst.
  record::MatchRecord record() const;

 private:
  Game() = default;
  void start(const match::Setup& setup);
  Json counts() const;
  Json contacts() const;

  std::unique_ptr<record::MatchRecord> past_;
  std::optional<record::PlayedOnFrom> from_;
  std::optional<drills::Drill> drill_;
  simulator::RunStatistics touches_;
  std::unique_ptr<field::Field> field_;
  std::unique_ptr<simulator::World> world_;  // the leg's world; records impacts in touches_
  std::unique_ptr<match::Leg> leg_;
  std::array<std::unique_ptr<Driver>, 2> drivers_;
  match::ByTeam<std::string> seated_;  // names that seat() got
  match::ByTeam<std::string> names_;   // names of the teams for the record
  std::optional<drills::Judge> judge_;
  replay::StateTrace trace_;
  bool is_decided_ = false;  // true: the drill's try is over
  bool is_watched_ = false;
};

}  // namespace mirocup::browser
