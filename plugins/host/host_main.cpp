// SPDX-License-Identifier: MIT
//
// mirocup-plugin-host T1|T2: runs one team in a process of its own. Only the match server starts
// it, with the descriptors of launch.hpp. mirocup-careful-host is the same with another care.hpp,
// mirocup-python-host with another guest.hpp.
//
// It enters the sandbox, loads the library, restricts itself further, and answers observations
// until it is killed. No code of the library, its constructors included, runs before the sandbox
// stands.
#include "plugins/host/care.hpp"
#include "plugins/host/fault_report.hpp"
#include "plugins/host/guest.hpp"
#include "plugins/host/launch.hpp"
#include "plugins/host/mailbox.hpp"
#include "plugins/host/sandbox/descriptor_packet.hpp"
#include "plugins/host/sandbox/file_access.hpp"
#include "plugins/host/sandbox/filter.hpp"
#include "plugins/host/sandbox/private_root.hpp"
#include "plugins/host/team_clocks.hpp"
#include "plugins/host/team_host.hpp"
#include "system/memory.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <malloc.h>
#include <string>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

using namespace mirocup;
using namespace mirocup::plugins;

namespace {

template <class Page>
Page* map(int descriptor, int protection) {
  void* page = mmap(nullptr, sizeof(Page), protection, MAP_SHARED, descriptor, 0);
  close(descriptor);
  return page == MAP_FAILED ? nullptr : static_cast<Page*>(page);
}

LoadState state_of(match::FaultCode code) {
  if (code == match::FaultCode::no_load) return LoadState::no_load;
  return code == match::FaultCode::bad_abi ? LoadState::bad_abi : LoadState::crash;
}

// Reports the team's fault on the page and ends the process.
[[noreturn]] void refuse(CommandPage& page, const match::Fault& fault) {
  page.text[fault.text.copy(page.text, sizeof page.text - 1)] = '\0';
  page.cause[fault.cause.copy(page.cause, sizeof page.cause - 1)] = '\0';
  page.refusal_line.store(fault.line, std::memory_order_relaxed);
  page.load_state.store(state_of(fault.code), std::memory_order_release);
  wake(page.answer);
  _exit(exit_refused);
}

// Calls the team below all frames of the host. Memory of a frame that a call left behind then holds
// what the team wrote, and not what the host left there while it waited: a team that reads such
// memory by mistake plays the same leg again.
template <class Call>
[[gnu::noinline]] auto below_host(Call& call) {
  constexpr std::size_t frames_of_host = 16u << 10;
  std::array<char, frames_of_host> gap;
  asm volatile("" : : "r"(gap.data()) : "memory");  // so that it is not left out
  return call();
}

// Runs a call of the team, which returns what a Plugin's functions return, or ends the process.
template <class Call>
auto with_care(CommandPage& page, TeamCall what, Call call) {
  page.team_call.store(what, std::memory_order_relaxed);
  pass_time_between_calls();
  before_call();
  auto answer = below_host(call);
  const Mistake mistake = after_call();
  write_requests(page.requests, sizeof page.requests);
  if (mistake.text != nullptr) refuse(page, {match::FaultCode::crash, mistake.text, mistake.cause});
  if (!answer) refuse(page, answer.error());
  return answer;
}

// Reports that the sandbox cannot be built, which is a failure of the host, and ends the process.
[[noreturn]] void give_up(const char* step) {
  const std::string text = std::string(step) + ": " + std::strerror(errno);
  (void)!write(setup_descriptor, text.data(), text.size());
  _exit(127);
}

// Keeps memory that the team frees, because getting it from the kernel again costs page faults.
void keep_memory() {
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
  mallopt(M_MMAP_THRESHOLD, 64 << 20);
}

// Gives the server the word over what loading needs. Not every system has this; without it the
// sandbox stands as well.
void let_the_server_end_loading() {
  const int supervisor = ask_before_loading();
  if (supervisor < 0) return;
  if (!send_descriptor(setup_descriptor, supervisor)) give_up("the end of loading");
  close(supervisor);
}

// A resource limit of a team's process.
struct Limit {
  __rlimit_resource_t resource;
  rlim_t value;
};

// The processor time has no limit here: with RLIMIT_CPU the kernel lets the clock of the process's
// time step in 4 ms, and a long leg may take hours. The server's budgets end a team, and so does
// the death of the server.
constexpr Limit limits[] = {
    {RLIMIT_AS, system::memory_of_a_team},
    {RLIMIT_STACK, 8u << 20},
    {RLIMIT_FSIZE, 0},
    {RLIMIT_NOFILE, 16},
    {RLIMIT_NPROC, 1},
    {RLIMIT_CORE, 0},
    {RLIMIT_MEMLOCK, 0},
    {RLIMIT_MSGQUEUE, 0},
    {RLIMIT_SIGPENDING, 16},
    {RLIMIT_LOCKS, 0},
};

// Where the host has a limit of processor time, only its hard one is left, which ends the process
// by SIGKILL: a failure of the host. The soft one would look like a crash of the team.
bool leave_only_the_hosts_limit_of_time() {
  rlimit time{};
  if (getrlimit(RLIMIT_CPU, &time) != 0) return false;
  time.rlim_cur = time.rlim_max;
  return setrlimit(RLIMIT_CPU, &time) == 0;
}

// Limits the resources of this process. From now on this process cannot gain privileges, no other
// process can trace it, and it dies with its parent. Returns false on failure; errno says why.
bool limit_this_process() {
  for (const Limit& limit : limits) {
    const rlimit both{limit.value, limit.value};
    if (setrlimit(limit.resource, &both) != 0) return false;
  }
  if (!leave_only_the_hosts_limit_of_time()) return false;
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_DUMPABLE, 0) == 0 &&
         prctl(PR_SET_PDEATHSIG, SIGKILL) == 0;
}

// Builds the first part of the sandbox. Returns the path to load the library from.
const char* enter_sandbox(Isolation isolation, CommandPage& page, const ObservationPage* lent) {
  const bool has_namespaces = isolation == Isolation::T2;
  // In tier T1 the library has no path of its own; Landlock does not restrict sealed memory.
  static_assert(entry_descriptor == 6);
  const char* library = has_namespaces ? private_entry_path : "/proc/self/fd/6";
  if (!limit_this_process()) give_up("limits");
  if (!report_faults_to(page, library, lent)) give_up("fault handlers");
  if (!allow_libraries_only(has_namespaces ? private_entry_path : nullptr, folders_of_guest()))
    give_up("Landlock");
  let_the_server_end_loading();
  if (!filter_for_loading(folders_of_guest())) give_up("the filter of system calls");
  if (write(setup_descriptor, &sandbox_stands, 1) != 1) _exit(127);
  close(setup_descriptor);
  return library;
}

}  // namespace

int main(int argc, char** argv) {
  const auto isolation = argc == 2 ? from_string<Isolation>(argv[1]) : std::nullopt;
  if (!isolation) return 2;
  const auto* in = map<const ObservationPage>(observation_descriptor, PROT_READ);
  auto* out = map<CommandPage>(command_descriptor, PROT_READ | PROT_WRITE);
  if (in == nullptr || out == nullptr) give_up("the mailbox");
  keep_memory();
  const char* library = enter_sandbox(*isolation, *out, in);

  start_clocks(in->surroundings.clocks);
  begin_care(in->surroundings);
  mirocup_setup setup = in->setup;
  TeamHost host{&in->parameters, &out->asked_parameters};
  if (in->keeps_thoughts != 0) host.thoughts = &out->thoughts;
  give_host(setup, host);
  // A line that a team prints is there at once, and so knows its tick.
  (void)std::setvbuf(stdout, nullptr, _IOLBF, 0);
  auto plugin = with_care(*out, TeamCall::create, [&] { return load_guest(library, setup); });
  close(entry_descriptor);
  if (!allow_no_files() || !filter_for_playing())
    refuse(*out, {match::FaultCode::crash, "the library changed the sandbox while it was loaded"});
  const std::string name = plugin->name();
  note_own_name(host, name);
  std::memcpy(out->name, name.data(), std::min(name.size(), sizeof out->name - 1));
  out->load_state.store(LoadState::ready, std::memory_order_release);
  wake(out->answer);

  std::uint32_t answered = 0;
  while (true) {
    std::uint32_t request = in->request.load(std::memory_order_acquire);
    while (request == answered) {
      wait_while_equal(in->request, answered);
      request = in->request.load(std::memory_order_acquire);
    }
    if (host.thoughts != nullptr) host.thoughts->clear();
    host.shapes = 0;
    if (in->observation.placing != 0) {
      out->placement =
          *with_care(*out, TeamCall::place, [&] { return plugin->place(lend(in->observation)); });
      note_units(host, out->placement, in->observation.robots);
    }
    out->command = *with_care(*out, TeamCall::decide, [&] {
      return plugin->decide(lend(in->observation), lend_command());
    });
    note_command(host, out->command, in->observation.robots);
    answered = request;
    // Sequentially consistent, as the server's side is: the server sets is_awaited and then reads
    // the answer once more, so that no wake-up is lost.
    out->answer.store(request, std::memory_order_seq_cst);
    if (in->is_awaited.load(std::memory_order_seq_cst) != 0) wake(out->answer);
  }
}
