// SPDX-License-Identifier: MIT
#include "tournaments/league/folder.hpp"

#include "server/record/json_reader.hpp"
#include "system/digest.hpp"
#include "system/file_lock.hpp"
#include "system/locations.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>

namespace mirocup::league {

namespace {

constexpr std::string_view house_prefix = "house:";

// Returns the numbers of all folders of the team's entries, in their order.
std::vector<int> numbers_in(system::Files& files, const Folder& folder, const std::string& team) {
  std::vector<int> numbers;
  const auto names = files.names_in(folder.entries() + "/" + team);
  if (!names) return numbers;
  for (const std::string& name : *names) {
    int number = 0;
    const char* const end = name.data() + name.size();
    const auto read = std::from_chars(name.data(), end, number);
    if (read.ec == std::errc() && read.ptr == end && number >= 1) numbers.push_back(number);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

}  // namespace

Result<void> expect_league(system::Files& files, const Folder& folder) {
  if (files.exists(folder.config())) return {};
  // A folder that is closed to this user hides its league.json.
  if (const auto names = files.names_in(folder.path); !names && files.exists(folder.path))
    return tl::unexpected(names.error());
  return fail(Errc::input, folder.path + " is not a league: there is no league.json in it");
}

Result<std::string> library_of(system::Files& files, const TeamConfig& team,
                               const std::string& base) {
  if (team.is_firasim()) return print_firasim_team(team);
  std::string path = team.source;
  if (path.rfind(house_prefix, 0) == 0) {
    const std::string name = path.substr(house_prefix.size());
    path = system::house_team(name);
    if (path.empty())
      return fail(Errc::input, team.name + ": there is no house team \"" + name + "\"");
  } else if (!base.empty() && !path.starts_with('/')) {
    path = base + "/" + path;
  }
  return files.read(path, {.max_size = system::size_limit::entry});
}

Result<void> make_entries_folder(system::Files& files, const Folder& folder,
                                 const std::string& team) {
  using system::Readers;
  return files.make_folder(folder.entries(), Readers::owner).and_then([&] {
    return files.make_folder(folder.entries() + "/" + team, Readers::owner);
  });
}

Result<void> add_entry(system::Files& files, const Folder& folder, const std::string& team,
                       int number, const std::string& library, const std::string& verdict) {
  using system::Readers;
  const Json about{{"schema", "mirocup/entry/1"},
                   {"team", team},
                   {"entry", number},
                   {"sha256", system::sha256(library)}};
  return make_entries_folder(files, folder, team)
      .and_then([&] { return files.make_folder(folder.entry(team, number), Readers::owner); })
      .and_then([&] { return files.write(folder.library(team, number), library, Readers::owner); })
      .and_then([&]() -> Result<void> {
        if (verdict.empty()) return {};
        return files.write(folder.verdict(team, number), verdict, Readers::owner);
      })
      .and_then([&] {
        return files.write(folder.entry_file(team, number), record::json_text(about, 1) + "\n",
                           Readers::owner);
      });
}

std::vector<int> entries_of(system::Files& files, const Folder& folder, const std::string& team) {
  std::vector<int> numbers = numbers_in(files, folder, team);
  std::erase_if(numbers,
                [&](int number) { return !files.exists(folder.entry_file(team, number)); });
  return numbers;
}

int next_entry(system::Files& files, const Folder& folder, const std::string& team) {
  const std::vector<int> numbers = numbers_in(files, folder, team);
  return numbers.empty() ? 1 : numbers.back() + 1;
}

int last_entry(system::Files& files, const Folder& folder, const std::string& team) {
  const std::vector<int> numbers = entries_of(files, folder, team);
  return numbers.empty() ? 0 : numbers.back();
}

bool is_accepted_entry(system::Files& files, const Folder& folder, const std::string& team,
                       int number) {
  const std::string verdict = folder.verdict(team, number);
  if (!files.exists(verdict)) return true;  // stored by the host without a check
  const auto text = files.read(verdict, {.max_size = system::size_limit::note});
  if (!text) return false;
  // A verdict that cannot be read is none.
  return record::read_json<bool>(
             *text, verdict, Errc::damaged,
             [](const record::JsonReader& json) { return json.at("accepted").boolean(); })
      .value_or(false);
}

int last_accepted_entry(system::Files& files, const Folder& folder, const std::string& team) {
  const std::vector<int> numbers = entries_of(files, folder, team);
  const auto last = std::find_if(numbers.rbegin(), numbers.rend(), [&](int number) {
    return is_accepted_entry(files, folder, team, number);
  });
  return last == numbers.rend() ? 0 : *last;
}

Result<std::vector<std::string>> adopt_libraries(system::Files& files, const Folder& folder,
                                                 const LeagueFile& file) {
  std::vector<std::string> adopted;
  for (const TeamConfig& team : file.teams) {
    if (team.hands_in()) continue;
    const int last = last_entry(files, folder, team.name);
    const bool may_change = team.is_house() || team.is_firasim();
    if (last > 0 && (!may_change || files.exists(folder.verdict(team.name, last)))) continue;
    const auto library = library_of(files, team, folder.path);
    if (!library) return tl::unexpected(library.error());
    if (last > 0) {
      const auto before =
          files.read(folder.library(team.name, last), {.max_size = system::size_limit::entry});
      if (before && *before == *library) continue;
    }
    const int number = next_entry(files, folder, team.name);
    if (auto added = add_entry(files, folder, team.name, number, *library); !added)
      return tl::unexpected(added.error());
    adopted.push_back(team.name);
  }
  return adopted;
}

Result<void> init_folder(system::Files& files, const Folder& folder, const LeagueFile& file) {
  if (files.exists(folder.config())) {
    return fail(Errc::input, folder.path + " is a league already");
  }
  // Looked at before anything is written, so that nothing is left of a league without a team.
  for (const TeamConfig& team : file.teams) {
    if (team.hands_in()) continue;
    if (auto library = library_of(files, team); !library) return tl::unexpected(library.error());
  }
  if (auto made = files.make_folder(folder.path + "/records"); !made) return made;
  // Another process may make a league there at the same time.
  const auto lock = system::FileLock::acquire(folder.lock());
  if (!lock) return tl::unexpected(lock.error());
  if (files.exists(folder.config())) return fail(Errc::input, folder.path + " is a league already");
  for (const TeamConfig& team : file.teams) {
    if (team.hands_in()) continue;
    const auto library = library_of(files, team);
    if (!library) return tl::unexpected(library.error());
    if (auto added = add_entry(files, folder, team.name, 1, *library); !added) return added;
  }
  // Written last: a folder with league.json is a complete league.
  return files.write(folder.config(), print_league_file(file));
}

}  // namespace mirocup::league
