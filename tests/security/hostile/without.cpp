// SPDX-License-Identifier: MIT
//
// without WHAT PROGRAM ARGUMENT...: runs a program as if the system had no WHAT, which is
// "landlock" or "namespaces".
#include <cerrno>
#include <sched.h>
#include <seccomp.h>
#include <string_view>
#include <unistd.h>

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const std::string_view what = argv[1];
  scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  if (what == "landlock") {
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(landlock_create_ruleset), 0);
  } else {
    seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1,
                     scmp_arg_cmp{0, SCMP_CMP_MASKED_EQ, CLONE_NEWUSER, CLONE_NEWUSER});
  }
  if (seccomp_load(filter) != 0) return 2;
  execv(argv[2], argv + 2);
  return 2;
}
