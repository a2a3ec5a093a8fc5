// SPDX-License-Identifier: MIT
//
// Advice to the author of an entry: what to do about a fault of the team, in one sentence.
#pragma once

#include "core/match/controller.hpp"
#include "plugins/host/process_controller.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace mirocup::app {

// What is known about the end of a team's process.
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
    "a tick has 1 ms of processor time in the mean of a leg; compute less, use numpy for what is "
    "long, or write it in C++";

// Returns advice about a file that is no shared library but something else that is known, such as
// an archive or a source; "" if it is not known.
std::string advice_on_file(std::string_view bytes);

// Returns advice about a library that exports no mirocup_entry(); it may be there under a C++ name.
std::string advice_on_missing_entry(std::string_view bytes);

}  // namespace mirocup::app
