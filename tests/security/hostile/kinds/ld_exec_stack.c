/* SPDX-License-Identifier: MIT */
#include "tests/security/hostile/hostile.h"

/* Linked so that the loader makes the stack executable (CMakeLists.txt). */
BEHAVES_LATER
