// SPDX-License-Identifier: MIT
//
// Looks up the routes of the portal, and says who may use them. Portal::routes() is the table.
#pragma once

#include "tournaments/handin/doorkeeper.hpp"
#include "web/http/request.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

// Who may use a route.
enum class Who {
  everybody,  // also without a token
  known,      // a team, a tutor or the staff
  team,
  reader,  // a tutor or the staff
  staff,
};

// The subject of a route, and its answer to an unknown visitor.
enum class About {
  api,              // refusals are JSON
  team_of_token,    // as api; a team may name itself by ?team=
  entries_of_team,  // as api; the staff has to name a team
  page,             // asks for the token in HTML
};

// A request and what the table has found out about it.
struct Call {
  const web::Request& request;
  const web::Body& body;
  Visitor visitor = {};                      // empty if the route is for everybody
  std::string team = {};                     // About::entries_of_team: whose entries
  std::vector<std::string_view> parts = {};  // of the path, for each star of the route
};

// If a path matches a pattern, returns the parts of the path in the places of its stars. "*" is one
// part that is not empty; "**", at the end, is the rest of the path.
std::optional<std::vector<std::string_view>> match_path(std::string_view pattern,
                                                        std::string_view path);

// Returns the reply to a visitor who may not use a route; nothing if it may.
std::optional<web::Reply> refused_role(Who who, const Visitor& visitor);

// Returns a 405 that names the methods of this path: "use PUT". If the request would change
// something, the reply names the methods that do.
web::Reply use_reply(const web::Request& request, const std::vector<std::string_view>& methods);

}  // namespace mirocup::league
