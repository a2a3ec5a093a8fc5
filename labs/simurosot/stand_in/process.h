/* SPDX-License-Identifier: MIT */
/* A requested thread is never started. */
#ifndef MIROCUP_SIMUROSOT_PROCESS_H
#define MIROCUP_SIMUROSOT_PROCESS_H
static inline unsigned long _beginthread(void (*)(void*), unsigned, void*) {
  return 0;
}
static inline unsigned long _beginthreadex(void*, unsigned, unsigned (*)(void*), void*, unsigned,
                                           void*) {
  return 0;
}
static inline void _endthread(void) {}
static inline void _endthreadex(unsigned) {}
static inline int _getpid(void) {
  return 1;
}
#endif
