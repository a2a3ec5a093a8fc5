// SPDX-License-Identifier: MIT
//
// A team chooses which of its accepted versions plays.
#pragma once

#include "tournaments/handin/desk_state.hpp"
#include "web/http/request.hpp"

namespace mirocup::league {

// `asked` is the number of an entry, or "latest". A team may choose while it may hand in, ten times
// an hour. Any thread may call this.
web::Reply pin_version(DeskState& state, const std::string& team, const std::string& asked);

}  // namespace mirocup::league
