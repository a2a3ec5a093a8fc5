// SPDX-License-Identifier: MIT
#include "tournaments/handin/sessions.hpp"

#include "record/json_fields.hpp"
#include "system/digest.hpp"
#include "system/secret.hpp"
#include "web/http/address.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

constexpr const char* sessions_schema = "mirocup/sessions/1";
constexpr std::size_t cookie_bytes = 32;

}  // namespace

static void list_fields(auto& f, Session& session) {
  f("sha256", session.sha256);
  f("token_sha256", session.token_sha256);
  f("ends", session.ends);
}

std::string Sessions::begin(const std::string& token_sha256, std::int64_t now) {
  std::erase_if(sessions_, [now](const Session& session) { return session.ends <= now; });
  const auto is_of_token = [&](const Session& session) {
    return session.token_sha256 == token_sha256;
  };
  if (std::ranges::count_if(sessions_, is_of_token) >= static_cast<std::ptrdiff_t>(max_of_token)) {
    sessions_.erase(std::ranges::find_if(sessions_, is_of_token));
  }
  std::string cookie = system::base32(system::random_bytes(cookie_bytes));
  sessions_.push_back({system::sha256(cookie), token_sha256, now + duration});
  return cookie;
}

std::string Sessions::token_of(std::string_view cookie, std::int64_t now) const {
  const std::string sha256 = system::sha256(cookie);
  for (const Session& session : sessions_) {
    // A clock that was set back by more than the duration has made no session longer.
    if (system::is_same_secret(session.sha256, sha256) && now < session.ends &&
        now >= session.ends - 2 * duration)
      return session.token_sha256;
  }
  return "";
}

void Sessions::end(std::string_view cookie) {
  const std::string sha256 = system::sha256(cookie);
  std::erase_if(sessions_, [&](const Session& session) {
    return system::is_same_secret(session.sha256, sha256);
  });
}

std::string Sessions::text() const {
  return record::json_text(
             {{"schema", sessions_schema}, {"sessions", record::fields_json(sessions_)}}, 1) +
         "\n";
}

Sessions Sessions::parse(const std::string& text) {
  const auto read = [](const record::JsonReader& json) {
    json.expect_schema(sessions_schema);
    Sessions sessions;
    record::FieldReader::read(json.at("sessions"), sessions.sessions_);
    return sessions;
  };
  return record::read_json<Sessions>(text, "sessions", Errc::damaged, read).value_or(Sessions());
}

std::string cookie_in(std::string_view header, std::string_view name) {
  std::string found;
  int count = 0;
  while (!header.empty()) {
    const std::size_t end = std::min(header.find(';'), header.size());
    std::string_view part = header.substr(0, end);
    header.remove_prefix(std::min(end + 1, header.size()));
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    if (part.size() <= name.size() || !part.starts_with(name) || part[name.size()] != '=') continue;
    found = part.substr(name.size() + 1);
    ++count;
  }
  return count == 1 ? found : "";
}

std::int64_t WrongTokens::note(const std::string& address, std::int64_t now) {
  const std::string network = web::counted_address(address);
  if (!addresses_.contains(network) && addresses_.size() >= max_addresses) {
    if (now > swept_) {
      std::erase_if(addresses_,
                    [now](const auto& known) { return now - known.second.last > forgotten_after; });
      swept_ = now;
    }
    // So many addresses at once are no class: nobody of them is looked at soon.
    if (addresses_.size() >= max_addresses) return max_wait;
  }
  Count& count = addresses_[network];
  if (now - count.last > forgotten_after) count = {};
  if (now < count.waits) return count.waits - now;
  ++count.wrong;
  count.last = now;
  if (count.wrong <= free_tries) return 0;
  const int doubled = std::min(count.wrong - free_tries - 1, 10);
  const std::int64_t wait = std::min(max_wait, std::int64_t{1} << doubled);
  count.waits = now + wait;
  return wait;
}

}  // namespace mirocup::league
