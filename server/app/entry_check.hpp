// SPDX-License-Identifier: MIT
//
// Would this library be accepted as an entry? Looks into the file, then plays it in the sandbox.
#pragma once

#include "core/base/error.hpp"
#include "core/field/league.hpp"
#include "plugins/host/sandbox/isolation.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mirocup::app {

// One question and its answer.
struct Check {
  std::string name;            // for scripts: "file", "complete", ...
  std::optional<bool> passed;  // nothing: not asked, because an earlier one failed
  std::string text;            // what was found; if it failed, a sentence that says what to do
};

struct EntryReport {
  std::string sha256;  // "" if the file can be no entry
  plugins::Isolation isolation = plugins::Isolation::T2;
  std::vector<Check> checks;
  double start_ms = 0.0;
  double mean_tick_ms = 0.0;  // of processor time
  double slowest_tick_ms = 0.0;
  double bank_share = 0.0;  // of the processor time that a leg has, how much it used
  std::size_t peak_memory = 0;
  std::string log;

  // The first check that failed, or null.
  const Check* failure() const;
};

// Takes at most 20 s. An error is no answer: the file cannot be read, or the host failed.
Result<EntryReport> check_entry(const std::string& path, League league);

}  // namespace mirocup::app
