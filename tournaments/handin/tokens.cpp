// SPDX-License-Identifier: MIT
#include "tournaments/handin/tokens.hpp"

#include "record/json_reader.hpp"
#include "system/digest.hpp"
#include "system/secret.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

using record::JsonReader;
using record::or_null;

constexpr const char* tokens_schema = "mirocup/tokens/1";
constexpr std::size_t token_bytes = 16;  // 26 characters
constexpr std::size_t max_typed = 200;   // characters; nobody types more by mistake

// Returns the token as it was printed.
std::string as_printed(std::string_view typed) {
  std::string text;
  for (const char c : typed.substr(0, max_typed)) {
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
    text += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return text;
}

std::string time_of(const JsonReader& json) {
  if (json.is_null()) return "";
  std::string time = json.text();
  if (!is_time(time)) json.complain("a time like \"2026-11-30T18:00:00Z\" is expected");
  return time;
}

// A token of no team without a role is the staff's.
Role role_of(const JsonReader& token) {
  if (!token.at("team").is_null()) return Role::team;
  const auto named = token.find("role");
  if (!named) return Role::staff;
  const auto role = from_string<Role>(named->text());
  if (!role || *role == Role::team) named->complain("\"tutor\" or \"assistant\" is expected");
  return role.value_or(Role::tutor);
}

const Token* find_in(const std::vector<Token>& tokens, const std::string& sha256,
                     const std::string& now, bool is_valid) {
  const auto found = std::ranges::find_if(tokens, [&](const Token& token) {
    return system::is_same_secret(token.sha256, sha256) && token.is_valid(now) == is_valid;
  });
  return found == tokens.end() ? nullptr : &*found;
}

}  // namespace

std::string TokenList::add(const std::string& team, const std::string& now,
                           const std::string& expires) {
  std::string text = add_for(Role::team, "", now, expires);
  tokens.back().team = team;
  return text;
}

std::string TokenList::add_for(Role role, const std::string& person, const std::string& now,
                               const std::string& expires) {
  std::string text = system::base32(system::random_bytes(token_bytes));
  tokens.push_back({.team = "",
                    .role = role,
                    .person = person,
                    .sha256 = system::sha256(text),
                    .made = now,
                    .expires = expires,
                    .revoked = ""});
  return text;
}

int TokenList::revoke(Role role, const std::string& team, const std::string& person,
                      const std::string& now) {
  int count = 0;
  for (Token& token : tokens) {
    if (token.role != role || token.team != team || !token.revoked.empty()) continue;
    if (!person.empty() && token.person != person) continue;
    count += token.is_valid(now) ? 1 : 0;
    token.revoked = now;
  }
  return count;
}

bool TokenList::has_valid(const std::string& team, const std::string& now) const {
  return std::ranges::any_of(
      tokens, [&](const Token& token) { return token.team == team && token.is_valid(now); });
}

const Token* TokenList::find(std::string_view text, const std::string& now) const {
  return find_sha256(system::sha256(as_printed(text)), now);
}

const Token* TokenList::find_sha256(const std::string& sha256, const std::string& now) const {
  return find_in(tokens, sha256, now, true);
}

const Token* TokenList::find_ended(std::string_view text, const std::string& now) const {
  return find_in(tokens, system::sha256(as_printed(text)), now, false);
}

std::string tokens_path(const Folder& folder) {
  return folder.path + "/tokens.json";
}

Result<TokenList> read_tokens(system::Files& files, const Folder& folder) {
  const std::string path = tokens_path(folder);
  MIROCUP_TRY(const auto text, files.read_if_there(path, {.max_size = system::size_limit::note}));
  return text ? parse_tokens(*text, path) : TokenList{};
}

Result<TokenList> parse_tokens(const std::string& text, const std::string& path) {
  return record::read_json<TokenList>(text, path, Errc::damaged, [](const JsonReader& json) {
    json.expect_schema(tokens_schema);
    TokenList list;
    for (const JsonReader& one : json.at("tokens").elements()) {
      Token token;
      token.role = role_of(one);
      if (token.role == Role::team) token.team = one.at("team").text();
      if (token.role == Role::team && !is_good_name(token.team))
        one.at("team").complain("the name of a team is expected");
      one.read_if_present("name", token.person);
      token.sha256 = one.at("sha256").text();
      token.made = time_of(one.at("made"));
      token.expires = time_of(one.at("expires"));
      token.revoked = time_of(one.at("revoked"));
      list.tokens.push_back(std::move(token));
    }
    return list;
  });
}

Result<void> write_tokens(system::Files& files, const Folder& folder, const TokenList& list) {
  Json tokens = Json::array();
  for (const Token& token : list.tokens) {
    tokens.push_back({{"team", token.role == Role::team ? Json(token.team) : Json()},
                      {"sha256", token.sha256},
                      {"made", or_null(token.made)},
                      {"expires", or_null(token.expires)},
                      {"revoked", or_null(token.revoked)}});
    if (token.role != Role::team && token.role != Role::staff)
      tokens.back()["role"] = to_string(token.role);
    if (!token.person.empty()) tokens.back()["name"] = token.person;
  }
  const Json json{{"schema", tokens_schema}, {"tokens", tokens}};
  return files.write(tokens_path(folder), record::json_text(json, 1) + "\n",
                     system::Readers::owner);
}

}  // namespace mirocup::league
