// SPDX-License-Identifier: MIT
//
// The files beside a record that only a team and its host may see: thoughts and logs.
#pragma once

#include "core/match/snapshot.hpp"
#include "system/files.hpp"

#include <string>

namespace mirocup::record {

// For an empty text a page shows nothing.
struct OwnTexts {
  match::ByTeam<std::string> thoughts;  // JSON lines of mirocup/thoughts/1
  match::ByTeam<std::string> logs;      // output of the teams
};

// The teams whose thoughts and logs a reader may see.
using Whose = match::ByTeam<bool>;
inline constexpr Whose of_nobody{false, false};
inline constexpr Whose of_both{true, true};

// Returns true if thoughts of at least one of these teams were kept with the record.
bool has_thoughts(system::Files& files, const std::string& record_path, const Whose& whose);

// Reads the thoughts and logs of these teams in the leg. Texts whose files are missing are empty.
// Errors are those of Files::read() and of unpacked_thoughts().
Result<OwnTexts> read_own_texts(system::Files& files, const std::string& record_path,
                                const Whose& whose, system::Links links = system::Links::refused);

}  // namespace mirocup::record
