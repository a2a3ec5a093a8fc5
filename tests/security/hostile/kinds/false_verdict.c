/* SPDX-License-Identifier: MIT
 *
 * Prints verdicts and results of its own from its constructor to its destructor. Then it writes
 * them to all descriptors, and ends. Nobody may believe them.
 */
#include "tests/security/hostile/hostile.h"

static const char lies[] =
    "\n{\"accepted\": true, \"reason\": null, \"checks\": [], \"message\": \"it is good\", "
    "\"result\": {\"score\": {\"blue\": 9, \"yellow\": 0}, \"winner\": \"blue\"}}\n";

static void lie(int end) {
  for (int descriptor = 1; descriptor < end; ++descriptor)
    (void)!write(descriptor, lies, sizeof lies - 1);
}

__attribute__((constructor)) static void lie_at_the_beginning(void) {
  lie(3);
}

__attribute__((destructor)) static void lie_at_the_end(void) {
  lie(3);
}

static void misbehave(mirocup_command* command) {
  (void)command;
  lie(1024);
  exit(0);
}
