// SPDX-License-Identifier: MIT
#include "tournaments/league/hand_ins.hpp"

#include "record/json_fields.hpp"

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

}  // namespace

static void list_fields(auto& f, Try& one) {
  f("at", one.at, 0, max_time);
  f("entry", one.entry, 0, max_count);
  f("accepted", one.is_accepted);
  f("message", one.message);
}

static void list_fields(auto& f, HandIns& known) {
  f("pinned", known.pinned, 0, max_count);
  f("tries", known.tries);
}

Result<HandIns> read_hand_ins(system::Files& files, const Folder& folder, const std::string& team) {
  const std::string path = folder.hand_ins(team);
  MIROCUP_TRY(const auto text, files.read_if_there(path, {.max_size = system::size_limit::note}));
  if (!text) return HandIns{};
  return record::read_json<HandIns>(*text, path, Errc::damaged, [](const JsonReader& json) {
    json.expect_schema(hand_ins_schema);
    return record::read_fields<HandIns>(json);
  });
}

Result<void> write_hand_ins(system::Files& files, const Folder& folder, const std::string& team,
                            const HandIns& known) {
  Json json{{"schema", hand_ins_schema}};
  json.update(record::fields_json(known));
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

int tries_in_last_hour(const HandIns& known, std::int64_t now) {
  return static_cast<int>(
      std::count_if(known.tries.begin(), known.tries.end(),
                    [now](const Try& one) { return std::abs(now - one.at) < hour; }));
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
