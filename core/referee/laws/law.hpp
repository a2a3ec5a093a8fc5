// SPDX-License-Identifier: MIT
//
// The common header of all laws; no file outside of laws/ includes it. core/referee/README.md says
// what the parts of such a file are and how to add a law.
//
// A law is a function of the pitch, the situation at the end of a tick and its own memory. It is
// called once a tick while play is on and returns a decision or nothing. It sees situations only,
// never a simulated world.
#pragma once

#include "core/referee/decide.hpp"
#include "core/referee/decision.hpp"
#include "core/referee/judged_field.hpp"
#include "core/referee/predicates.hpp"
#include "core/referee/tick_facts.hpp"

#include <optional>
