// SPDX-License-Identifier: MIT
#include "tournaments/handin/doorkeeper.hpp"

#include "system/digest.hpp"
#include "system/text.hpp"
#include "tournaments/league/acts.hpp"

#include <filesystem>

namespace mirocup::league {

namespace {

constexpr std::string_view bearer = "Bearer ";

// Makes browsers take the cookie over TLS only, and from this host only.
constexpr const char* secure_prefix = "__Host-";

// Returns whom a proxy names: "alpha", "staff:A. Host"; nothing if that is no team and no role.
std::optional<Visitor> visitor_of_proxy(const std::string& named) {
  if (is_good_name(named)) return Visitor{.team = named};
  const std::size_t colon = std::min(named.find(':'), named.size());
  const auto role = from_string<Role>(named.substr(0, colon));
  const std::string person = colon < named.size() ? named.substr(colon + 1) : "";
  if (!role || *role == Role::team || !objection_to_person(person).empty()) return std::nullopt;
  return Visitor{.role = *role, .person = person};
}

}  // namespace

Doorkeeper::Doorkeeper(system::Files& files, Folder folder, std::string team_header)
    : files_(files),
      folder_(std::move(folder)),
      cookie_(cookie_name(folder_)),
      team_header_(system::lower_case(std::move(team_header))) {
  // Browsers stay logged in when the server starts again.
  if (const auto text = files_.read(sessions_path(), {.max_size = system::size_limit::note}))
    sessions_ = Sessions::parse(*text);
}

tl::expected<void, Refusal> Doorkeeper::read_tokens_again() {
  const std::string path = tokens_path(folder_);
  MIROCUP_TRY(auto text, files_.read_if_there(path, {.max_size = system::size_limit::note})
                             .map_error(refusal_of_host));
  if (text == tokens_text_) return {};
  MIROCUP_TRY(auto tokens,
              (text ? parse_tokens(*text, path) : TokenList{}).map_error(refusal_of_host));
  tokens_text_ = std::move(text);
  tokens_ = std::move(tokens);
  return {};
}

std::string cookie_name(const Folder& folder) {
  std::error_code none;
  const auto path = std::filesystem::weakly_canonical(folder.path, none);
  return "mirocup_" + system::sha256(path.string()).substr(0, 8);
}

std::string Doorkeeper::cookie_of(const web::Request& request) const {
  return cookie_in(request.header("cookie"), (request.is_encrypted ? secure_prefix : "") + cookie_);
}

std::string Doorkeeper::cookie_header(const web::Request& request, const std::string& value,
                                      std::int64_t seconds) const {
  const bool is_secure = request.is_encrypted;
  return (is_secure ? secure_prefix : "") + cookie_ + "=" + value +
         "; Path=/; HttpOnly; SameSite=Strict; Max-Age=" + std::to_string(seconds) +
         (is_secure ? "; Secure" : "");
}

tl::expected<void, Refusal> Doorkeeper::expect_own_page(const web::Request& request,
                                                        bool must_have_origin) const {
  if (!request.headers.contains("origin") && !must_have_origin) return {};
  const std::string origin = system::lower_case(request.header("origin"));
  const std::string host = system::lower_case(request.header("host"));
  const bool is_own = !host.empty() && (origin == "https://" + host ||
                                        (!request.is_encrypted && origin == "http://" + host));
  if (is_own) return {};
  return refused(403, "the request comes from a page of another site");
}

Refusal Doorkeeper::wrong_token(const web::Request& request, std::string_view token,
                                std::int64_t now) {
  const std::int64_t wait = wrong_.note(request.viewer, now);
  if (wait > 0) {
    return {429,
            "too many wrong tokens came from this address: wait " + std::to_string(wait) +
                " s before the next",
            wait};
  }
  // One who has the token may know what became of it.
  const std::string utc = utc_text(now);
  const Token* known = tokens_.find_ended(token, utc);
  if (known == nullptr) return {401, "no team has this token"};
  return {401, known->revoked.empty() ? "this token expired at " + known->expires
                                      : "this token was revoked at " + known->revoked};
}

bool Doorkeeper::has_credentials(const web::Request& request) const {
  return request.headers.contains("authorization") || !cookie_of(request).empty() ||
         (request.is_from_proxy && !team_header_.empty() && request.headers.contains(team_header_));
}

tl::expected<Visitor, Refusal> Doorkeeper::admit(const web::Request& request, Purpose purpose,
                                                 std::int64_t now) {
  MIROCUP_TRY_VOID(read_tokens_again());
  if (!has_credentials(request)) return refused(401, "a token is needed");
  const bool by_token = request.headers.contains("authorization");
  if (purpose == Purpose::changing) MIROCUP_TRY_VOID(expect_own_page(request, !by_token));
  const auto visitor_of = [](const Token& token) {
    return Visitor{token.team, token.role, token.person, token.sha256};
  };
  const std::string utc = utc_text(now);
  if (by_token) {
    const std::string header = request.header("authorization");
    if (header.size() <= bearer.size() || system::lower_case(header.substr(0, bearer.size())) !=
                                              system::lower_case(std::string(bearer)))
      return refused(401, "a token is expected: Authorization: Bearer TOKEN");
    const std::string_view text = std::string_view(header).substr(bearer.size());
    if (const Token* token = tokens_.find(text, utc)) return visitor_of(*token);
    return tl::unexpected(wrong_token(request, text, now));
  }
  if (const std::string cookie = cookie_of(request); !cookie.empty()) {
    const std::string sha256 = sessions_.token_of(cookie, now);
    const Token* token = sha256.empty() ? nullptr : tokens_.find_sha256(sha256, utc);
    if (token != nullptr) return visitor_of(*token);
    return refused(401, "the session has ended: type the token again");
  }
  if (request.is_from_proxy && !team_header_.empty()) {
    if (const auto named = visitor_of_proxy(request.header(team_header_))) return *named;
  }
  return refused(401, "a token is needed");
}

tl::expected<void, Refusal> Doorkeeper::keep_sessions() {
  return files_.write(sessions_path(), sessions_.text(), system::Readers::owner)
      .map_error(refusal_of_host);
}

tl::expected<std::string, Refusal> Doorkeeper::log_in(const web::Request& request,
                                                      std::string_view token, std::int64_t now) {
  MIROCUP_TRY_VOID(expect_own_page(request, true));
  MIROCUP_TRY_VOID(read_tokens_again());
  const Token* known = tokens_.find(token, utc_text(now));
  if (known == nullptr) return tl::unexpected(wrong_token(request, token, now));
  const std::string cookie = sessions_.begin(known->sha256, now);
  MIROCUP_TRY_VOID(keep_sessions());
  return cookie_header(request, cookie, Sessions::duration);
}

tl::expected<std::string, Refusal> Doorkeeper::log_out(const web::Request& request) {
  MIROCUP_TRY_VOID(expect_own_page(request, true));
  if (const std::string cookie = cookie_of(request); !cookie.empty()) {
    sessions_.end(cookie);
    MIROCUP_TRY_VOID(keep_sessions());
  }
  return cookie_header(request, "", 0);
}

}  // namespace mirocup::league
