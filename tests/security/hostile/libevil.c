/* SPDX-License-Identifier: MIT
 *
 * A library outside that a strategy asks for. Its constructor says that it was loaded.
 */
#include <stdio.h>

int evil(void);

__attribute__((constructor)) static void at_load(void) {
  fputs("GOT THROUGH: libevil.so\n", stderr);
}

int evil(void) {
  return 1;
}
