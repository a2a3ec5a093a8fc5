// SPDX-License-Identifier: MIT
#include "plugins/host/process_controller.hpp"

#include "plugins/host/convert.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

namespace mirocup::plugins {

namespace {

using match::Answer;
using match::Fault;
using match::FaultCode;
using match::HostFailure;
using std::chrono::steady_clock;

// The death of a process wakes nobody, so every wait is cut into slices.
constexpr std::chrono::milliseconds slice{2};

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) close(fd_);
  }
  int get() const { return fd_; }
  int release() { return std::exchange(fd_, -1); }

 private:
  int fd_;
};

// A sealed piece of memory of that size, mapped here for writing.
template <class Page>
Page* make_page(int fd) {
  if (ftruncate(fd, sizeof(Page)) != 0) return nullptr;
  void* page = mmap(nullptr, sizeof(Page), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
  if (page == MAP_FAILED) return nullptr;
  return new (page) Page{};
}

tl::unexpected<Error> no_memory(const char* what) {
  return fail(Errc::host, std::string(what) + ": " + std::strerror(errno));
}

}  // namespace

Result<std::unique_ptr<ProcessController>> ProcessController::start(const std::string& host_program,
                                                                    const std::string& library,
                                                                    const match::Briefing& briefing,
                                                                    const ProcessLimits& limits) {
  const Descriptor in_fd(memfd_create("observation", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  const Descriptor out_fd(memfd_create("command", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  ObservationPage* in = make_page<ObservationPage>(in_fd.get());
  CommandPage* out = make_page<CommandPage>(out_fd.get());
  if (in == nullptr || out == nullptr) return no_memory("the mailbox of a team cannot be made");
  // From now on nobody can map the observations for writing, or shrink either page under the
  // server.
  fcntl(in_fd.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_FUTURE_WRITE | F_SEAL_SEAL);
  fcntl(out_fd.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL);
  in->setup = to_setup(briefing);

  int pipe_ends[2];
  if (pipe2(pipe_ends, O_CLOEXEC | O_NONBLOCK) != 0) return no_memory("a pipe cannot be made");
  Descriptor output(pipe_ends[0]);
  const Descriptor child_output(pipe_ends[1]);

  auto child = Child::start(host_program,
                            {std::to_string(in_fd.get()), std::to_string(out_fd.get()), library},
                            {in_fd.get(), out_fd.get()}, child_output.get());
  if (!child) return tl::unexpected(child.error());
  return std::unique_ptr<ProcessController>(
      new ProcessController(std::move(*child), in, out, output.release(), limits));
}

ProcessController::ProcessController(Child child, ObservationPage* in, CommandPage* out, int output,
                                     const ProcessLimits& limits)
    : child_(std::move(child)), in_(in), out_(out), output_(output), limits_(limits) {}

ProcessController::~ProcessController() {
  child_.kill();
  munmap(in_, sizeof *in_);
  munmap(out_, sizeof *out_);
  close(output_);
}

Answer ProcessController::death(const Ending& ending) {
  // A process that refused said why before it ended.
  if (ending.signal == 0 && ending.exit_code == 1) {
    char text[sizeof out_->text];
    std::memcpy(text, out_->text, sizeof text);
    text[sizeof text - 1] = '\0';
    switch (out_->load_state.load(std::memory_order_acquire)) {
      case LoadState::no_load:
        return Fault{FaultCode::no_load, text};
      case LoadState::bad_abi:
        return Fault{FaultCode::bad_abi, text};
      case LoadState::crash:
        return Fault{FaultCode::crash, text};
      case LoadState::loading:
      case LoadState::ready:
        break;
    }
  }
  if (ending.signal == SIGKILL) {
    return HostFailure{
        "a team's process was killed from outside: out of memory, or a cancelled job"};
  }
  return Fault{FaultCode::crash, "the team's process " + ending.text()};
}

template <class Done>
std::optional<Answer> ProcessController::wait(Done done, double cpu_limit, double wall_limit,
                                              FaultCode late, const char* doing) {
  const auto begin = steady_clock::now();
  const double cpu_begin = cpu_;
  while (true) {
    const std::uint32_t seen = out_->answer.load(std::memory_order_acquire);
    if (done()) break;
    wait_while_equal(out_->answer, seen, slice);
    if (done()) break;
    if (const auto ending = child_.ending()) return death(*ending);
    cpu_ = child_.cpu_seconds();
    const double wall = std::chrono::duration<double>(steady_clock::now() - begin).count();
    if (cpu_ - cpu_begin <= cpu_limit && wall <= wall_limit) continue;
    child_.kill();
    const bool busy = cpu_ - cpu_begin > cpu_limit;
    return Fault{late, std::string("the team used more than ") +
                           std::to_string(static_cast<int>(busy ? cpu_limit : wall_limit)) +
                           (busy ? " s of processor time " : " s ") + doing};
  }
  cpu_ = child_.cpu_seconds();
  return std::nullopt;
}

tl::expected<void, Answer> ProcessController::wait_until_ready() {
  const auto is_ready = [this] { return out_->load_state.load() == LoadState::ready; };
  if (auto problem = wait(is_ready, limits_.start_cpu, limits_.start_wall, FaultCode::start_timeout,
                          "to load and create its team")) {
    return tl::unexpected(*problem);
  }
  return {};
}

void ProcessController::post(const match::Observation& observation) {
  in_->observation = to_observation(observation);
  in_->request.store(++request_, std::memory_order_release);
  wake(in_->request);
}

Answer ProcessController::collect() {
  const double before = cpu_;
  const auto is_answered = [this] {
    return out_->answer.load(std::memory_order_acquire) == request_;
  };
  if (auto problem = wait(is_answered, limits_.tick_cpu, limits_.tick_wall, FaultCode::hang,
                          "on one tick and was stopped")) {
    return *problem;
  }
  slowest_tick_ = std::max(slowest_tick_, cpu_ - before);
  const mirocup_command copy = out_->command;
  return to_command(copy);
}

std::string ProcessController::output() {
  std::string text;
  char buffer[4096];
  while (true) {
    const ssize_t n = read(output_, buffer, sizeof buffer);
    if (n <= 0) return text;
    text.append(buffer, static_cast<std::size_t>(n));
  }
}

}  // namespace mirocup::plugins
