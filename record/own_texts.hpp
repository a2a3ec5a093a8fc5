// SPDX-License-Identifier: MIT
//
// What only a team and its host may see of a leg, as it lies beside the record.
#pragma once

#include "core/match/snapshot.hpp"
#include "system/files.hpp"

#include <string>

namespace mirocup::record {

// An empty text shows nothing.
struct OwnTexts {
  match::ByTeam<std::string> thoughts;  // JSON lines of mirocup/thoughts/1
  match::ByTeam<std::string> logs;      // what the teams printed
};

// The teams whose thoughts and logs somebody may see.
using Whose = match::ByTeam<bool>;
inline constexpr Whose of_nobody{false, false};
inline constexpr Whose of_both{true, true};

// Returns true if thoughts of one of these teams were kept with the record.
bool has_thoughts(system::Files& files, const std::string& record_path, const Whose& whose);

// Reads what these teams drew and printed in the leg. What is missing is empty. Errors: those of
// Files::read(), and of unpacked_thoughts().
Result<OwnTexts> read_own_texts(system::Files& files, const std::string& record_path,
                                const Whose& whose, system::Links links = system::Links::refused);

}  // namespace mirocup::record
