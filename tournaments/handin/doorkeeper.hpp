// SPDX-License-Identifier: MIT
//
// Finds out who sends a request: by a token ("Authorization: Bearer"), by the session of a browser
// in which a token was typed, or by the header of a trusted proxy in front of this server.
//
// A browser sends its cookie with every request, even if another site caused the request. So if a
// request that changes something comes with a cookie, or through a proxy that signs people on, it
// must name this server as its origin.
//
// Threads: one at a time.
#pragma once

#include "tournaments/handin/replies.hpp"
#include "tournaments/handin/sessions.hpp"
#include "tournaments/handin/tokens.hpp"
#include "tournaments/publish/snapshot.hpp"

namespace mirocup::league {

// The sender of a request.
struct Visitor {
  std::string team = {};  // "" for another role
  Role role = Role::team;
  std::string person = {};        // the name of a member of the staff; "": not known
  std::string token_sha256 = {};  // of the sender's token; "": a proxy named the sender

  bool sees_all() const { return role != Role::team; }
  Viewer viewer() const { return sees_all() ? Viewer::staff : Viewer::team; }
};

enum class Purpose { reading, changing };

// Returns the name of the cookie of a league's sessions. Each league of a host has its own, since
// browsers do not tell the ports or the paths of a host apart. Over TLS, "__Host-" precedes it.
std::string cookie_name(const Folder& folder);

class Doorkeeper {
 public:
  // `team_header` is the header in which a trusted proxy names the team of a signed-on person, or
  // "staff:NAME", "tutor:NAME" or "assistant:NAME"; "": the server trusts no proxy. The proxy must
  // remove this header from requests of viewers.
  Doorkeeper(system::Files& files, Folder folder, std::string team_header);

  // `now` is in s since 1970. If tokens.json cannot be read, everybody is refused with a 503.
  tl::expected<Visitor, Refusal> admit(const web::Request& request, Purpose purpose,
                                       std::int64_t now);

  // True if the request has a token, a session, or the header of a proxy. admit() checks whether
  // they are valid.
  bool has_credentials(const web::Request& request) const;

  // Begins a session with a typed token. Returns the header "Set-Cookie".
  tl::expected<std::string, Refusal> log_in(const web::Request& request, std::string_view token,
                                            std::int64_t now);

  // Ends the session of the request and returns a header that makes the browser forget its cookie.
  tl::expected<std::string, Refusal> log_out(const web::Request& request);

 private:
  tl::expected<void, Refusal> read_tokens_again();
  std::string cookie_of(const web::Request& request) const;
  std::string cookie_header(const web::Request& request, const std::string& value,
                            std::int64_t seconds) const;
  // Refuses a request for a change unless it comes from a page of this server.
  tl::expected<void, Refusal> expect_own_page(const web::Request& request,
                                              bool must_have_origin) const;
  Refusal wrong_token(const web::Request& request, std::string_view token, std::int64_t now);
  std::string sessions_path() const { return folder_.path + "/sessions.json"; }
  tl::expected<void, Refusal> keep_sessions();

  system::Files& files_;
  Folder folder_;
  std::string cookie_;
  std::string team_header_;                 // the HTTP header that names a team, in lower case
  std::optional<std::string> tokens_text_;  // of tokens.json; empty: no file
  TokenList tokens_;
  Sessions sessions_;
  WrongTokens wrong_;
};

}  // namespace mirocup::league
