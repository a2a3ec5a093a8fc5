// SPDX-License-Identifier: MIT
//
// Checks whether a library would be accepted as an entry: inspects the file, then plays trial legs
// in the sandbox.
#pragma once

#include "core/base/error.hpp"
#include "core/field/league.hpp"
#include "core/match/team_parameters.hpp"
#include "plugins/host/sandbox/isolation.hpp"

#include <cstddef>
#include <functional>
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
  double bank_share = 0.0;       // mean_tick_ms, of the time that a tick adds to the bank
  double leg_seconds = 0.0;      // processor time that a leg of full length would take
  double leg_share = 0.0;        // leg_seconds, of the time that such a leg gives
  std::size_t peak_memory = 0;   // bytes
  match::TeamParameters unknown_parameters;  // given, but the team never asked for them
  std::string log;

  // The first check that failed; null if none did.
  const Check* failure() const;
};

// `half` is the length, s, of the halves that the entry is for; nothing: that of the rules. The
// trial legs are shorter. The team plays them with the parameters. Takes at most 20 s. An error
// means that there is no answer: the file cannot be read, or the host failed.
// `tell` is told about each check before it runs: its number from 1, the number of checks, its
// name.
using StepListener = std::function<void(int number, int of, const char* name)>;
Result<EntryReport> check_entry(const std::string& path, League league, std::optional<double> half,
                                const match::TeamParameters& parameters, const StepListener& tell);

}  // namespace mirocup::app
