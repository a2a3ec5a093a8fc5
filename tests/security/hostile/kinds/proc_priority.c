/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

#include <sched.h>
#include <sys/resource.h>

static void misbehave(mirocup_command* command) {
  (void)command;
  const struct sched_param parameters = {1};
  cpu_set_t all;
  memset(&all, 0xff, sizeof all);
  expect_failure(setpriority(PRIO_PROCESS, 0, -20), "priority");
  expect_failure(syscall(SYS_sched_setscheduler, 0, SCHED_FIFO, &parameters), "scheduler");
  expect_failure(sched_setaffinity(0, sizeof all, &all), "other processors");
}
