/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

static void misbehave(mirocup_command* command) {
  (void)command;
  /* Signals of the processor, sent without a cause and without a handler. */
  signal(SIGSEGV, SIG_DFL);
  signal(SIGTRAP, SIG_DFL);
  if (raise(SIGSEGV) == 0 || raise(SIGTRAP) == 0) got_through("a signal of the processor");
}
