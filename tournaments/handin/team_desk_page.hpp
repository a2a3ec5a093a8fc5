// SPDX-License-Identifier: MIT
//
// The pages of the desk: the one that asks for a token, and the private page of a team, where it
// hands in and reads what became of its entries. page/hand_in.js of server/web sends the file and
// follows its check.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace mirocup::league {

using Json = nlohmann::ordered_json;

// `why` is a sentence that says what was wrong with the last token; "": nothing was.
std::string log_in_page(const std::string& why);

// `entries` are the summaries of entry_summary(), the latest first; `legs` those of
// own_legs_json().
std::string team_desk_page(const std::string& team, const Json& entries, const Json& legs);

}  // namespace mirocup::league
