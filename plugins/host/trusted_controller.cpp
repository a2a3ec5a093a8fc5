// SPDX-License-Identifier: MIT
#include "plugins/host/trusted_controller.hpp"

#include "plugins/abi/convert.hpp"
#include "plugins/host/host_program.hpp"

#include <csignal>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <unistd.h>
#include <utility>

namespace mirocup::plugins {

namespace {

// The call of a team that runs in this process.
struct RunningCall {
  const char* colour = "";
  const char* function = "";
  std::uint32_t tick = 0;
};

// A variable of the thread, because a signal handler takes no pointer, and the handler runs in the
// thread that has crashed.
thread_local const RunningCall* running_call = nullptr;

void print_part(const char* text) {
  (void)!write(STDERR_FILENO, text, std::strlen(text));
}

void print_number(std::uint32_t number) {
  char digits[12];
  char* first = digits + sizeof digits - 1;
  *first = '\0';
  do *--first = static_cast<char>('0' + number % 10);
  while ((number /= 10) > 0);
  print_part(first);
}

// Prints the running call, and then ends the process by the signal's default action.
void tell_of_crash(int signal) {
  if (const RunningCall* call = running_call) {
    print_part("mirocup: the ");
    print_part(call->colour);
    print_part(" team crashed in this process, in ");
    print_part(call->function);
    print_part(" of tick ");
    print_number(call->tick);
    print_part(", by ");
    print_part(sigdescr_np(signal));
    print_part("; with gdb --args before the command, bt shows the line\n");
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// Marks a call as running as long as the object lives.
class RunningCallMark {
 public:
  explicit RunningCallMark(const RunningCall& call) : call_(call) { running_call = &call_; }
  RunningCallMark(const RunningCallMark&) = delete;
  RunningCallMark& operator=(const RunningCallMark&) = delete;
  ~RunningCallMark() { running_call = nullptr; }

 private:
  RunningCall call_;
};

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
