// SPDX-License-Identifier: MIT
//
// A team whose process is stopped at tick 30, until it gets SIGCONT.
#define ENDING SIGSTOP
#include "tests/programs/dds/teams/ending.hpp"
