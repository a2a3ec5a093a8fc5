// SPDX-License-Identifier: MIT
//
// The clock of a leg as people say it: "second half 0:10". Pages, digests and commands have the
// same words for a moment. The clock of a half stands still while play is stopped.
#pragma once

#include "core/referee/decision.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace mirocup::record {

struct ClockTime {
  referee::Phase phase = referee::Phase::FIRST_HALF;
  double clock = 0.0;  // s, of the phase

  auto operator<=>(const ClockTime&) const = default;
};

// Returns "second half 0:10"; parts of a second are left out.
std::string in_words(const ClockTime& time);

// Reads these words, also with capitals, as pages begin them; nothing if a text has another form.
std::optional<ClockTime> clock_time_of(std::string_view words);

}  // namespace mirocup::record
