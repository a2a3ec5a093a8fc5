/* SPDX-License-Identifier: MIT */
#include "tests/hostile/hostile.h"

/* Linked so that the loader makes the stack executable (CMakeLists.txt). */
BEHAVES_LATER
