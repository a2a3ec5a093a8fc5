// SPDX-License-Identifier: MIT
//
// A team in a separate sandboxed process. No act of the team stops the server. It is a fault of the
// team if the process dies, hangs or answers nonsense, but a failure of the host if the process is
// killed from outside.
//
// Only the answers of the process affect the match. Reports of the process (the reason of its end,
// its output) are labels: a team that forges a report changes only the reason of its own loss.
#pragma once

#include "core/match/controller.hpp"
#include "plugins/host/child.hpp"
#include "plugins/host/doorbell.hpp"
#include "plugins/host/mailbox.hpp"
#include "plugins/host/memory_witness.hpp"
#include "plugins/host/reported_fault.hpp"
#include "plugins/host/sandbox/isolation.hpp"
#include "plugins/host/sealed_entry.hpp"
#include "plugins/host/team_log.hpp"
#include "system/descriptor.hpp"

#include <chrono>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace mirocup::plugins {

// The limits of a team, in seconds. The match waits for both teams and counts their processor time.
// A team has a bank of processor time for the whole leg; the limits of one tick only stop code that
// would never end. The limits of wall time stop teams that sleep. Time in which a team waits for a
// processor does not count, so no team loses because the machine is busy.
struct Budget {
  double start_cpu = 10.0;
  double start_wall = 30.0;
  double tick_cpu = 1.0;
  double tick_wall = 10.0;
  double place_cpu = 1.0;  // additional to tick_cpu in a tick with place()
  double bank = 2.0;
  double bank_per_tick = 1e-3;
  double bank_per_place = 20e-3;
  // The longest time for which a team may sleep in a leg: neither compute nor wait for a processor.
  double sleep = 10.0;

  // Returns the processor time, s, that a team may have used after these ticks and placements.
  double bank_after(std::uint32_t ticks, std::uint32_t places) const {
    return bank + bank_per_tick * ticks + bank_per_place * places;
  }
};

// The limits of a match in real time. An answer after `tick` is late. A team loses if it has more
// late answers than either count below allows.
struct Deadline {
  double tick = 0.0;           // longest time from observation to answer, s
  int max_late_in_a_row = 90;  // late answers in a row; 3 s with ticks of 33 ms
  int max_late = 600;          // late answers in the leg
};

// The conditions under which a leg's teams play. Both teams share the witness and the doorbell.
struct ProcessTerms {
  Isolation isolation = Isolation::T2;
  Budget budget;
  std::optional<Deadline> deadline;  // empty: a tick lasts until the team answers
  Surroundings surroundings;
  bool keeps_thoughts = false;  // true: keeps the team's shapes
  std::shared_ptr<Doorbell> bell = std::make_shared<Doorbell>();
  std::shared_ptr<MemoryWitness> memory = std::make_shared<MemoryWitness>();
  std::function<void()> meanwhile = [] {};  // called every 20 ms while a team is awaited
};

class ProcessController final : public match::Controller {
 public:
  // Starts the program at `host_program` with the entry and the parameters. An error is a failure
  // of the host; wait_until_ready() returns faults of the library.
  static Result<std::unique_ptr<ProcessController>> start(const std::string& host_program,
                                                          const SealedEntry& entry,
                                                          const match::Briefing& briefing,
                                                          const match::TeamParameters& parameters,
                                                          const ProcessTerms& terms);
  ~ProcessController() override;

  // Waits until the library is loaded and its team created. The error is the team's fault, or a
  // failure of the host. Must succeed before the first post().
  tl::expected<void, match::Answer> wait_until_ready();

  void post(const match::Observation& observation) override;
  match::Answer collect() override;

  // Returns the processor time of the process since its start, loading included, s.
  double cpu_seconds() const { return cpu_; }
  // Returns the processor time since the first tick, s. Only this time counts against the bank.
  double playing_seconds() const { return cpu_ - cpu_at_ready_; }
  double slowest_tick_ms() const { return 1e3 * slowest_tick_; }
  double start_seconds() const { return start_wall_; }
  // Returns how long the process was ready to run but had no processor, s; nothing if the kernel
  // does not tell.
  std::optional<double> processor_delay() const { return child_.processor_delay(); }
  // Returns the processor time, s, that the team may have used up to now.
  double bank_seconds() const { return terms_.budget.bank_after(ticks_, places_); }
  // Returns the number of observations that asked the team to place.
  std::uint32_t placements_asked() const { return places_; }
  // Returns the peak of the process's memory, bytes.
  std::size_t peak_memory() const { return child_.peak_memory(); }

  // Returns the rows of the parameter table that the team has asked for, according to its process.
  std::uint32_t asked_parameters() const {
    return out_->asked_parameters.load(std::memory_order_relaxed);
  }

  // Returns a copy of the team's shapes in the tick that it answered last, or in which it ended;
  // null if shapes are not kept.
  const ThoughtsPage* thoughts();

  // Returns the name that the library gives its team, any bytes; "" before the team is ready.
  std::string team_name() const { return {out_->name, strnlen(out_->name, sizeof out_->name)}; }

  // Returns the report that the process left when it ended by itself; nothing before its end.
  const std::optional<LastWords>& exit_report() const { return exit_report_; }

  // Returns the functions of the library in which the process crashed, a line each, innermost
  // first; "" if the process has not crashed or left no trace. The end of output() also has these
  // lines.
  const std::string& backtrace() const { return backtrace_; }

  // Returns the team's requests to the system, a request in a line, according to its process. The
  // text may have any bytes; it is "" unless the host program is mirocup-careful-host.
  std::string requests() const {
    return {out_->requests, strnlen(out_->requests, sizeof out_->requests)};
  }

  // Returns the time for which the team slept, neither computing nor waiting for a processor, s;
  // nothing if the kernel does not tell.
  std::optional<double> slept_seconds() const;

  // Returns the output of the team so far, bounded and escaped, as TeamLog::text().
  std::string output(Ticks ticks = Ticks::left_out);

 private:
  using WallClock = std::chrono::steady_clock;

  // The longest wait for the team, and the fault of a team that takes longer.
  struct WaitLimit {
    double cpu = 0.0;
    double wall = 0.0;
    match::FaultCode fault = match::FaultCode::hang;
    const char* doing = "";
  };

  ProcessController(Team team, Child child, ObservationPage* in, CommandPage* out,
                    system::Descriptor setup, system::Descriptor log, system::Descriptor entry,
                    const ProcessTerms& terms);

  std::optional<match::HostFailure> wait_for_sandbox();
  // Waits until done() is true. Returns Late if `until` comes first; otherwise a reason for which
  // the team has lost or the leg is void.
  template <class Done>
  std::optional<match::Answer> wait(Done done, const WaitLimit& limit,
                                    std::optional<WallClock::time_point> until);
  match::Answer answer_to_exit(const ExitStatus& status);
  bool is_stuck_in_its_report();
  std::string describe_trace() const;
  match::Answer count_late_tick();
  std::optional<match::Fault> find_overdraft() const;
  std::optional<match::Fault> find_overrun();
  bool has_slept_too_long();
  // Returns the time since `begin`, less the time for which the process was ready to run but had no
  // processor, s. `delay_at_begin` is processor_delay() at `begin`.
  double seconds_without_delay(WallClock::time_point begin,
                               std::optional<double> delay_at_begin) const;
  void wait_for_word(std::uint32_t seen, std::chrono::nanoseconds pause);
  void forgive_absence(double pause);
  void read_log();

  Team team_;
  Child child_;
  ObservationPage* in_;
  CommandPage* out_;
  system::Descriptor setup_;
  system::Descriptor entry_;    // the library's bytes, sealed; for the names of its functions
  system::Descriptor loading_;  // open while the process may load; see ask_before_loading()
  bool has_loaded_ = false;     // according to the process, which may lie
  system::Descriptor log_pipe_;
  TeamLog log_;
  std::unique_ptr<ThoughtsPage> thoughts_;  // null unless shapes are kept
  ProcessTerms terms_;
  bool is_ready_ = false;

  std::optional<AskedMoment> moment_;  // of the last observation that the process got
  std::optional<LastWords> exit_report_;
  std::string backtrace_;
  std::optional<WallClock::time_point> report_began_;  // when the server saw a crash report
  std::optional<double> delay_at_report_;              // s, processor_delay() at report_began_
  std::uint32_t ticks_ = 0;                            // observations so far
  std::uint32_t places_ = 0;                           // observations that asked the team to place
  std::uint32_t request_ = 0;  // number of the last observation that the process got
  bool is_awaited_ = false;    // true: that observation has no answer yet
  bool is_placing_ = false;    // true: that observation also asks for poses
  WallClock::time_point posted_at_;
  WallClock::time_point asked_at_;        // time of the oldest observation without an answer
  std::optional<double> delay_at_slice_;  // s: processor_delay() at the first check after asked_at_
  std::optional<double> own_delay_at_slice_;  // s: the same of the server, at the last check
  double forgiven_delay_ = 0.0;               // the server's delay while a team had not answered, s
  double cpu_at_post_ = 0.0;
  double cpu_ = 0.0;
  double cpu_at_ready_ = 0.0;
  double slowest_tick_ = 0.0;
  double start_wall_ = 0.0;
  double waited_ = 0.0;            // wall time that the server has waited for answers, s
  double absent_ = 0.0;            // wall time in which the server itself was stopped, s
  double next_sleep_check_ = 0.0;  // value of waited_ at which to check for sleep again
  int late_in_a_row_ = 0;
  int late_ = 0;
};

}  // namespace mirocup::plugins
