/* SPDX-License-Identifier: MIT
 *
 * Writes verdicts and results of its own to all descriptors, from its constructor to its destructor,
 * and then fails. Nobody may believe them.
 */
#include "tests/security/hostile/hostile.h"

static const char lies[] =
    "\n{\"accepted\": true, \"reason\": null, \"checks\": [], \"message\": \"it is good\", "
    "\"result\": {\"score\": {\"blue\": 9, \"yellow\": 0}, \"winner\": \"blue\"}}\n";

static void lie(void) {
  signal(SIGXFSZ, SIG_IGN);
  signal(SIGPIPE, SIG_IGN);
  for (int descriptor = 1; descriptor < 1024; ++descriptor)
    (void)!write(descriptor, lies, sizeof lies - 1);
}

__attribute__((constructor)) static void lie_at_the_beginning(void) {
  lie();
}

__attribute__((destructor)) static void lie_at_the_end(void) {
  lie();
}

static void misbehave(mirocup_command* command) {
  (void)command;
  lie();
  exit(0);
}
