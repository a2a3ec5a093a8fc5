// SPDX-License-Identifier: MIT
//
// The tokens by which teams hand in: random words of 128 bits. tokens.json in the folder of the
// league keeps only the SHA-256 of each token, so a token is shown only once, when it is made. A
// token of 128 bits cannot be guessed, so a slow hash would not protect it better.
#pragma once

#include "core/base/names.hpp"
#include "tournaments/league/folder.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

// The owner of a token. The staff sees the private pages of all teams and decides; a tutor sees the
// same pages and changes nothing; an assistant decides and does not see the grades.
enum class Role { team, staff, tutor, assistant };

inline bool decides(Role role) {
  return role == Role::staff || role == Role::assistant;
}
inline bool sees_grades(Role role) {
  return role == Role::staff || role == Role::tutor;
}

struct Token {
  std::string team;  // "" if the owner is none
  Role role = Role::team;
  std::string person = {};  // the name of a member of the staff; "": not said
  std::string sha256;
  std::string made;     // when it was made, UTC, in the form of league.json
  std::string expires;  // when it expires, UTC; "": never
  std::string revoked;  // when it was revoked, UTC; "": never

  bool is_valid(const std::string& now) const {
    return revoked.empty() && (expires.empty() || now < expires);
  }
  bool operator==(const Token&) const = default;
};

// All tokens of a league, also revoked and expired tokens.
struct TokenList {
  std::vector<Token> tokens;

  // Makes a token and returns its text. Only the hash of the text is kept.
  std::string add(const std::string& team, const std::string& now, const std::string& expires);
  std::string add_for(Role role, const std::string& person, const std::string& now,
                      const std::string& expires);

  // Revokes all tokens of a team or, if `team` is "", of a role; if `person` is not "", only those
  // of that person. Returns how many tokens were valid until now.
  int revoke(Role role, const std::string& team, const std::string& person, const std::string& now);

  bool has_valid(const std::string& team, const std::string& now) const;

  // Returns the valid token with a text or a SHA-256; null if there is none. The text may have
  // small letters and blanks.
  const Token* find(std::string_view text, const std::string& now) const;
  const Token* find_sha256(const std::string& sha256, const std::string& now) const;

  // Returns the token with this text if it is revoked or has expired; otherwise null.
  const Token* find_ended(std::string_view text, const std::string& now) const;
};

std::string tokens_path(const Folder& folder);

// Reads and writes the tokens of a league; a league without the file has no tokens. Only the host
// can read the file. Errors: Errc::damaged for a damaged file.
Result<TokenList> read_tokens(system::Files& files, const Folder& folder);
Result<TokenList> parse_tokens(const std::string& text, const std::string& path);
Result<void> write_tokens(system::Files& files, const Folder& folder, const TokenList& list);

}  // namespace mirocup::league

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 4> enum_names<league::Role>{"team", "staff", "tutor",
                                                                          "assistant"};

}  // namespace mirocup
