// SPDX-License-Identifier: MIT
//
// A team whose process dies at tick 30 without a word, as by kill -9.
#define ENDING SIGKILL
#include "tests/programs/dds/teams/ending.hpp"
