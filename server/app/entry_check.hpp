// SPDX-License-Identifier: MIT
//
// Checks whether a library would be accepted as an entry: inspects the file, then plays trial legs
// in the sandbox.
#pragma once

#include "core/base/error.hpp"
#include "core/field/league.hpp"
#include "plugins/host/sandbox/isolation.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::app {

// One check and its result.
struct Check {
  std::string name;            // for scripts: "file", "complete", ...
  std::optional<bool> passed;  // nothing: not run, because an earlier one failed
  std::string text;            // the finding; after a failure, a sentence that says what to do
};

struct EntryReport {
  std::string sha256;  // "" if the file can be no entry
  plugins::Isolation isolation = plugins::Isolation::T2;
  std::vector<Check> checks;
  double start_ms = 0.0;
  double mean_tick_ms = 0.0;     // processor time
  double slowest_tick_ms = 0.0;  // processor time
  double bank_share = 0.0;       // used share of the processor time that a leg has
  std::size_t peak_memory = 0;   // bytes
  std::string log;

  // The first check that failed; null if none did.
  const Check* failure() const;
};

// Takes at most 20 s. An error means that there is no answer: the file cannot be read, or the host
// failed.
Result<EntryReport> check_entry(const std::string& path, League league);

}  // namespace mirocup::app
