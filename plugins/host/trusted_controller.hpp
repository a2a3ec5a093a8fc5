// SPDX-License-Identifier: MIT
//
// A team in the server's own process (`--trusted`), without protection from the team and without
// the time that protection takes.
#pragma once

#include "plugins/host/plugin.hpp"
#include "plugins/host/team_host.hpp"

#include <memory>
#include <optional>
#include <string>

namespace mirocup::plugins {

// From now on, this process prints a line about the running call of a team in this process before a
// deadly signal ends it. (In a team's own process fault_report.hpp reports crashes.) Existing
// handlers, such as a sanitizer's, stay. Only a program may call this function, not a library in
// another program's process.
void tell_of_crashes();

class TrustedController final : public match::Controller {
 public:
  // Loads the library at `path`, which must contain a slash, and creates its team with the
  // parameters. If `keeps_thoughts`, thoughts() has the team's shapes. `module`: the path of
  // mirocup-python.so if `path` is the file of a team in Python; "" for a library.
  static tl::expected<std::unique_ptr<TrustedController>, match::Fault> load(
      const std::string& path, const match::Briefing& briefing,
      const match::TeamParameters& parameters, bool keeps_thoughts = false,
      const std::string& module = "");

  void post(const match::Observation& observation) override;
  match::Answer collect() override;

  // Returns the team's shapes in the tick that it answered last; null if shapes are not kept.
  const ThoughtsPage* thoughts() const { return facts_->thoughts ? &*facts_->thoughts : nullptr; }

  // Returns the name that the library gives its team: any text.
  std::string team_name() const { return plugin_.name(); }

  // Returns the rows of the parameter table that the team has asked for so far.
  std::uint32_t asked_parameters() const { return facts_->asked.load(std::memory_order_relaxed); }

 private:
  // The data that the team reads; they live as long as the team.
  struct Facts {
    ParameterTable parameters;
    AskedRows asked{0};
    TeamHost host;
    std::optional<ThoughtsPage> thoughts;
    mirocup_setup setup{};
  };

  static std::unique_ptr<Facts> facts_for(const match::Briefing& briefing,
                                          const match::TeamParameters& parameters,
                                          bool keeps_thoughts);
  TrustedController(Team team, std::unique_ptr<Facts> facts, Plugin plugin);

  std::string colour_;
  std::unique_ptr<Facts> facts_;
  Plugin plugin_;
  mirocup_observation observation_{};
};

}  // namespace mirocup::plugins
