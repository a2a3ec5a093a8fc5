/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* In a namespace the kernel would drop a signal without a handler: one tier would play on. */
  if (signal(SIGTERM, SIG_DFL) != SIG_ERR || signal(SIGXFSZ, SIG_IGN) != SIG_ERR)
    got_through("a signal that ends the process");
  raise(SIGTERM);
}
