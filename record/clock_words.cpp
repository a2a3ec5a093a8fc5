// SPDX-License-Identifier: MIT
#include "record/clock_words.hpp"

#include "system/number_of.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace mirocup::record {

namespace {

// By the number of the phase.
constexpr std::array<std::string_view, 4> names{"first half", "second half", "extra time",
                                                "shoot-out"};
constexpr int longest = 100'000;  // min

}  // namespace

std::string in_words(const ClockTime& time) {
  const int s = static_cast<int>(time.clock + 1e-6);  // a whole second stays one
  return std::string(names[static_cast<std::size_t>(time.phase)]) +
         system::formatted(" %d:%02d", s / 60, s % 60);
}

std::optional<ClockTime> clock_time_of(std::string_view words) {
  const std::string whole = system::lower_case(std::string(words));
  const std::string_view text = whole;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!text.starts_with(names[i]) || text.substr(names[i].size()).find(' ') != 0) continue;
    const std::string_view time = text.substr(names[i].size() + 1);
    const std::size_t colon = std::min(time.find(':'), time.size());
    const auto minutes = system::number_of<int>(std::string(time.substr(0, colon)));
    const auto seconds = colon < time.size()
                             ? system::number_of<double>(std::string(time.substr(colon + 1)))
                             : std::nullopt;
    if (!minutes || !seconds || *minutes < 0 || *minutes > longest || *seconds < 0.0 ||
        *seconds >= 60.0)
      return std::nullopt;
    return ClockTime{static_cast<referee::Phase>(i), 60.0 * *minutes + *seconds};
  }
  return std::nullopt;
}

}  // namespace mirocup::record
