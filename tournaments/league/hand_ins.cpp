// SPDX-License-Identifier: MIT
#include "tournaments/league/hand_ins.hpp"

#include "record/json_reader.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>

namespace mirocup::league {

namespace {

using record::JsonReader;

constexpr const char* hand_ins_schema = "mirocup/hand-ins/1";
constexpr std::int64_t hour = 3600;                       // s
constexpr std::int64_t max_time = std::int64_t{1} << 40;  // s
constexpr std::size_t max_tries = 100;                    // remembered

bool has(const std::vector<int>& numbers, int number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

std::optional<uid_t> read_user(const JsonReader& json) {
  return json.is_null() ? std::nullopt : std::optional(json.integer<uid_t>());
}

Json user_json(const std::optional<uid_t>& user) {
  return user ? Json(*user) : Json();
}

}  // namespace

Result<HandIns> read_hand_ins(system::Files& files, const Folder& folder, const std::string& team) {
  const std::string path = folder.hand_ins(team);
  MIROCUP_TRY(const auto text, files.read_if_there(path, {.max_size = system::size_limit::note}));
  if (!text) return HandIns{};
  return record::read_json<HandIns>(*text, path, Errc::damaged, [](const JsonReader& json) {
    json.expect_schema(hand_ins_schema);
    HandIns known;
    known.owner = read_user(json.at("owner"));
    known.last_user = read_user(json.at("last_user"));
    // Not in files of versions before it.
    if (json.has("pinned")) known.pinned = json.at("pinned").integer(0, max_count);
    known.last_file = json.at("last_file").text();
    for (const JsonReader& line : json.at("tries").elements()) {
      Try one;
      one.at = line.at("at").integer<std::int64_t>(0, max_time);
      one.user = read_user(line.at("user"));
      one.entry = line.at("entry").integer(0, max_count);
      one.is_accepted = line.at("accepted").boolean();
      one.message = line.at("message").text();
      known.tries.push_back(std::move(one));
    }
    return known;
  });
}

Result<void> write_hand_ins(system::Files& files, const Folder& folder, const std::string& team,
                            const HandIns& known) {
  Json tries = Json::array();
  for (const Try& one : known.tries) {
    tries.push_back({{"at", one.at},
                     {"user", user_json(one.user)},
                     {"entry", one.entry},
                     {"accepted", one.is_accepted},
                     {"message", one.message}});
  }
  const Json json{{"schema", hand_ins_schema},
                  {"owner", user_json(known.owner)},
                  {"last_user", user_json(known.last_user)},
                  {"pinned", known.pinned},
                  {"last_file", known.last_file},
                  {"tries", tries}};
  return make_entries_folder(files, folder, team).and_then([&] {
    return files.write(folder.hand_ins(team), record::json_text(json, 1) + "\n",
                       system::Readers::owner);
  });
}

Result<int> playing_entry(system::Files& files, const Folder& folder, const std::string& team) {
  MIROCUP_TRY(const auto known, read_hand_ins(files, folder, team));
  const int pinned = known.pinned;
  if (pinned > 0 && files.exists(folder.entry_file(team, pinned))) {
    MIROCUP_TRY(const auto is_accepted, is_accepted_entry(files, folder, team, pinned));
    if (is_accepted) return pinned;
  }
  return last_accepted_entry(files, folder, team);
}

void add_try(HandIns& known, Try next) {
  known.tries.push_back(std::move(next));
  if (known.tries.size() > max_tries) known.tries.erase(known.tries.begin());
}

Try* find_try(HandIns& known, int entry) {
  const auto found = std::find_if(known.tries.rbegin(), known.tries.rend(),
                                  [entry](const Try& one) { return one.entry == entry; });
  return found == known.tries.rend() ? nullptr : &*found;
}

int tries_in_last_hour(const HandIns& known, std::int64_t now, const std::optional<uid_t>& user) {
  return static_cast<int>(std::count_if(
      known.tries.begin(), known.tries.end(),
      [&](const Try& one) { return one.user == user && std::abs(now - one.at) < hour; }));
}

Result<int> teams_of_user(system::Files& files, const Folder& folder, uid_t user) {
  MIROCUP_TRY(const auto teams, files.names_if_there(folder.entries()));
  int count = 0;
  for (const std::string& team : teams) {
    if (!is_good_name(team)) continue;
    MIROCUP_TRY(const auto known, read_hand_ins(files, folder, team));
    if (known.owner ? known.owner == user : known.last_user == user) ++count;
  }
  return count;
}

Result<void> prune_versions(system::Files& files, const Folder& folder, const std::string& team,
                            const std::vector<int>& played, const Quota& quota) {
  MIROCUP_TRY(const auto all, entries_of(files, folder, team));
  MIROCUP_TRY(const auto latest, last_accepted_entry(files, folder, team));
  MIROCUP_TRY(const auto playing, playing_entry(files, folder, team));
  std::vector<int> refused;
  std::vector<int> others;  // that may go
  for (const int number : all) {
    const bool stays = number == playing || number == latest || number == all.back();
    if (stays || has(played, number)) continue;
    MIROCUP_TRY(const auto is_accepted, is_accepted_entry(files, folder, team, number));
    (is_accepted ? others : refused).push_back(number);
  }
  for (const int number : refused) {
    if (auto removed = files.remove(folder.library(team, number)); !removed) return removed;
  }
  const auto not_played =
      std::count_if(all.begin(), all.end(), [&](int number) { return !has(played, number); });
  refused.insert(refused.end(), others.begin(), others.end());
  const auto too_many = std::max<std::ptrdiff_t>(0, not_played - quota.versions);
  refused.resize(std::min<std::size_t>(refused.size(), static_cast<std::size_t>(too_many)));
  for (const int number : refused) {
    if (auto removed = files.remove(folder.entry(team, number)); !removed) return removed;
  }
  return {};
}

}  // namespace mirocup::league
