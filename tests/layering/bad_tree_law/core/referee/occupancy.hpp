// SPDX-License-Identifier: MIT
//
// A tool of the referee that includes the interface of a law in its header.
#include "core/referee/laws/law.hpp"
