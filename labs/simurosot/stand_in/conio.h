/* SPDX-License-Identifier: MIT */
/* A console without a keyboard. */
#ifndef MIROCUP_SIMUROSOT_CONIO_H
#define MIROCUP_SIMUROSOT_CONIO_H
static inline int _kbhit(void) {
  return 0;
}
static inline int _getch(void) {
  return 0;
}
static inline int _putch(int c) {
  return c;
}
static inline void clrscr(void) {}
static inline void gotoxy(int, int) {}
#define kbhit _kbhit
#define getch _getch
#define getche _getch
#define _getche _getch
#define putch _putch
#define cprintf printf
#define _cprintf printf
#endif
