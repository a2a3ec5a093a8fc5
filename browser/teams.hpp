// SPDX-License-Identifier: MIT
//
// The teams of a leg in the module. A team is a house team, a recorded team, or none. A person may
// drive each robot by hand.
#pragma once

#include "core/match/controller.hpp"
#include "core/replay/recording.hpp"
#include "mirocup/strategy.h"
#include "record/thought_line.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mirocup::browser {

// Returns the house or drill team with a name; null if the module has no such team.
const mirocup_strategy* house_team(std::string_view name);

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

}  // namespace mirocup::browser
