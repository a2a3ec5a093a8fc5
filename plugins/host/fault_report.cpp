// SPDX-License-Identifier: MIT
#include "plugins/host/fault_report.hpp"

#include "plugins/host/care.hpp"
#include "plugins/host/sandbox/signals.hpp"

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <dlfcn.h>
#include <iterator>
#include <link.h>
#include <ucontext.h>
#include <unistd.h>
#include <unwind.h>

namespace mirocup::plugins {

namespace {

constexpr int max_calls = 256;  // of all libraries together

struct Walk {
  const char* path;
  CrashTrace& trace;
  int calls = 0;
};

_Unwind_Reason_Code visit(_Unwind_Context* context, void* argument) {
  auto& walk = *static_cast<Walk*>(argument);
  int is_before = 0;  // 1: the address is that of an instruction that has not run
  std::uintptr_t address = _Unwind_GetIPInfo(context, &is_before);
  if (is_before == 0) --address;
  dl_find_object object{};
  if (_dl_find_object(reinterpret_cast<void*>(address), &object) == 0 &&
      std::strcmp(object.dlfo_link_map->l_name, walk.path) == 0) {
    walk.trace.address[walk.trace.count++] = address - object.dlfo_link_map->l_addr;
  }
  const bool is_over = walk.trace.count == max_trace || ++walk.calls == max_calls;
  return is_over ? _URC_NORMAL_STOP : _URC_NO_REASON;
}

// Fills `trace` with the active calls in the library that was loaded from `path`. A signal handler
// may call this function, because it allocates nothing and takes no lock. But it walks a stack that
// the crash may have damaged, so it may itself crash or never return. The caller must be ready for
// both cases.
void trace_calls(const char* path, CrashTrace& trace) {
  Walk walk{path, trace};
  _Unwind_Backtrace(visit, &walk);
}

// A global variable, because a signal handler gets no pointer of its own.
CommandPage* faulted_page = nullptr;

// A write to it is told as such.
const ObservationPage* lent_page = nullptr;

// The file that the team's library is loaded from.
const char* traced_path = "";

// True once a handler runs. One that crashes has nothing more to say.
volatile std::sig_atomic_t is_reporting = 0;

// The number of this process, which the team may see with an offset.
pid_t own_number = 0;

alignas(16) char stack[128 << 10];

// The codes of signals that the kernel sends are greater than 0. What another process sends, such
// as the SIGTERM for all processes of a job, is the host's affair: the server ends the leg.
bool is_from_another_process(const siginfo_t& info) {
  return info.si_code <= 0 && info.si_pid != own_number;
}

// An access at most this far from the stack pointer is one to the stack, bytes. A function touches
// its frame at some distance, and a large array may lie between.
constexpr std::uintptr_t max_frame = 16u << 20;
// Pointers to members of an object, or elements of an array, at address 0 are somewhat more than 0.
constexpr std::uintptr_t max_null = 64u << 10;

std::uintptr_t stack_pointer(const void* context) {
  const auto& registers = static_cast<const ucontext_t*>(context)->uc_mcontext;
#if defined(__x86_64__)
  return static_cast<std::uintptr_t>(registers.gregs[REG_RSP]);
#else
  return registers.sp;
#endif
}

AddressKind kind_of_address(int signal, const siginfo_t& info, const void* context) {
  if (signal != SIGSEGV && signal != SIGBUS) return AddressKind::unknown;
  const auto address = reinterpret_cast<std::uintptr_t>(info.si_addr);
  // The processor tells no address if it is none of the 48 bits that it knows.
  if (address < max_null) return info.si_code == SI_KERNEL ? AddressKind::other : AddressKind::null;
  const auto lent = reinterpret_cast<std::uintptr_t>(lent_page);
  if (address >= lent && address - lent < sizeof(ObservationPage)) return AddressKind::observation;
  const std::uintptr_t top = stack_pointer(context);
  const std::uintptr_t distance = address > top ? address - top : top - address;
  return distance < max_frame ? AddressKind::end_of_stack : AddressKind::other;
}

void report(int signal, siginfo_t* info, void* context) {
  if (is_from_another_process(*info)) return;
  if (is_reporting != 0) _exit(exit_faulted);
  is_reporting = 1;
  write_requests(faulted_page->requests, sizeof faulted_page->requests);
  faulted_page->fault_address.store(kind_of_address(signal, *info, context),
                                    std::memory_order_relaxed);
  faulted_page->fault_call.store(signal == SIGSYS ? info->si_syscall : no_call,
                                 std::memory_order_relaxed);
  faulted_page->fault_signal.store(signal, std::memory_order_release);
  // The rest is a help to the author. The server does not wait for it for long.
  CrashTrace& trace = faulted_page->fault_trace;
  trace.count = 0;
  trace_calls(traced_path, trace);
  if (trace.count == 0 && faulted_page->fault_address == AddressKind::other &&
      faulted_page->team_call != TeamCall::none)
    faulted_page->fault_address = AddressKind::lost;
  faulted_page->fault_is_traced.store(1, std::memory_order_release);
  _exit(exit_faulted);
}

}  // namespace

bool report_faults_to(CommandPage& page, const char* library, const ObservationPage* lent) {
  faulted_page = &page;
  lent_page = lent;
  traced_path = library;
  own_number = getpid();
  stack_t alternative{};
  alternative.ss_sp = stack;
  alternative.ss_size = sizeof stack;
  if (sigaltstack(&alternative, nullptr) != 0) return false;
  struct sigaction action {};
  action.sa_sigaction = report;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_RESTART | SA_NODEFER;
  const auto handle = [&action](int signal) { return sigaction(signal, &action, nullptr) == 0; };
  sigset_t none;
  sigemptyset(&none);
  return handle(SIGSYS) &&
         std::all_of(std::begin(processor_signals), std::end(processor_signals), handle) &&
         std::all_of(std::begin(ending_signals), std::end(ending_signals), handle) &&
         sigprocmask(SIG_SETMASK, &none, nullptr) == 0;
}

}  // namespace mirocup::plugins
