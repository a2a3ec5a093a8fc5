/* SPDX-License-Identifier: MIT
 *
 * The frame of a hostile strategy: it behaves until hostile_tick, in which it does what the name of
 * its file says.
 */
#ifndef MIROCUP_TESTS_HOSTILE_H
#define MIROCUP_TESTS_HOSTILE_H

#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include "mirocup/strategy.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

enum { hostile_tick = 25 };

/* MIROCUP_TARGET is a folder outside the sandbox with a file that must not be read and one that
 * must not change. */
#define SECRET MIROCUP_TARGET "/secret"
#define RECORD MIROCUP_TARGET "/record"

/* The test looks for these words in the log. */
static inline void got_through(const char* what) {
  fprintf(stderr, "GOT THROUGH: %s\n", what);
}
static inline void expect_failure(long result, const char* what) {
  if (result >= 0) got_through(what);
}

/* Values that the compiler cannot know. */
static volatile uintptr_t hostile_nowhere = 16;
static volatile int hostile_for_ever = 1;

/* Uses that much processor time, s. */
static inline void burn(double seconds) {
  struct timespec begin, now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &begin);
  do {
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  } while ((double)(now.tv_sec - begin.tv_sec) + 1e-9 * (double)(now.tv_nsec - begin.tv_nsec) <
           seconds);
}

/* Gives wheels one of seven speeds each that follow from the number. Two draws of a number give the
 * same speeds once in 117 649 times: a test that expects others in this tick fails as rarely. */
static inline void answer_by(unsigned number, mirocup_command* command) {
  for (int i = 0; i < 3; ++i) {
    command->wheels[i].left = number % 7;
    command->wheels[i].right = number / 7 % 7;
    number /= 49;
  }
}

#ifndef HOSTILE_CUSTOM_ENTRY
/* Called in every tick from hostile_tick on. */
static void misbehave(mirocup_command* command);
static const mirocup_observation* hostile_now;

/* For strategies that misbehave in create(): HOSTILE_CREATE is the name of their function. */
#ifdef HOSTILE_CREATE
static void* HOSTILE_CREATE(const mirocup_setup* setup);
#else
#define HOSTILE_CREATE hostile_create
static void* hostile_create(const mirocup_setup* setup) {
  static int something;
  (void)setup;
  (void)hostile_nowhere;
  (void)hostile_for_ever;
  return &something;
}
#endif

static void hostile_decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  (void)team;
  hostile_now = now;
  if (now->tick >= hostile_tick) misbehave(command);
}

/* For strategies that misbehave in place(): HOSTILE_PLACE is the name of their function. */
#ifdef HOSTILE_PLACE
static void HOSTILE_PLACE(void* team, const mirocup_observation* now, mirocup_placement* placement);
#else
#define HOSTILE_PLACE 0
#endif

const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {MIROCUP_ABI_VERSION, sizeof(mirocup_strategy), "hostile",
                                         HOSTILE_CREATE,      hostile_decide,           0,
                                         HOSTILE_PLACE};
  return &entry;
}

/* For strategies that misbehave while they are loaded. */
#define BEHAVES_LATER                               \
  static void misbehave(mirocup_command* command) { \
    (void)command;                                  \
  }
#endif

#endif
