// SPDX-License-Identifier: MIT
//
// The fault of a team whose process has ended, as a sentence of the server.
//
// What the process wrote before its end is the team's own word. It is printed as such: on one line,
// in quotation marks, cut. And it is believed only as far as it can be true: a team that has played
// cannot be one that never loaded.
#pragma once

#include "core/match/controller.hpp"
#include "plugins/host/child.hpp"
#include "plugins/host/mailbox.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace mirocup::plugins {

// What a process left on its command page, copied out of the memory that it can write.
struct LastWords {
  LoadState load_state = LoadState::loading;
  int signal = 0;                              // fault_signal
  int call = no_call;                          // fault_call
  std::string text = {};                       // raw: any bytes
  AddressKind address = AddressKind::unknown;  // fault_address
  TeamCall team_call = TeamCall::none;
};

// The observation that the team was answering.
struct AskedMoment {
  std::uint32_t tick = 0;
  match::State state = match::State::READY;
};

// Returns the fault of a team whose process ended so. `has_played` says whether the server had
// seen it ready; before that, the library can be at fault.
// The moment is told if the team was answering one.
match::Fault fault_of(const ExitStatus& status, const LastWords& words, bool has_played,
                      const std::optional<AskedMoment>& moment = std::nullopt);

}  // namespace mirocup::plugins
