// SPDX-License-Identifier: MIT
#include "plugins/host/process_controller.hpp"

#include "plugins/abi/convert.hpp"
#include "plugins/host/launch.hpp"
#include "plugins/host/sandbox/filter.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <utility>

namespace mirocup::plugins {

namespace {

using match::Answer;
using match::Fault;
using match::FaultCode;
using match::HostFailure;

// The death of a process wakes nobody, so every wait is cut into slices. They are longer than the
// kernel's own clock tick: a timer that is due before that has to be programmed into the hardware
// and out again, in every wait, which costs more than handing over.
constexpr std::chrono::milliseconds slice{20};

// A full pipe refuses what a team prints, so it is emptied now and then.
constexpr std::uint32_t ticks_between_readings = 32;

// How long the sandbox itself may take, s. Only a machine in great trouble needs so long.
constexpr double longest_setup = 60.0;

// A sealed piece of memory of that size, mapped here for writing.
template <class Page>
Page* make_page(int fd) {
  if (ftruncate(fd, sizeof(Page)) != 0) return nullptr;
  void* page = mmap(nullptr, sizeof(Page), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
  if (page == MAP_FAILED) return nullptr;
  return new (page) Page{};
}

tl::unexpected<Error> not_available(const char* what) {
  return fail(Errc::unavailable, std::string(what) + ": " + std::strerror(errno));
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::string seconds_text(double seconds) {
  return std::to_string(static_cast<int>(seconds)) + " s";
}

}  // namespace

Result<std::unique_ptr<ProcessController>> ProcessController::start(
    const std::string& host_program, Isolation isolation, const Entry& entry,
    const match::Briefing& briefing, const Budget& budget, std::optional<Deadline> deadline,
    std::shared_ptr<Doorbell> bell) {
  const Descriptor in_fd(memfd_create("observation", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  const Descriptor out_fd(memfd_create("command", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  ObservationPage* in = make_page<ObservationPage>(in_fd.get());
  CommandPage* out = make_page<CommandPage>(out_fd.get());
  if (in == nullptr || out == nullptr) return not_available("the mailbox of a team");
  // From now on nobody can map the observations for writing, or shrink either page under the
  // server.
  const int no_resizing = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;
  if (fcntl(in_fd.get(), F_ADD_SEALS, no_resizing | F_SEAL_FUTURE_WRITE) != 0 ||
      fcntl(out_fd.get(), F_ADD_SEALS, no_resizing) != 0) {
    return not_available("the seals of a team's mailbox");
  }
  in->setup = abi::to_setup(briefing);

  int log_ends[2];
  int setup_ends[2];
  if (pipe2(log_ends, O_CLOEXEC | O_NONBLOCK) != 0) return not_available("a pipe");
  Descriptor log(log_ends[0]);
  const Descriptor child_log(log_ends[1]);
  if (pipe2(setup_ends, O_CLOEXEC) != 0) return not_available("a pipe");
  Descriptor setup(setup_ends[0]);
  const Descriptor child_setup(setup_ends[1]);

  auto child = launch({.program = host_program,
                       .isolation = isolation,
                       .observation = in_fd.get(),
                       .command = out_fd.get(),
                       .setup = child_setup.get(),
                       .entry = entry.descriptor(),
                       .log = child_log.get()});
  if (!child) return tl::unexpected(child.error());
  return std::unique_ptr<ProcessController>(
      new ProcessController(std::move(*child), in, out, std::move(setup), std::move(log), budget,
                            deadline, std::move(bell)));
}

ProcessController::ProcessController(Child child, ObservationPage* in, CommandPage* out,
                                     Descriptor setup, Descriptor log, const Budget& budget,
                                     std::optional<Deadline> deadline,
                                     std::shared_ptr<Doorbell> bell)
    : child_(std::move(child)),
      in_(in),
      out_(out),
      setup_(std::move(setup)),
      log_pipe_(std::move(log)),
      budget_(budget),
      deadline_(deadline),
      bell_(std::move(bell)),
      posted_at_(Clock::now()),
      asked_at_(posted_at_) {
  bell_->join();
}

ProcessController::~ProcessController() {
  bell_->leave();
  child_.kill();
  munmap(in_, sizeof *in_);
  munmap(out_, sizeof *out_);
}

// Until the process says that its sandbox stands, all that goes wrong is the host's. It says so
// through a pipe that it closes before it touches the library.
std::optional<HostFailure> ProcessController::wait_for_sandbox() {
  pollfd readable{setup_.get(), POLLIN, 0};
  char text[128];
  ssize_t length = 0;
  if (poll(&readable, 1, static_cast<int>(1e3 * longest_setup)) > 0)
    length = read(setup_.get(), text, sizeof text);
  if (length == 1 && text[0] == sandbox_stands) {
    setup_.reset();
    return std::nullopt;
  }
  std::string why = "it ended without a word";
  if (length > 0) {
    why.assign(text, static_cast<std::size_t>(length));
    // A message may come in pieces.
    while ((length = read(setup_.get(), text, sizeof text)) > 0)
      why.append(text, static_cast<std::size_t>(length));
  }
  child_.kill();
  return HostFailure{"the sandbox of a team could not be built: " + why};
}

// What the process itself said of its end.
std::optional<Fault> ProcessController::label(const Ending& ending) const {
  if (ending.signal == SIGSYS)
    return Fault{FaultCode::illegal_call, "the team made a system call that is not allowed"};
  if (ending.signal == 0 && ending.exit_code == exit_faulted) {
    const int signal = out_->fault_signal.load(std::memory_order_acquire);
    if (signal == SIGSYS) {
      return Fault{FaultCode::illegal_call,
                   "the team made a system call that is not allowed: " +
                       system_call_name(out_->fault_call.load(std::memory_order_relaxed))};
    }
    if (signal > 0 && signal < NSIG)
      return Fault{FaultCode::crash, "the team's process died of " + signal_text(signal)};
  }
  if (ending.signal == 0 && ending.exit_code == exit_refused) {
    char copy[sizeof out_->text];
    std::memcpy(copy, out_->text, sizeof copy);
    copy[sizeof copy - 1] = '\0';
    const std::string text = escaped(copy);
    switch (out_->load_state.load(std::memory_order_acquire)) {
      case LoadState::no_load:
        return Fault{FaultCode::no_load, text};
      case LoadState::bad_abi:
        return Fault{FaultCode::bad_abi, text};
      case LoadState::crash:
        return Fault{FaultCode::crash, text};
      default:
        break;
    }
  }
  return std::nullopt;
}

Answer ProcessController::death(const Ending& ending) {
  // The filter keeps a team from killing itself in this way.
  if (ending.signal == SIGKILL) {
    return HostFailure{
        "a team's process was killed from outside: out of memory, or a cancelled job"};
  }
  Fault fault = label(ending).value_or(Fault{
      FaultCode::crash,
      ending.signal != 0
          ? "the team's process died of " + signal_text(ending.signal)
          : "the team's process ended itself with exit code " + std::to_string(ending.exit_code)});
  if (!is_ready_ && fault.code != FaultCode::no_load && fault.code != FaultCode::bad_abi)
    fault.text += ", while its library was loaded";
  return fault;
}

template <class Done>
std::optional<Answer> ProcessController::wait(Done done, const Patience& patience,
                                              std::optional<Clock::time_point> until) {
  while (true) {
    if (done()) break;
    in_->is_awaited.store(1, std::memory_order_seq_cst);
    const std::uint32_t seen = out_->answer.load(std::memory_order_seq_cst);
    if (done()) break;
    std::chrono::nanoseconds pause = slice;
    if (until) pause = std::clamp<std::chrono::nanoseconds>(*until - Clock::now(), {}, slice);
    wait_while_equal(out_->answer, seen, pause);
    if (done()) break;
    if (const auto ending = child_.ending()) return death(*ending);
    cpu_ = child_.cpu_seconds();
    const bool is_busy = cpu_ - cpu_at_post_ > patience.cpu;
    if (is_busy || seconds_since(asked_at_) > patience.wall) {
      child_.kill();
      return Fault{patience.late, "the team used more than " +
                                      (is_busy ? seconds_text(patience.cpu) + " of processor time "
                                               : seconds_text(patience.wall) + " ") +
                                      patience.doing};
    }
    if (until && Clock::now() >= *until) {
      in_->is_awaited.store(0, std::memory_order_relaxed);
      return match::Late{};
    }
  }
  in_->is_awaited.store(0, std::memory_order_relaxed);
  return std::nullopt;
}

tl::expected<void, Answer> ProcessController::wait_until_ready() {
  if (auto failure = wait_for_sandbox()) return tl::unexpected<Answer>(*failure);
  const auto is_ready = [this] { return out_->load_state.load() == LoadState::ready; };
  const Patience patience{budget_.start_cpu, budget_.start_wall, FaultCode::start_timeout,
                          "to load its library and create its team"};
  if (auto problem = wait(is_ready, patience, std::nullopt)) return tl::unexpected(*problem);
  is_ready_ = true;
  cpu_at_ready_ = cpu_ = child_.cpu_seconds();
  start_wall_ = seconds_since(posted_at_);
  return {};
}

void ProcessController::post(const match::Observation& observation) {
  posted_at_ = Clock::now();
  ++ticks_;
  // A team that still thinks about an older one gets the newest when it comes back. Without a
  // deadline that never happens.
  if (is_awaited_) return;
  is_awaited_ = true;
  is_placing_ = observation.placing;
  if (is_placing_) ++places_;
  asked_at_ = posted_at_;
  cpu_at_post_ = cpu_;
  in_->observation = abi::to_observation(observation);
  in_->request.store(++request_, std::memory_order_release);
  bell_->ask(in_->request);
}

Answer ProcessController::late() {
  ++late_;
  ++late_in_a_row_;
  if (late_in_a_row_ <= deadline_->most_late_in_a_row && late_ <= deadline_->most_late)
    return match::Late{};
  child_.kill();
  return Fault{FaultCode::hang,
               "the team was late " + (late_ > deadline_->most_late
                                           ? std::to_string(late_) + " times in this leg"
                                           : std::to_string(late_in_a_row_) + " times in a row")};
}

// What a team owes at the end of a tick.
std::optional<Fault> ProcessController::overdraft() {
  if (playing_seconds() > bank_seconds()) {
    return Fault{FaultCode::budget,
                 "the team used up its processor time: more than " + seconds_text(budget_.bank) +
                     " and " + std::to_string(1e3 * budget_.bank_per_tick).substr(0, 4) +
                     " ms for each of " + std::to_string(ticks_) + " ticks, more for each place()"};
  }
  if (has_slept_too_long()) {
    return Fault{FaultCode::hang,
                 "the team slept more than " + seconds_text(budget_.sleep) + " in this leg"};
  }
  return std::nullopt;
}

// What the server waited for, less what both had to wait for a processor: a busy machine is not the
// team's fault.
bool ProcessController::has_slept_too_long() {
  if (waited_ < budget_.sleep || waited_ < next_look_) return false;
  next_look_ = waited_ + 1.0;
  const auto own_delay = Child::processor_delay(getpid());
  const auto delay = child_.processor_delay();
  if (!own_delay || !delay) return false;
  return waited_ - playing_seconds() - *delay - *own_delay > budget_.sleep;
}

Answer ProcessController::collect() {
  bell_->ring();
  const auto is_answered = [this] {
    return out_->answer.load(std::memory_order_acquire) == request_;
  };
  const Patience patience{
      budget_.tick_cpu + (is_placing_ ? budget_.place_cpu : 0.0), budget_.tick_wall,
      FaultCode::hang,
      is_placing_ ? "on one tick and place() and was stopped" : "on one tick and was stopped"};
  std::optional<Clock::time_point> until;
  if (deadline_) {
    until = posted_at_ + std::chrono::duration_cast<Clock::duration>(
                             std::chrono::duration<double>(deadline_->tick));
  }
  if (!is_answered()) {
    const auto begin = Clock::now();
    if (auto problem = wait(is_answered, patience, until))
      return std::holds_alternative<match::Late>(*problem) ? late() : *problem;
    waited_ += seconds_since(begin);
  }
  cpu_ = child_.cpu_seconds();
  is_awaited_ = false;
  late_in_a_row_ = 0;
  slowest_tick_ = std::max(slowest_tick_, cpu_ - cpu_at_post_);
  if (auto fault = overdraft()) {
    child_.kill();
    return *fault;
  }
  if (ticks_ % ticks_between_readings == 0) read_log();
  // Copied once, so that what is checked is what is driven, whatever the team writes meanwhile.
  mirocup_command copy;
  std::memcpy(&copy, &out_->command, sizeof copy);
  std::optional<match::PlacementRequest> poses;
  if (is_placing_) {
    mirocup_placement placement;
    std::memcpy(&placement, &out_->placement, sizeof placement);
    poses = abi::to_poses(placement);
  }
  std::atomic_signal_fence(std::memory_order_seq_cst);
  match::Command command = abi::to_command(copy);
  command.placement = poses;
  return command;
}

void ProcessController::read_log() {
  std::array<char, 1 << 14> buffer;
  // As much as the pipe holds: who writes while this reads cannot keep it here.
  for (int i = 0; i < 4; ++i) {
    const ssize_t n = read(log_pipe_.get(), buffer.data(), buffer.size());
    if (n <= 0) return;
    log_.append({buffer.data(), static_cast<std::size_t>(n)});
  }
}

std::string ProcessController::output() {
  read_log();
  return log_.text();
}

}  // namespace mirocup::plugins
