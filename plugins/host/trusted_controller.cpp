// SPDX-License-Identifier: MIT
#include "plugins/host/trusted_controller.hpp"

#include "plugins/abi/convert.hpp"
#include "plugins/host/host_program.hpp"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <unistd.h>
#include <utility>

namespace mirocup::plugins {

namespace {

// The call of a team that runs in this thread, if it has a colour. A variable of the thread,
// because a signal handler takes no pointer, and the handler runs in the thread that has crashed.
struct RunningCall {
  const char* colour = nullptr;
  const char* function = "";
  std::uint32_t tick = 0;
};
thread_local RunningCall running_call;

// Prints the running call, and then ends the process by the signal's default action.
void tell_of_crash(int signal) {
  const auto& [colour, function, tick] = running_call;
  if (colour != nullptr) {
    std::array<char, 256> text;
    (void)std::snprintf(text.data(), text.size(),
                        "mirocup: the %s team crashed in this process, in %s of tick %u, by %s; "
                        "with gdb --args before the command, bt shows the line\n",
                        colour, function, tick, sigdescr_np(signal));
    (void)!write(STDERR_FILENO, text.data(), std::strlen(text.data()));
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void tell_of_crashes() {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    struct sigaction present {};
    if (sigaction(signal, nullptr, &present) != 0 || present.sa_handler != SIG_DFL) continue;
    struct sigaction action {};
    action.sa_handler = tell_of_crash;
    sigaction(signal, &action, nullptr);
  }
}

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
    const match::TeamParameters& parameters, bool keeps_thoughts, const std::string& module) {
  auto facts = facts_for(briefing, parameters, keeps_thoughts);
  MIROCUP_TRY(auto plugin, module.empty() ? Plugin::load(path, facts->setup)
                                          : load_python(path, module, facts->setup));
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
    running_call = {colour_.c_str(), "place()", observation_.tick};
    const auto placement = plugin_.place(observation_);
    running_call = {};
    if (!placement) return placement.error();
    poses = abi::to_poses(*placement);
  }
  running_call = {colour_.c_str(), "decide()", observation_.tick};
  const auto decided = plugin_.decide(observation_);
  running_call = {};
  if (!decided) return decided.error();
  match::Command command = abi::to_command(*decided);
  command.placement = poses;
  return command;
}

}  // namespace mirocup::plugins
