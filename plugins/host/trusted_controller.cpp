// SPDX-License-Identifier: MIT
#include "plugins/host/trusted_controller.hpp"

#include "plugins/abi/convert.hpp"
#include "plugins/host/python_module.hpp"

#include <dlfcn.h>
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
  facts->setup.log = write_line;
  give_host(facts->setup, facts->host);
  return facts;
}

tl::expected<std::unique_ptr<TrustedController>, match::Fault> TrustedController::load(
    const std::string& path, const match::Briefing& briefing,
    const match::TeamParameters& parameters, bool keeps_thoughts) {
  auto facts = facts_for(briefing, parameters, keeps_thoughts);
  auto plugin = Plugin::load(path, facts->setup);
  if (!plugin) return tl::unexpected(plugin.error());
  return std::unique_ptr<TrustedController>(
      new TrustedController(std::move(facts), std::move(*plugin)));
}

tl::expected<std::unique_ptr<TrustedController>, match::Fault> TrustedController::load_python(
    const std::string& path, const std::string& module, const match::Briefing& briefing,
    const match::TeamParameters& parameters, bool keeps_thoughts) {
  const auto no_load = [](std::string why) {
    return tl::unexpected(match::Fault{match::FaultCode::no_load, std::move(why)});
  };
  void* library = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return no_load(std::string("Python is not here: ") + dlerror());
  const auto load =
      reinterpret_cast<decltype(&mirocup_python_load)>(dlsym(library, "mirocup_python_load"));
  if (load == nullptr) return no_load(module + " is of another version");
  auto facts = facts_for(briefing, parameters, keeps_thoughts);
  PythonLoaded loaded{};
  load(path.c_str(), &facts->setup, &loaded);
  if (loaded.team == nullptr) return no_load(loaded.why);
  return std::unique_ptr<TrustedController>(
      new TrustedController(std::move(facts), Plugin::adopt(*loaded.strategy, loaded.team)));
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
