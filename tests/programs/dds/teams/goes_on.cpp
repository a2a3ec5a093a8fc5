// SPDX-License-Identifier: MIT
//
// A team that plays to the end.
#define ENDING 0  // which raise() does not send
#include "tests/programs/dds/teams/ending.hpp"
