// SPDX-License-Identifier: MIT
//
// A team in a process of its own. Whatever the team does, the server goes on: a process that dies,
// hangs or answers nonsense is a fault of its team; one that somebody else killed is a failure of
// the host.
#pragma once

#include "core/match/controller.hpp"
#include "plugins/host/child.hpp"
#include "plugins/host/mailbox.hpp"

#include <memory>
#include <string>

namespace mirocup::plugins {

// Processor time where a busy machine must not cost a team the leg, wall time against sleepers.
// Seconds.
struct ProcessLimits {
  double start_cpu = 10.0;
  double start_wall = 30.0;
  double tick_cpu = 1.0;
  double tick_wall = 10.0;
};

class ProcessController final : public match::Controller {
 public:
  // Starts mirocup-plugin-host at `host_program` with the library at `library`. An error is the
  // host's; what the library does comes out of wait_until_ready().
  static Result<std::unique_ptr<ProcessController>> start(const std::string& host_program,
                                                          const std::string& library,
                                                          const match::Briefing& briefing,
                                                          const ProcessLimits& limits);
  ~ProcessController() override;

  // Returns when the library is loaded, or why it never will be.
  tl::expected<void, match::Answer> wait_until_ready();

  void post(const match::Observation& observation) override;
  match::Answer collect() override;

  double cpu_seconds() const { return cpu_; }
  double slowest_tick_ms() const { return 1e3 * slowest_tick_; }

  // What the team printed, at most 64 KiB of it.
  std::string output();

 private:
  ProcessController(Child child, ObservationPage* in, CommandPage* out, int output,
                    const ProcessLimits& limits);

  // Waits until done() holds; else why the team has lost or the leg is void.
  template <class Done>
  std::optional<match::Answer> wait(Done done, double cpu_limit, double wall_limit,
                                    match::FaultCode late, const char* doing);
  match::Answer death(const Ending& ending);

  Child child_;
  ObservationPage* in_;
  CommandPage* out_;
  int output_;
  ProcessLimits limits_;
  std::uint32_t request_ = 0;
  double cpu_ = 0.0;
  double slowest_tick_ = 0.0;
};

}  // namespace mirocup::plugins
