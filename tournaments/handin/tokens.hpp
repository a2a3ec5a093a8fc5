// SPDX-License-Identifier: MIT
//
// The tokens by which teams hand in: random words of 128 bits. tokens.json in the folder of the
// league keeps only the SHA-256 of each, so a token is shown once, when it is made. A token of so
// many bits cannot be guessed, so a slow hash would give no further protection.
#pragma once

#include "core/base/names.hpp"
#include "tournaments/league/folder.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::league {

// The owner of a token. The staff sees the private pages of all teams and decides; a tutor sees the
// same and changes nothing.
enum class Role { team, staff, tutor };

struct Token {
  std::string team;  // "" if it is not a team's
  Role role = Role::team;
  std::string sha256;
  std::string made;     // UTC, as league.json has times
  std::string expires;  // UTC; from then on it is not valid; "": never
  std::string revoked;  // UTC, when it was revoked; "": it was not

  bool is_valid(const std::string& now) const {
    return revoked.empty() && (expires.empty() || now < expires);
  }
  bool operator==(const Token&) const = default;
};

// All tokens of a league, also those that are revoked or have expired.
struct TokenList {
  std::vector<Token> tokens;

  // Makes a token and returns its text, of which only the hash is kept.
  std::string add(const std::string& team, const std::string& now, const std::string& expires);
  std::string add_for(Role staff_or_tutor, const std::string& now, const std::string& expires);

  // Revokes all tokens of a team, or of one role (then `team` is ""). Returns how many were valid
  // until now.
  int revoke(Role role, const std::string& team, const std::string& now);

  bool has_valid(const std::string& team, const std::string& now) const;

  // Returns the valid token with this text, or of this SHA-256; null if there is none. The text may
  // have small letters and blanks.
  const Token* find(std::string_view text, const std::string& now) const;
  const Token* find_sha256(const std::string& sha256, const std::string& now) const;

  // Returns the token with this text if it is revoked or has expired; null if not.
  const Token* find_ended(std::string_view text, const std::string& now) const;
};

std::string tokens_path(const Folder& folder);

// Reads and writes the tokens of a league; a league without the file has no tokens. Only the host
// can read the file. A damaged file is Errc::damaged.
Result<TokenList> read_tokens(system::Files& files, const Folder& folder);
Result<TokenList> parse_tokens(const std::string& text, const std::string& path);
Result<void> write_tokens(system::Files& files, const Folder& folder, const TokenList& list);

}  // namespace mirocup::league

namespace mirocup {

template <>
inline constexpr std::array<std::string_view, 3> enum_names<league::Role>{"team", "staff", "tutor"};

}  // namespace mirocup
