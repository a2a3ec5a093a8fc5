// SPDX-License-Identifier: MIT
#include "plugins/host/trusted_controller.hpp"

#include "plugins/abi/convert.hpp"

#include <optional>
#include <utility>

namespace mirocup::plugins {

tl::expected<std::unique_ptr<TrustedController>, match::Fault> TrustedController::load(
    const std::string& path, const match::Briefing& briefing,
    const match::TeamParameters& parameters, bool keeps_thoughts) {
  auto facts = std::make_unique<Facts>();
  facts->parameters = parameter_table(parameters);
  if (keeps_thoughts) facts->thoughts.emplace();
  facts->host = {&facts->parameters, &facts->asked, facts->thoughts ? &*facts->thoughts : nullptr};
  facts->setup = abi::to_setup(briefing);
  facts->setup.log = write_line;
  give_host(facts->setup, facts->host);
  auto plugin = Plugin::load(path, facts->setup);
  if (!plugin) return tl::unexpected(plugin.error());
  return std::unique_ptr<TrustedController>(
      new TrustedController(std::move(facts), std::move(*plugin)));
}

TrustedController::TrustedController(std::unique_ptr<Facts> facts, Plugin plugin)
    : facts_(std::move(facts)), plugin_(std::move(plugin)) {}

void TrustedController::post(const match::Observation& observation) {
  observation_ = abi::to_observation(observation);
}

match::Answer TrustedController::collect() {
  if (facts_->thoughts) facts_->thoughts->clear();
  std::optional<match::PlacementRequest> poses;
  if (observation_.placing != 0) {
    const auto placement = plugin_.place(observation_);
    if (!placement) return placement.error();
    poses = abi::to_poses(*placement);
  }
  const auto decided = plugin_.decide(observation_);
  if (!decided) return decided.error();
  match::Command command = abi::to_command(*decided);
  command.placement = poses;
  return command;
}

}  // namespace mirocup::plugins
