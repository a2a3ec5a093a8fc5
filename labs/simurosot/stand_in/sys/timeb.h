/* SPDX-License-Identifier: MIT */
#ifndef MIROCUP_SIMUROSOT_TIMEB_H
#define MIROCUP_SIMUROSOT_TIMEB_H
#include "windows.h"
/* The time of a match, in whole milliseconds. */
struct timeb {
  time_t time;
  unsigned short millitm;
  short timezone, dstflag;
};
static inline int ftime(struct timeb* now) {
  now->time = time(0);
  now->millitm = (unsigned short)(mirocup_simurosot_ms() % 1000);
  now->timezone = now->dstflag = 0;
  return 0;
}
#define _timeb timeb
#define _ftime ftime
#define _ftime_s ftime
#define __timeb64 timeb
#define _ftime64 ftime
#endif
