// SPDX-License-Identifier: MIT
#include "plugins/host/trusted_controller.hpp"

#include "plugins/abi/convert.hpp"

#include <optional>
#include <utility>

namespace mirocup::plugins {

tl::expected<std::unique_ptr<TrustedController>, match::Fault> TrustedController::load(
    const std::string& path, const match::Briefing& briefing) {
  auto setup = std::make_unique<mirocup_setup>(abi::to_setup(briefing));
  setup->log = write_line;
  auto plugin = Plugin::load(path, *setup);
  if (!plugin) return tl::unexpected(plugin.error());
  return std::unique_ptr<TrustedController>(
      new TrustedController(std::move(setup), std::move(*plugin)));
}

TrustedController::TrustedController(std::unique_ptr<mirocup_setup> setup, Plugin plugin)
    : setup_(std::move(setup)), plugin_(std::move(plugin)) {}

void TrustedController::post(const match::Observation& observation) {
  observation_ = abi::to_observation(observation);
}

match::Answer TrustedController::collect() {
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
