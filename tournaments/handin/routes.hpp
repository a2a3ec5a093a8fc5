// SPDX-License-Identifier: MIT
//
// Finds the route of a request to the portal, and says who may use it. Portal::routes() is the
// table.
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
  grader,  // who sees the grades: the staff or a tutor
  staff,   // who decides: the staff or an assistant
};

// The subject of a route, and its answer to an unknown visitor.
enum class About {
  api,              // refusals are JSON
  team_of_token,    // like `api`; a team may name itself by ?team=
  entries_of_team,  // like `api`; the staff has to name a team
  page,             // asks for the token in HTML
};

// A request, with its sender and the parts of its path.
struct Call {
  const web::Request& request;
  const web::Body& body;
  Visitor visitor = {};  // empty if the route is for everybody
  // The team whose entries are meant (About::entries_of_team).
  std::string team = {};
  std::vector<std::string_view> parts = {};  // the part of the path for each star of the route
};

// If a path matches a pattern, returns the parts of the path that stand for the pattern's stars.
// "*" is one part that is not empty; "**", at the end, is the rest of the path.
std::optional<std::vector<std::string_view>> match_path(std::string_view pattern,
                                                        std::string_view path);

// Returns the reply to a visitor who may not use a route; nothing if the visitor may.
std::optional<web::Reply> refused_role(Who who, const Visitor& visitor);

// Returns a 405 that names the methods of the path: "use PUT". If the request's method changes
// something, the reply names only methods that change something.
web::Reply use_reply(const web::Request& request, const std::vector<std::string_view>& methods);

}  // namespace mirocup::league
