// SPDX-License-Identifier: MIT
//
// Every kind of hostile strategy (kinds/NAME.c) and the outcome of its leg.
//
// "plays": the leg goes to its end, because the attempt returned an error or harms only the team.
// Any other outcome is the code of the fault and, after a colon, a part of its sentence.
#pragma once

#include <string>
#include <vector>

namespace mirocup {

struct Kind {
  std::string name;
  std::string outcome;  // in tier T2
  std::string in_t1;    // in T1 if it differs: an attack on something that T2 hides
};

// A team that burns processor time is stopped by the budget of processor time or, on a busy
// machine, by the limit of wall time.
inline const std::string burns_tick = "hang: processor time|hang: more than 10 s on one tick";
inline const std::string burns_bank = "budget: processor time|hang: more than 10 s on one tick";
inline const std::string burns_start =
    "start_timeout: 2 s of processor time|start_timeout: more than 6 s";
inline constexpr const char* start_limit = "2";  // s, for these kinds: MIROCUP_START_LIMIT

inline const std::vector<Kind> kinds{
    // Strategies that end their process.
    {"crash_heap", "crash: signal 6", ""},
    {"crash_segv", "crash: signal 11", ""},
    {"crash_stack", "crash: signal 11", ""},
    {"stack_frames", "crash: signal 11", ""},
    {"stack_no_signal_stack", "crash: signal 11", ""},
    {"exit_zero", "crash: exit code 0", ""},
    {"exit_like_the_host", "crash: exit code 127", ""},
    {"exit_thread", "crash", ""},
    {"false_verdict", "crash", ""},
    {"exit_slowly", burns_tick, ""},
    {"longjmp_out", "crash: signal 11", ""},
    {"throw_std", "crash: thrown on purpose", ""},
    {"throw_escapes", "crash: \\x1b[2J\\xff\\xe2\\x80\\xaered", ""},
    {"sig_raise", "crash: signal 1", ""},
    {"sig_sent_fault", "plays", ""},
    {"sig_kill_self", "illegal_call: tgkill", ""},
    {"sig_blocked", "illegal_call", ""},
    // Strategies that take time.
    {"loop_forever", burns_tick, ""},
    {"sleep_forever", "hang: 10 s", ""},
    {"sleep_often", "hang: slept more than 10 s", ""},
    {"futex_hold", "hang: 10 s", ""},
    {"sig_immortal", burns_tick, ""},
    {"sig_catch_segv", burns_tick, ""},
    {"futex_storm", "plays", ""},
    {"slow_every_tick", "plays", ""},
    {"slow_then_spin", burns_bank, ""},
    {"slow_bank", burns_bank, ""},
    {"clock_random", "plays", ""},
    {"clock_seed", "plays", ""},
    {"clock_wait", "hang: 10 s", ""},
    // Strategies that misbehave in place().
    {"place_loop", burns_tick, ""},
    {"place_crash", "crash: signal 11", ""},
    {"place_nonsense", "plays", ""},
    // Strategies that take memory.
    {"mem_bomb", burns_tick + "|plays", ""},
    {"mem_leak", "plays", ""},
    {"mem_shared", "illegal_call: memfd_create", ""},
    {"mem_new", "crash: bad_alloc", ""},
    {"mem_locked", "plays", ""},
    {"mem_code", "plays", ""},
    // Strategies that attack the mailbox.
    {"shm_mprotect", "plays", ""},
    {"shm_write", "crash: signal 11", ""},
    {"shm_scribble", "crash", ""},
    {"shm_flip", "plays", ""},
    {"shm_unmap", "crash: signal 11", ""},
    {"shm_truncate", "illegal_call: ftruncate", ""},
    {"shm_truncate_others", "illegal_call: fcntl", ""},
    // Descriptors, files, libraries.
    {"fd_close_all", "plays", ""},
    {"fd_dup_flood", "plays", ""},
    {"fd_inherited", "plays", ""},
    {"fd_unblock", "illegal_call: fcntl", ""},
    {"file_read", "plays", ""},
    {"file_write", "illegal_call: truncate", ""},
    {"file_rename", "illegal_call: rename", ""},
    {"file_stat", "plays", ""},
    {"lib_late", "plays", ""},
    {"env_peek", "plays", ""},
    {"ld_runpath", "no_load: libevil.so", ""},
    {"ld_exec_stack", "plays", ""},
    // Strategies that misbehave while they are loaded.
    {"ctor_attack", "plays", "illegal_call: kill"},
    {"ctor_read", "plays", ""},
    {"ctor_write", "plays", ""},
    {"ctor_exit", "crash: while its library was loaded", ""},
    {"ctor_loop", burns_start, ""},
    {"ctor_prctl", "plays", ""},
    {"ctor_listener", "illegal_call: seccomp", ""},
    {"ctor_filter", "crash: changed the sandbox", ""},
    {"ctor_close_all", "plays", ""},
    {"ctor_limits", "plays", ""},
    {"ctor_ready", "plays", ""},
    {"ctor_almost_ready", "plays", ""},
    {"ctor_open_forever", burns_start, ""},
    {"dtor_loop", "plays", ""},
    {"ifunc_resolver", "plays", ""},
    {"tls_ctor", "illegal_call: kill", ""},
    {"entry_null", "bad_abi: null", ""},
    {"entry_garbage", "crash: signal 11", ""},
    {"entry_no_functions", "bad_abi: incomplete", ""},
    {"init_fail", "crash: while its library was loaded", ""},
    {"init_refuses", "no_load: null", ""},
    {"no_entry", "bad_abi: mirocup_entry", ""},
    {"other_version", "bad_abi: version", ""},
    // Processes and the kernel.
    {"proc_exec", "illegal_call: execve", ""},
    {"proc_kill_parent", "plays", "illegal_call: kill"},
    {"proc_kill_all", "illegal_call: kill", ""},
    {"proc_namespaces", "illegal_call: unshare", ""},
    {"proc_priority", "plays", ""},
    {"proc_ptrace", "plays", "illegal_call: process_vm_readv"},
    {"spy_clock", "illegal_call: clock_gettime", ""},
    {"spy_affinity", "illegal_call: sched_getaffinity", ""},
    {"spy_limits", "illegal_call: prlimit64", ""},
    {"proc_ptrace_self", "illegal_call: ptrace", ""},
    {"fork_bomb", "plays", ""},
    {"thread_bomb", "plays", ""},
    {"timer_think", "illegal_call: setitimer", ""},
    {"call_io_uring", "illegal_call: io_uring_setup", ""},
    {"call_bpf", "illegal_call: bpf", ""},
    {"call_mbind", "plays", ""},
    {"call_unknown", "illegal_call: 9999", ""},
    {"call_32_bit", "illegal_call|crash: signal 11", ""},  // kernels without 32-bit calls
    {"call_x32", "illegal_call", ""},
    {"net_loopback", "plays", ""},
    // Strategies that abuse their answer or their log.
    {"log_flood", "plays", ""},
    {"log_escape", "plays", ""},
    {"forge_fault", "crash: exit code 1", ""},
    {"forge_text",
     "crash: says \"decide() threw: '. The other team made an illegal call\\n{'accepted'", ""},
    {"out_nan", "plays", ""},
    {"out_too_much", "crash: signal 11", ""},
    {"fp_env", "plays|crash: signal 8", ""},
};

}  // namespace mirocup
