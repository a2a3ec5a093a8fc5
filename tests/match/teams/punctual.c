/* SPDX-License-Identifier: MIT
 *
 * A team that logs of every tick how late it was asked, in microseconds after the time that is due
 * since its first tick.
 */
#define _POSIX_C_SOURCE 199309L

#include "mirocup/strategy.h"

#include <stdio.h>
#include <time.h>

struct watch {
  void (*log)(const char* text);
  double begin; /* s */
  int has_begun;
};

static double seconds(void) {
  struct timespec time = {0, 0};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void* create(const mirocup_setup* setup) {
  static struct watch watch;
  watch.log = setup->log;
  return &watch;
}

static void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  struct watch* watch = team;
  char text[32];
  (void)command;
  if (!watch->has_begun) watch->begin = seconds() - now->time;
  watch->has_begun = 1;
  snprintf(text, sizeof text, "late %.0f us", 1e6 * (seconds() - watch->begin - now->time));
  watch->log(text);
}

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {
      MIROCUP_ABI_VERSION, sizeof(mirocup_strategy), "punctual", create, decide, 0, 0};
  return &entry;
}
