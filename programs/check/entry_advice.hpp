// SPDX-License-Identifier: MIT
//
// Advice to the author of an entry: a remedy for a fault of the team, in one sentence.
#pragma once

#include "core/match/controller.hpp"
#include "plugins/host/process_controller.hpp"

#include <optional>
#include <string>

namespace mirocup::app {

// The evidence about the end of a team's process.
struct FaultEvidence {
  match::Fault fault;
  std::optional<plugins::LastWords> words;  // nothing if the server ended the process
  std::string requests = {};                // lines of ProcessController::requests()
  bool is_python = false;                   // the team is in Python
};

std::string advice_on(const FaultEvidence& evidence);

// Advice for a team that takes too much time.
inline constexpr const char* advice_on_time =
    "a tick has 1 ms of processor time in the mean of a leg; compute less, and do not wait";

inline constexpr const char* advice_on_time_in_python =
    "a tick has 1 ms of processor time in the mean of a leg; compute less, use numpy for long "
    "computations, or write the team in C++";

}  // namespace mirocup::app
