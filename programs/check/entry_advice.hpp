// SPDX-License-Identifier: MIT
//
// The sentences of a check: remedies for the faults of a team, and warnings. advice.txt has them.
#pragma once

#include "core/match/controller.hpp"
#include "plugins/host/process_controller.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace mirocup::app {

// The evidence about the end of a team's process.
struct FaultEvidence {
  match::Fault fault;
  std::optional<plugins::LastWords> words;  // nothing if the server ended the process
  std::string requests = {};                // lines of ProcessController::requests()
  bool is_python = false;                   // the team is in Python
};

// Returns a remedy for the fault, in one sentence.
std::string advice_on(const FaultEvidence& evidence);

// Returns the sentence of that key with its values; "" if there is none.
std::string sentence(const std::string& key, const std::string& first = "",
                     const std::string& second = "");

// Returns the text of the file advice.txt of this folder, which is part of the program.
std::string_view advice_file(std::string_view name);

}  // namespace mirocup::app
