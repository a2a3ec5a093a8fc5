// SPDX-License-Identifier: MIT
#include "plugins/host/trusted_controller.hpp"

#include "plugins/abi/convert.hpp"
#include "plugins/host/crash_notice.hpp"
#include "plugins/host/python_module.hpp"

#include <optional>
#include <utility>

namespace mirocup::plugins {

std::unique_ptr<TrustedController::Facts> TrustedController::facts_for(
    const match::Briefing& briefing, const match::TeamParameters& parameters, bool keeps_thoughts) {
  auto facts = std::make_unique<Facts>();
  facts->parameters = parameter_table(parameters);
  if (keeps_thoughts) facts->thoughts.emplace();
  facts->host = {&facts->parameters, &facts->asked, facts->thoughts ? &*facts->thoughts : nullptr};
  facts->setup = abi::to_setup(briefing);
  give_host(facts->setup, facts->host);
  return facts;
}

tl::expected<std::unique_ptr<TrustedController>, match::Fault> TrustedController::load(
    const std::string& path, const match::Briefing& briefing,
    const match::TeamParameters& parameters, bool keeps_thoughts) {
  auto facts = facts_for(briefing, parameters, keeps_thoughts);
  MIROCUP_TRY(auto plugin, Plugin::load(path, facts->setup));
  return std::unique_ptr<TrustedController>(
      new TrustedController(briefing.team, std::move(facts), std::move(plugin)));
}

tl::expected<std::unique_ptr<TrustedController>, match::Fault> TrustedController::load_python(
    const std::string& path, const std::string& module, const match::Briefing& briefing,
    const match::TeamParameters& parameters, bool keeps_thoughts) {
  auto facts = facts_for(briefing, parameters, keeps_thoughts);
  MIROCUP_TRY(auto plugin, plugins::load_python(path, module, facts->setup));
  return std::unique_ptr<TrustedController>(
      new TrustedController(briefing.team, std::move(facts), std::move(plugin)));
}

TrustedController::TrustedController(Team team, std::unique_ptr<Facts> facts, Plugin plugin)
    : colour_(to_string(team)), facts_(std::move(facts)), plugin_(std::move(plugin)) {}

void TrustedController::post(const match::Observation& observation) {
  observation_ = abi::to_observation(observation);
}

match::Answer TrustedController::collect() {
  if (facts_->thoughts) facts_->thoughts->clear();
  facts_->host.shapes = 0;
  std::optional<match::PlacementRequest> poses;
  if (observation_.placing != 0) {
    const RunningCallMark mark({colour_.c_str(), "place()", observation_.tick});
    const auto placement = plugin_.place(observation_);
    if (!placement) return placement.error();
    poses = abi::to_poses(*placement);
  }
  const RunningCallMark mark({colour_.c_str(), "decide()", observation_.tick});
  const auto decided = plugin_.decide(observation_);
  if (!decided) return decided.error();
  match::Command command = abi::to_command(*decided);
  command.placement = poses;
  return command;
}

}  // namespace mirocup::plugins
