/* SPDX-License-Identifier: MIT
 *
 * Simulates a clock that is OLD_CLOCK seconds behind, for processes that load this library with
 * LD_PRELOAD. Only the time of day is behind; clocks that measure intervals are as ever. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <stdlib.h>
#include <sys/time.h>
#include <time.h>

static long behind(void) {
  const char* text = getenv("OLD_CLOCK");
  return text == NULL ? 0 : atol(text);
}

int clock_gettime(clockid_t clock, struct timespec* now) {
  int (*real)(clockid_t, struct timespec*) = NULL;
  int result;
  *(void**)&real = dlsym(RTLD_NEXT, "clock_gettime");
  result = real(clock, now);
  if (result == 0 && clock == CLOCK_REALTIME) now->tv_sec -= behind();
  return result;
}

time_t time(time_t* into) {
  struct timespec now = {0, 0};
  clock_gettime(CLOCK_REALTIME, &now);
  if (into != NULL) *into = now.tv_sec;
  return now.tv_sec;
}

int gettimeofday(struct timeval* now, void* zone) {
  struct timespec precise = {0, 0};
  const int result = clock_gettime(CLOCK_REALTIME, &precise);
  (void)zone;
  now->tv_sec = precise.tv_sec;
  now->tv_usec = (suseconds_t)(precise.tv_nsec / 1000);
  return result;
}

/* A caller that waits until a time of day means a time of the old clock: adjusts the deadline. */
int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                           const struct timespec* until) {
  int (*real)(pthread_cond_t*, pthread_mutex_t*, const struct timespec*) = NULL;
  struct timespec later = *until;
  *(void**)&real = dlsym(RTLD_NEXT, "pthread_cond_timedwait");
  later.tv_sec += behind();
  return real(condition, mutex, &later);
}
