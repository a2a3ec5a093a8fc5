// SPDX-License-Identifier: MIT
//
// The page that shows a leg in a browser: one HTML text that needs nothing else. A replay page holds
// the whole leg; a live page asks the server that it came from.
#pragma once

#include "core/replay/playback.hpp"
#include "server/record/match_record.hpp"

#include <string>

namespace mirocup::web {

// What a clock measured differs whenever the leg is played; a page without it is the same for all who
// played it.
enum class Times { shown, left_out };

// Plays the record again for the positions. The error is where it does not tell what happened.
tl::expected<std::string, replay::Divergence> replay_page(const record::MatchRecord& record,
                                                          Times times = Times::shown);

// What a live page is told about a match that is being played.
struct LiveMatch {
  match::ByTeam<std::string> names;
  std::string about;   // a line for the foot of the page
  std::string events;  // where the events come from, as the browser sees it
};

std::string live_page(const match::Leg& match, const LiveMatch& live);

}  // namespace mirocup::web
