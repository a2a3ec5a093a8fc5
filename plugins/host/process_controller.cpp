// SPDX-License-Identifier: MIT
#include "plugins/host/process_controller.hpp"

#include "plugins/abi/convert.hpp"
#include "plugins/host/function_names.hpp"
#include "plugins/host/launch.hpp"
#include "plugins/host/reported_fault.hpp"
#include "plugins/host/sandbox/descriptor_packet.hpp"
#include "plugins/host/sandbox/filter.hpp"
#include "system/printable.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cinttypes>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <utility>

namespace mirocup::plugins {

namespace {

using match::Answer;
using match::Fault;
using match::FaultCode;
using match::HostFailure;

// The end of a process wakes no waiter, so every wait is cut into slices. A slice is longer than
// the kernel's clock tick: a shorter timer would have to be programmed into the hardware and
// removed again in every wait, which costs more than handing over.
constexpr std::chrono::milliseconds slice{20};

// A server that sleeps a slice and wakes so much later, s, was stopped with its whole job.
constexpr double min_absence = 1.0;

// The time limit for building the sandbox. Only a machine in great trouble needs that long.
constexpr std::chrono::milliseconds max_setup_time{60'000};

// How long a process that has crashed may take to say where, s.
constexpr double max_report_time = 0.5;

// Sizes the memory file and maps it here for writing.
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

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::chrono::steady_clock::duration wall_time(double seconds) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::chrono::duration<double>(seconds));
}

std::string seconds_text(double seconds) {
  return std::to_string(static_cast<int>(seconds)) + " s";
}

}  // namespace

Result<std::unique_ptr<ProcessController>> ProcessController::start(
    const std::string& host_program, const SealedEntry& entry, const match::Briefing& briefing,
    const match::TeamParameters& parameters, const ProcessTerms& terms) {
  const system::Descriptor in_fd(memfd_create("observation", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  const system::Descriptor out_fd(memfd_create("command", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  ObservationPage* in = make_page<ObservationPage>(in_fd.get());
  CommandPage* out = make_page<CommandPage>(out_fd.get());
  if (in == nullptr || out == nullptr) return not_available("the mailbox of a team");
  // From now on no process can map the observations for writing, or shrink either page under the
  // server.
  const int no_resizing = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;
  if (fcntl(in_fd.get(), F_ADD_SEALS, no_resizing | F_SEAL_FUTURE_WRITE) != 0 ||
      fcntl(out_fd.get(), F_ADD_SEALS, no_resizing) != 0) {
    return not_available("the seals of a team's mailbox");
  }
  in->setup = abi::to_setup(briefing);
  in->parameters = parameter_table(parameters);
  in->surroundings = terms.surroundings;
  in->keeps_thoughts = terms.keeps_thoughts ? 1 : 0;

  int log_ends[2];
  int setup_ends[2];
  if (pipe2(log_ends, O_CLOEXEC | O_NONBLOCK) != 0) return not_available("a pipe");
  system::Descriptor log(log_ends[0]);
  const system::Descriptor child_log(log_ends[1]);
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, setup_ends) != 0)
    return not_available("a pair of sockets");
  system::Descriptor setup(setup_ends[0]);
  const system::Descriptor child_setup(setup_ends[1]);

  MIROCUP_TRY(auto child, launch({.program = host_program,
                                  .isolation = terms.isolation,
                                  .fixed_addresses = terms.surroundings.fixed_addresses,
                                  .observation = in_fd.get(),
                                  .command = out_fd.get(),
                                  .setup = child_setup.get(),
                                  .entry = entry.descriptor(),
                                  .log = child_log.get()}));
  system::Descriptor kept(fcntl(entry.descriptor(), F_DUPFD_CLOEXEC, 0));
  return std::unique_ptr<ProcessController>(
      new ProcessController(briefing.team, std::move(child), in, out, std::move(setup),
                            std::move(log), std::move(kept), terms));
}

ProcessController::ProcessController(Team team, Child child, ObservationPage* in, CommandPage* out,
                                     system::Descriptor setup, system::Descriptor log,
                                     system::Descriptor entry, const ProcessTerms& terms)
    : team_(team),
      child_(std::move(child)),
      in_(in),
      out_(out),
      setup_(std::move(setup)),
      entry_(std::move(entry)),
      log_pipe_(std::move(log)),
      terms_(terms),
      posted_at_(WallClock::now()),
      asked_at_(posted_at_) {
  if (terms.keeps_thoughts) thoughts_ = std::make_unique<ThoughtsPage>();
  terms_.bell->join();
  terms_.memory->add(team_, child_);
}

ProcessController::~ProcessController() {
  terms_.bell->leave();
  terms_.memory->remove(team_);
  child_.kill();
  munmap(in_, sizeof *in_);
  munmap(out_, sizeof *out_);
}

// Until the process tells that its sandbox stands, every error is a failure of the host. The
// process tells it through a socket that it closes before it touches the library.
std::optional<HostFailure> ProcessController::wait_for_sandbox() {
  pollfd readable{setup_.get(), POLLIN, 0};
  char text[128];
  ssize_t length = -1;
  for (auto n = max_setup_time / slice; n > 0 && poll(&readable, 1, slice.count()) == 0; --n)
    terms_.meanwhile();
  if (readable.revents != 0) {
    length = receive_packet(setup_.get(), text, sizeof text, loading_);
    if (loading_.get() >= 0) length = read(setup_.get(), text, sizeof text);
  }
  if (length == 1 && text[0] == sandbox_stands) {
    setup_.reset();
    return std::nullopt;
  }
  const bool has_ended = length == 0;  // the socket is closed, and nothing was said
  std::string why = "its process ended without a message";
  if (length > 0) {
    why.assign(text, static_cast<std::size_t>(length));
    // The text may come in pieces.
    while ((length = read(setup_.get(), text, sizeof text)) > 0)
      why.append(text, static_cast<std::size_t>(length));
  }
  child_.kill();
  if (has_ended && child_.exit_status()->signal == SIGKILL)
    return HostFailure{"the " + std::string(to_string(team_)) +
                       " team's process was killed from outside before its sandbox was complete"};
  return HostFailure{"the sandbox of a team could not be built: " + why};
}

Answer ProcessController::answer_to_exit(const ExitStatus& status) {
  // The team cannot have done it: the filter forbids sending itself SIGKILL.
  if (status.signal == SIGKILL) return judge_kill(team_, terms_.memory->evidence(team_));
  LastWords words;
  words.signal = out_->fault_signal.load(std::memory_order_acquire);
  words.call = out_->fault_call.load(std::memory_order_relaxed);
  words.load_state = out_->load_state.load(std::memory_order_acquire);
  words.text.assign(out_->text, strnlen(out_->text, sizeof out_->text));
  words.cause.assign(out_->cause, strnlen(out_->cause, sizeof out_->cause));
  words.line = std::max(0, out_->refusal_line.load(std::memory_order_relaxed));
  words.address = out_->fault_address.load(std::memory_order_relaxed);
  words.team_call = out_->team_call.load(std::memory_order_relaxed);
  exit_report_ = words;
  backtrace_ = describe_trace();
  read_log();
  if (!backtrace_.empty()) log_.append("Crashed in\n" + backtrace_);
  return fault_of(status, words, is_ready_, moment_);
}

// A process that has crashed says where before it ends. What it follows may be as broken as the
// rest of its memory, so the leg waits only a moment for it.
bool ProcessController::is_stuck_in_its_report() {
  if (out_->fault_signal.load(std::memory_order_relaxed) == 0) return false;
  if (!report_began_) {
    report_began_ = WallClock::now();
    delay_at_report_ = child_.processor_delay();
  }
  return seconds_without_delay(*report_began_, delay_at_report_) > max_report_time;
}

// The addresses are the process's own words: they may be any numbers.
std::string ProcessController::describe_trace() const {
  if (out_->fault_is_traced.load(std::memory_order_acquire) == 0) return "";
  const std::size_t count = std::min<std::size_t>(out_->fault_trace.count, max_trace);
  struct stat status {};
  if (count == 0 || fstat(entry_.get(), &status) != 0) return "";
  const auto size = static_cast<std::size_t>(status.st_size);
  void* bytes = mmap(nullptr, size, PROT_READ, MAP_SHARED, entry_.get(), 0);
  if (bytes == MAP_FAILED) return "";
  // Copied once: the process may still write there.
  std::array<std::uint64_t, max_trace> trace;
  std::copy_n(out_->fault_trace.address.begin(), count, trace.begin());
  const FunctionNames found =
      functions_at({static_cast<const char*>(bytes), size}, {trace.data(), count});
  std::string lines, addresses;
  for (std::size_t i = 0; i < count; ++i) {
    char number[24];
    std::snprintf(number, sizeof number, "0x%" PRIx64, trace[i]);
    const std::string& name = found.names[i];
    lines +=
        "  " + std::string(number) + (name.empty() ? "" : " " + system::printable(name)) + "\n";
    addresses += " " + std::string(number);
  }
  munmap(bytes, size);
  return lines + "addr2line -Cfie FILE" + addresses +
         " names the lines, if FILE was built with -g\n";
}

// Waits until the process changes `answer`. While it loads, its calls wait for the server.
void ProcessController::wait_for_word(std::uint32_t seen, std::chrono::nanoseconds pause) {
  const bool is_loading = loading_.get() >= 0;
  if (!is_loading || has_loaded_) wait_while_equal(out_->answer, seen, pause);
  if (!is_loading) return;
  const auto patience = std::chrono::duration_cast<std::chrono::milliseconds>(pause);
  const auto step = allow_loading_step(loading_.get(), has_loaded_ ? patience.zero() : patience);
  if (step == LoadingStep::last) has_loaded_ = true;
}

// The time in which the server was stopped is not the team's, which may have been stopped, too.
void ProcessController::forgive_absence(double pause) {
  if (pause < min_absence) return;
  absent_ += pause;
  asked_at_ += wall_time(pause);
}

double ProcessController::seconds_without_delay(WallClock::time_point begin,
                                                std::optional<double> delay_at_begin) const {
  const double seconds = seconds_since(begin);
  const auto delay = delay_at_begin ? child_.processor_delay() : std::nullopt;
  return delay ? seconds - (*delay - *delay_at_begin) : seconds;
}

template <class Done>
std::optional<Answer> ProcessController::wait(Done done, const WaitLimit& limit,
                                              std::optional<WallClock::time_point> until) {
  auto looked = WallClock::now();  // the job may be stopped anywhere in the loop
  while (true) {
    if (done()) break;
    in_->is_awaited.store(1, std::memory_order_seq_cst);
    const std::uint32_t seen = out_->answer.load(std::memory_order_seq_cst);
    if (done()) break;
    std::chrono::nanoseconds pause = slice;
    if (until) pause = std::clamp<std::chrono::nanoseconds>(*until - WallClock::now(), {}, slice);
    wait_for_word(seen, pause);
    forgive_absence(seconds_since(std::exchange(looked, WallClock::now())));
    if (done()) break;
    terms_.meanwhile();
    if (const auto status = child_.exit_status()) return answer_to_exit(*status);
    if (is_stuck_in_its_report()) {
      child_.kill();
      return answer_to_exit({.exit_code = exit_faulted});
    }
    cpu_ = child_.cpu_seconds();
    const double used = cpu_ - cpu_at_post_;
    // If the team has crossed both limits since the last look, the limit that it met first counts.
    const bool is_bank_larger =
        !is_ready_ || bank_seconds() - (playing_seconds() - used) >= limit.cpu;
    const bool is_busy = used > limit.cpu && is_bank_larger;
    if (auto fault = is_busy ? std::nullopt : find_overdraft()) {
      child_.kill();
      return *fault;
    }
    if (!delay_at_slice_) delay_at_slice_ = child_.processor_delay();
    // While the team has not answered, it is the team that the server waits for.
    const double own_delay = Child::processor_delay(getpid()).value_or(0.0);
    forgiven_delay_ += own_delay - own_delay_at_slice_.value_or(own_delay);
    own_delay_at_slice_ = own_delay;
    if (is_busy || seconds_without_delay(asked_at_, delay_at_slice_) > limit.wall) {
      const TeamCall call = out_->team_call.load(std::memory_order_relaxed);
      child_.kill();
      return Fault{limit.fault, "the team used more than " +
                                    (is_busy ? seconds_text(limit.cpu) + " of processor time "
                                             : seconds_text(limit.wall) + " ") +
                                    limit.doing + (moment_ ? text_of(call, *moment_) : "")};
    }
    if (until && WallClock::now() >= *until) {
      in_->is_awaited.store(0, std::memory_order_relaxed);
      return match::Late{};
    }
  }
  in_->is_awaited.store(0, std::memory_order_relaxed);
  return std::nullopt;
}

tl::expected<void, Answer> ProcessController::wait_until_ready() {
  // The clock starts now, so the time in which the other team loaded does not count.
  asked_at_ = WallClock::now();
  delay_at_slice_.reset();
  own_delay_at_slice_.reset();
  if (auto failure = wait_for_sandbox()) return tl::unexpected<Answer>(*failure);
  const auto is_ready = [this] { return out_->load_state.load() == LoadState::ready; };
  const WaitLimit limit{.cpu = terms_.budget.start_cpu,
                        .wall = terms_.budget.start_wall,
                        .fault = FaultCode::start_timeout,
                        .doing = "to load its library and create its team"};
  if (auto problem = wait(is_ready, limit, std::nullopt)) return tl::unexpected(*problem);
  is_ready_ = true;
  loading_.reset();  // a team that says it is ready has loaded
  cpu_at_ready_ = cpu_ = child_.cpu_seconds();
  start_wall_ = seconds_since(posted_at_);
  return {};
}

void ProcessController::post(const match::Observation& observation) {
  assert(is_ready_);
  posted_at_ = WallClock::now();
  ++ticks_;
  // A team that still computes gets the newest observation after its answer. Without a deadline
  // this cannot happen.
  if (is_awaited_) return;
  is_awaited_ = true;
  is_placing_ = observation.placing;
  if (is_placing_) ++places_;
  asked_at_ = posted_at_;
  delay_at_slice_.reset();
  own_delay_at_slice_.reset();
  cpu_at_post_ = cpu_;
  moment_ = {observation.tick, observation.state};
  in_->observation = abi::to_observation(observation);
  in_->request.store(++request_, std::memory_order_release);
  terms_.bell->ask(in_->request);
}

Answer ProcessController::count_late_tick() {
  assert(terms_.deadline.has_value());
  ++late_;
  ++late_in_a_row_;
  if (late_in_a_row_ <= terms_.deadline->max_late_in_a_row && late_ <= terms_.deadline->max_late)
    return match::Late{};
  child_.kill();
  return Fault{FaultCode::hang,
               "the team was late " + (late_ > terms_.deadline->max_late
                                           ? std::to_string(late_) + " times in this leg"
                                           : std::to_string(late_in_a_row_) + " times in a row")};
}

// Returns the fault of a team that has used up its bank.
std::optional<Fault> ProcessController::find_overdraft() const {
  if (!is_ready_ || playing_seconds() <= bank_seconds()) return std::nullopt;
  return Fault{FaultCode::budget,
               "the team used up its processor time: " + seconds_text(terms_.budget.bank) + ", " +
                   std::to_string(1e3 * terms_.budget.bank_per_tick).substr(0, 4) +
                   " ms for each of " + std::to_string(ticks_) +
                   " ticks, and further time for each place()"};
}

// Returns the fault of a team that has used up its bank or slept too long by the end of a tick.
std::optional<Fault> ProcessController::find_overrun() {
  if (auto fault = find_overdraft()) return fault;
  if (has_slept_too_long())
    return Fault{FaultCode::hang,
                 "the team slept more than " + seconds_text(terms_.budget.sleep) + " in this leg",
                 "slept"};
  return std::nullopt;
}

// The time slept is the time that the server waited, less the processor time of the team, less the
// time that both had to wait for a processor: a busy machine is not the team's fault.
bool ProcessController::has_slept_too_long() {
  if (waited_ < terms_.budget.sleep || waited_ < next_sleep_check_) return false;
  next_sleep_check_ = waited_ + 1.0;
  const auto slept = slept_seconds();
  return slept && *slept > terms_.budget.sleep;
}

std::optional<double> ProcessController::slept_seconds() const {
  const auto own_delay = Child::processor_delay(getpid());
  const auto delay = child_.processor_delay();
  if (!own_delay || !delay) return std::nullopt;
  return waited_ - playing_seconds() - *delay - (*own_delay - forgiven_delay_);
}

Answer ProcessController::collect() {
  terms_.bell->ring();
  const auto is_answered = [this] {
    return out_->answer.load(std::memory_order_acquire) == request_;
  };
  const WaitLimit limit{
      .cpu = terms_.budget.tick_cpu + (is_placing_ ? terms_.budget.place_cpu : 0.0),
      .wall = terms_.budget.tick_wall,
      .fault = FaultCode::hang,
      .doing =
          is_placing_ ? "on one tick and place() and was stopped" : "on one tick and was stopped"};
  std::optional<WallClock::time_point> until;
  if (terms_.deadline) until = posted_at_ + wall_time(terms_.deadline->tick);
  if (!is_answered()) {
    const auto start = WallClock::now();
    const double absent_before = absent_;
    if (auto problem = wait(is_answered, limit, until))
      return std::holds_alternative<match::Late>(*problem) ? count_late_tick() : *problem;
    waited_ += seconds_since(start) - (absent_ - absent_before);
  }
  cpu_ = child_.cpu_seconds();
  is_awaited_ = false;
  late_in_a_row_ = 0;
  slowest_tick_ = std::max(slowest_tick_, cpu_ - cpu_at_post_);
  if (auto fault = find_overrun()) {
    child_.kill();
    return *fault;
  }
  read_log();  // in each tick, so that its lines know it
  // Copied once, so that the command that is checked is the one that is driven, even if the team
  // goes on writing.
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

const ThoughtsPage* ProcessController::thoughts() {
  if (thoughts_) copy_thoughts(out_->thoughts, *thoughts_);
  return thoughts_.get();
}

void ProcessController::read_log() {
  std::array<char, 1 << 14> buffer;
  // At most as much as a pipe holds, so that a team that keeps writing cannot keep the server here.
  for (int i = 0; i < 4; ++i) {
    const ssize_t n = read(log_pipe_.get(), buffer.data(), buffer.size());
    if (n <= 0) return;
    const std::string_view bytes(buffer.data(), static_cast<std::size_t>(n));
    moment_ ? log_.append(bytes, moment_->tick) : log_.append(bytes);
  }
}

std::string ProcessController::output(Ticks ticks) {
  read_log();
  return log_.text(ticks);
}

}  // namespace mirocup::plugins
