// SPDX-License-Identifier: MIT
//
// A team's choice of the accepted entry that plays.
#pragma once

#include "tournaments/handin/desk_state.hpp"
#include "web/http/request.hpp"

namespace mirocup::league {

// `asked` is the number of an entry, or "latest". A team may choose as long as it may hand in, at
// most ten times an hour. Threads: any.
web::Reply pin_version(DeskState& state, const std::string& team, const std::string& asked);

}  // namespace mirocup::league
