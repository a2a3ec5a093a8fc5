// SPDX-License-Identifier: MIT
#include "plugins/host/sandbox/filter.hpp"

#include "plugins/host/sandbox/signals.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <iterator>
#include <linux/futex.h>
#include <linux/seccomp.h>
#include <memory>
#include <poll.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

namespace mirocup::plugins {

namespace {

// Calls that are allowed without a condition, grouped by purpose.
constexpr const char* memory[] = {"brk", "mmap", "munmap", "mremap", "mprotect", "madvise"};
constexpr const char* time_and_waiting[] = {
    "gettimeofday", "time",  "nanosleep", "sched_yield", "pause",
    "poll",         "ppoll", "select",    "pselect6",    "restart_syscall"};
constexpr const char* own_signals[] = {"rt_sigprocmask", "rt_sigreturn",  "sigaltstack",
                                       "rt_sigpending",  "rt_sigsuspend", "rt_sigtimedwait"};
constexpr const char* facts_about_itself[] = {
    "getpid",  "gettid",    "getppid",         "getuid",          "geteuid", "getgid",
    "getegid", "getresuid", "getresgid",       "getgroups",       "getpgrp", "getrusage",
    "times",   "getcpu",    "getrandom",       "set_tid_address", "rseq",    "uname",
    "sysinfo", "getrlimit", "set_robust_list", "arch_prctl"};
// Calls that take the number of a process first, and are allowed about the own one only.
constexpr const char* facts_about_a_process[] = {"getpgid", "getsid", "sched_getaffinity",
                                                 "sched_getscheduler", "sched_getparam"};
// Calls that take a clock first.
constexpr const char* clock_calls[] = {"clock_gettime", "clock_getres", "clock_nanosleep"};
constexpr const char* open_files[] = {"read",  "write", "readv",       "writev", "pread64",
                                      "close", "lseek", "close_range", "fstat",  "newfstatat"};
constexpr const char* loading[] = {"openat", "landlock_create_ruleset", "landlock_restrict_self"};
constexpr const char* call_when_loaded = "landlock_restrict_self";
constexpr const char* end[] = {"exit", "exit_group"};

// Calls that return an error, grouped by the error.
constexpr const char* not_permitted[] = {
    "sched_setaffinity", "sched_setscheduler", "sched_setparam", "sched_setattr", "setpriority",
    "ioprio_set",        "setrlimit",          "mlock",          "mlock2",        "mlockall",
    "munlock",           "munlockall"};
constexpr const char* no_access[] = {"open",   "access", "faccessat", "faccessat2",
                                     "stat",   "lstat",  "readlink",  "readlinkat",
                                     "getcwd", "socket", "socketpair"};
constexpr const char* list_folder = "getdents64";
constexpr const char* file_system = "statfs";  // some modules of Python ask for it
// OpenBLAS, which numpy loads, asks for memory near its processor and does without.
constexpr const char* not_there[] = {"statx",         "clone3",        "membarrier",
                                     "set_mempolicy", "get_mempolicy", "mbind"};
constexpr const char* no_descriptors[] = {
    "dup",     "dup2",          "dup3",         "pipe",           "pipe2",        "eventfd2",
    "eventfd", "epoll_create1", "epoll_create", "timerfd_create", "inotify_init1"};
constexpr const char* try_again[] = {"clone", "fork", "vfork"};

constexpr int futex_operations[] = {FUTEX_WAIT,       FUTEX_WAKE,        FUTEX_REQUEUE,
                                    FUTEX_WAKE_OP,    FUTEX_CMP_REQUEUE, FUTEX_WAIT_BITSET,
                                    FUTEX_WAKE_BITSET};

// The bits that no clock of the system has in its number (CLOCK_REALTIME 0 to CLOCK_TAI 11). Other
// numbers are the processor time of a process, which in tier T1 could be the opponent's.
constexpr std::uint32_t not_a_system_clock = 0xfffffff0;

// Flags of openat() that would let a process change something.
constexpr unsigned writing_flags[] = {O_WRONLY, O_RDWR, O_CREAT, O_TRUNC, O_APPEND, O_PATH};

// A filter under construction. Rules for calls that the kernel or the architecture does not know
// are left out, which allows nothing.
class Filter {
 public:
  explicit Filter(std::uint32_t otherwise) : context_(seccomp_init(otherwise), seccomp_release) {
    if (context_ == nullptr) return;
    seccomp_attr_set(context_.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
    seccomp_attr_set(context_.get(), SCMP_FLTATR_CTL_NNP, 0);  // limit_this_process() has set it
    seccomp_attr_set(context_.get(), SCMP_FLTATR_CTL_OPTIMIZE, 2);  // a tree, not a list
  }

  template <class... Conditions>
  void add(std::uint32_t action, const char* name, Conditions... conditions) {
    if (context_ == nullptr) return;
    const int call = seccomp_syscall_resolve_name(name);
    if (call == __NR_SCMP_ERROR) return;
    const int result =
        seccomp_rule_add(context_.get(), action, call, sizeof...(conditions), conditions...);
    if (result != 0 && error_ == 0) error_ = -result;
  }

  template <std::size_t n>
  void add_all(std::uint32_t action, const char* const (&names)[n]) {
    for (const char* name : names) add(action, name);
  }

  bool load() {
    if (context_ == nullptr) {
      errno = ENOMEM;
      return false;
    }
    const int result = error_ != 0 ? -error_ : seccomp_load(context_.get());
    if (result != 0) errno = -result;
    return result == 0;
  }

  // Only after load(), of a filter with SCMP_ACT_NOTIFY.
  int supervisor() const { return seccomp_notify_fd(context_.get()); }

 private:
  std::unique_ptr<void, void (*)(scmp_filter_ctx)> context_;
  int error_ = 0;
};

// Compares the lower half of an argument: the kernel reads no more of an int, whatever the team
// puts into the upper half.
scmp_arg_cmp low_word(unsigned argument, std::uint32_t value) {
  return {argument, SCMP_CMP_MASKED_EQ, 0xffffffff, value};
}

// The numbers by which this process, which has one thread, can name itself.
std::array<std::uint32_t, 2> own_numbers() {
  return {0, static_cast<std::uint32_t>(getpid())};
}

// The clocks of this process's processor time. The kernel makes their numbers of the process's
// number, the kind of time and a bit for threads.
std::vector<std::uint32_t> own_clocks() {
  std::vector<std::uint32_t> clocks;
  for (const std::uint32_t id : own_numbers()) {
    for (std::uint32_t kind = 0; kind < 3; ++kind) {
      for (const std::uint32_t thread : {0u, 4u}) clocks.push_back(~id << 3 | thread | kind);
    }
  }
  return clocks;
}

template <std::size_t n>
bool is_one_of(const int (&signals)[n], int signal) {
  return std::find(std::begin(signals), std::end(signals), signal) != std::end(signals);
}

constexpr int first_real_time_signal = 32;

void allow_own_signals(Filter& filter) {
  const auto process = static_cast<std::uint32_t>(getpid());
  for (int signal = 1; signal < first_real_time_signal; ++signal) {
    const auto number = static_cast<std::uint32_t>(signal);
    // For abort() and raise(). A processor's signal that is only sent would end the team in one
    // tier and not in the other, so it is not sent.
    if (is_one_of(processor_signals, signal)) {
      filter.add(SCMP_ACT_ERRNO(EPERM), "tgkill", low_word(0, process), low_word(2, number));
    } else if (!is_one_of(signals_of_the_host, signal)) {
      filter.add(SCMP_ACT_ALLOW, "tgkill", low_word(0, process), low_word(2, number));
    }
    // The filter itself uses SIGSYS.
    if (signal == SIGSYS || is_one_of(ending_signals, signal)) {
      filter.add(SCMP_ACT_ALLOW, "rt_sigaction", low_word(0, number),
                 scmp_arg_cmp{1, SCMP_CMP_EQ, 0, 0});
      filter.add(SCMP_ACT_ERRNO(EPERM), "rt_sigaction", low_word(0, number),
                 scmp_arg_cmp{1, SCMP_CMP_NE, 0, 0});
    } else {
      filter.add(SCMP_ACT_ALLOW, "rt_sigaction", low_word(0, number));
    }
  }
  // The C library takes two of them when it wants to start a thread.
  filter.add(SCMP_ACT_ALLOW, "rt_sigaction",
             scmp_arg_cmp{0, SCMP_CMP_GE, first_real_time_signal, 0});
}

void allow_some_forms(Filter& filter) {
  const auto is = [](unsigned argument, scmp_datum_t value) {
    return scmp_arg_cmp{argument, SCMP_CMP_EQ, value, 0};
  };
  for (const int operation : futex_operations) {
    const auto mask = static_cast<scmp_datum_t>(FUTEX_CMD_MASK & 0xffffffff);
    filter.add(SCMP_ACT_ALLOW, "futex",
               scmp_arg_cmp{1, SCMP_CMP_MASKED_EQ, mask, static_cast<scmp_datum_t>(operation)});
  }
  allow_own_signals(filter);
  for (const int command : {F_GETFD, F_SETFD, F_GETFL}) {
    filter.add(SCMP_ACT_ALLOW, "fcntl", is(1, static_cast<scmp_datum_t>(command)));
  }
  for (const int command : {F_DUPFD, F_DUPFD_CLOEXEC}) {
    filter.add(SCMP_ACT_ERRNO(EMFILE), "fcntl", is(1, static_cast<scmp_datum_t>(command)));
  }
  for (const std::uint32_t id : own_numbers()) {
    filter.add(SCMP_ACT_ALLOW, "prlimit64", low_word(0, id), is(2, 0));
    filter.add(SCMP_ACT_ALLOW, "getpriority", low_word(0, PRIO_PROCESS), low_word(1, id));
    for (const char* call : facts_about_a_process) {
      filter.add(SCMP_ACT_ALLOW, call, low_word(0, id));
    }
  }
  for (const char* call : clock_calls) {
    filter.add(SCMP_ACT_ALLOW, call, scmp_arg_cmp{0, SCMP_CMP_MASKED_EQ, not_a_system_clock, 0});
  }
  for (const std::uint32_t clock : own_clocks()) {
    filter.add(SCMP_ACT_ALLOW, "clock_gettime", low_word(0, clock));
    filter.add(SCMP_ACT_ALLOW, "clock_getres", low_word(0, clock));
  }
  filter.add(SCMP_ACT_ERRNO(EPERM), "prlimit64", scmp_arg_cmp{2, SCMP_CMP_NE, 0, 0});
  static_assert(PR_SET_NAME + 1 == PR_GET_NAME);
  filter.add(SCMP_ACT_ALLOW, "prctl", is(0, PR_SET_NAME));
  filter.add(SCMP_ACT_ALLOW, "prctl", is(0, PR_GET_NAME));
  filter.add(SCMP_ACT_ERRNO(EPERM), "prctl", scmp_arg_cmp{0, SCMP_CMP_LT, PR_SET_NAME, 0});
  filter.add(SCMP_ACT_ERRNO(EPERM), "prctl", scmp_arg_cmp{0, SCMP_CMP_GT, PR_GET_NAME, 0});
  // Allowed for phase 2, but without the flags that would return a listener or fill the kernel's
  // log.
  filter.add(SCMP_ACT_ALLOW, "seccomp", is(0, SECCOMP_SET_MODE_FILTER), is(1, 0));
  filter.add(SCMP_ACT_ERRNO(EFAULT), "seccomp", is(0, SECCOMP_GET_ACTION_AVAIL));
}

// A filter of its own, because a second filter can only take rights away: whatever the other one
// allows, files can be opened for reading only.
bool open_for_reading_only() {
  Filter filter(SCMP_ACT_ALLOW);
  for (const unsigned flag : writing_flags) {
    filter.add(SCMP_ACT_ERRNO(EACCES), "openat", scmp_arg_cmp{2, SCMP_CMP_MASKED_EQ, flag, flag});
  }
  return filter.load();
}

}  // namespace

bool filter_for_loading(Folders folders) {
  if (!open_for_reading_only()) return false;
  Filter filter(SCMP_ACT_TRAP);
  filter.add_all(SCMP_ACT_ALLOW, memory);
  filter.add_all(SCMP_ACT_ALLOW, time_and_waiting);
  filter.add_all(SCMP_ACT_ALLOW, own_signals);
  filter.add_all(SCMP_ACT_ALLOW, facts_about_itself);
  filter.add_all(SCMP_ACT_ALLOW, open_files);
  filter.add_all(SCMP_ACT_ALLOW, loading);
  filter.add_all(SCMP_ACT_ALLOW, end);
  allow_some_forms(filter);
  filter.add_all(SCMP_ACT_ERRNO(EPERM), not_permitted);
  filter.add_all(SCMP_ACT_ERRNO(EACCES), no_access);
  filter.add(folders == Folders::listed ? SCMP_ACT_ALLOW : SCMP_ACT_ERRNO(EACCES), list_folder);
  if (folders == Folders::listed) filter.add(SCMP_ACT_ERRNO(EACCES), file_system);
  filter.add_all(SCMP_ACT_ERRNO(ENOSYS), not_there);
  filter.add_all(SCMP_ACT_ERRNO(EMFILE), no_descriptors);
  filter.add_all(SCMP_ACT_ERRNO(EAGAIN), try_again);
  filter.add(SCMP_ACT_ERRNO(ENOTTY), "ioctl");
  return filter.load();
}

int ask_before_loading() {
  Filter filter(SCMP_ACT_ALLOW);
  filter.add(SCMP_ACT_NOTIFY, "openat");
  filter.add(SCMP_ACT_NOTIFY, "newfstatat");
  filter.add(SCMP_ACT_NOTIFY, call_when_loaded);
  for (const char* call : {"mmap", "mprotect"}) {
    filter.add(SCMP_ACT_NOTIFY, call, scmp_arg_cmp{2, SCMP_CMP_MASKED_EQ, PROT_EXEC, PROT_EXEC});
  }
  return filter.load() ? filter.supervisor() : -1;
}

LoadingStep allow_loading_step(int supervisor, std::chrono::milliseconds patience) {
  static const int last = seccomp_syscall_resolve_name(call_when_loaded);
  pollfd asked{supervisor, POLLIN, 0};
  if (poll(&asked, 1, static_cast<int>(patience.count())) <= 0) return LoadingStep::none;
  seccomp_notif* call = nullptr;
  seccomp_notif_resp* answer = nullptr;
  if (seccomp_notify_alloc(&call, &answer) != 0) return LoadingStep::none;
  LoadingStep step = LoadingStep::none;
  // Fails if the process was killed meanwhile.
  if (seccomp_notify_receive(supervisor, call) == 0) {
    answer->id = call->id;
    answer->flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
    seccomp_notify_respond(supervisor, answer);
    step = call->data.nr == last ? LoadingStep::last : LoadingStep::more;
  }
  seccomp_notify_free(call, answer);
  return step;
}

bool filter_for_playing() {
  Filter filter(SCMP_ACT_ALLOW);
  filter.add(SCMP_ACT_ERRNO(EACCES), "openat");
  filter.add(SCMP_ACT_ERRNO(EACCES), "newfstatat");
  for (const char* call : {"mmap", "mprotect"}) {
    filter.add(SCMP_ACT_ERRNO(EACCES), call,
               scmp_arg_cmp{2, SCMP_CMP_MASKED_EQ, PROT_EXEC, PROT_EXEC});
  }
  for (const char* call : {"seccomp", "landlock_create_ruleset", "landlock_restrict_self"}) {
    filter.add(SCMP_ACT_TRAP, call);
  }
  return filter.load();
}

std::string system_call_name(int number) {
  const std::unique_ptr<char, void (*)(void*)> name(
      seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, number), std::free);
  return name != nullptr ? std::string(name.get()) : "number " + std::to_string(number);
}

}  // namespace mirocup::plugins
