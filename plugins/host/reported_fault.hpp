// SPDX-License-Identifier: MIT
//
// The fault of a team whose process has ended, as a sentence of the server.
//
// The text that the process wrote before its end is the team's own statement. The server prints
// this text as a quotation: on one line, in quotation marks, cut. The server uses the text only if
// it can be true: a team that has played cannot have failed to load.
#pragma once

#include "core/match/controller.hpp"
#include "plugins/host/child.hpp"
#include "plugins/host/mailbox.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace mirocup::plugins {

// The report that a process left on its command page, copied out of the memory that the process can
// write. The comments name the members of CommandPage (mailbox.hpp).
struct LastWords {
  LoadState load_state = LoadState::loading;
  int signal = 0;                              // fault_signal
  int call = no_call;                          // fault_call
  std::string cause = {};                      // raw, as the text
  int line = 0;                                // refusal_line
  std::string text = {};                       // raw: any bytes
  AddressKind address = AddressKind::unknown;  // fault_address
  TeamCall team_call = TeamCall::none;
};

// The observation that the team was answering.
struct AskedMoment {
  std::uint32_t tick = 0;
  match::State state = match::State::READY;
};

// Returns the moment in words: ", in decide() of tick 601 (PLAY)".
std::string text_of(TeamCall called, const AskedMoment& moment);

// Returns the fault of a team whose process ended with `status`. `has_played`: the server had seen
// the team ready; otherwise loading the library may have failed. If `moment` is given, the sentence
// names that moment.
match::Fault fault_of(const ExitStatus& status, const LastWords& words, bool has_played,
                      const std::optional<AskedMoment>& moment = std::nullopt);

}  // namespace mirocup::plugins
