// SPDX-License-Identifier: MIT
#include "tournaments/league/folder.hpp"

#include "server/system/digest.hpp"
#include "server/system/locations.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

namespace {

constexpr std::string_view house_prefix = "house:";

}  // namespace

Result<std::string> library_of(system::Files& files, const TeamConfig& team) {
  std::string path = team.source;
  if (path.rfind(house_prefix, 0) == 0) {
    const std::string name = path.substr(house_prefix.size());
    path = system::house_team(name);
    if (path.empty())
      return fail(Errc::input, team.name + ": there is no house team \"" + name + "\"");
  }
  return files.read(path);
}

Result<void> add_entry(system::Files& files, const Folder& folder, const std::string& team,
                       int number, const std::string& library, const std::string& verdict) {
  const Json about{{"schema", "mirocup/entry/1"},
                   {"team", team},
                   {"entry", number},
                   {"sha256", system::sha256(library)}};
  return files.make_folder(folder.entry(team, number))
      .and_then([&] { return files.write(folder.library(team, number), library); })
      .and_then([&]() -> Result<void> {
        if (verdict.empty()) return {};
        return files.write(folder.verdict(team, number), verdict);
      })
      .and_then([&] {
        return files.write(folder.entry(team, number) + "/entry.json", about.dump(1) + "\n");
      });
}

int last_entry(system::Files& files, const Folder& folder, const std::string& team) {
  int number = 0;
  while (files.exists(folder.entry(team, number + 1) + "/entry.json")) ++number;
  return number;
}

int last_accepted_entry(system::Files& files, const Folder& folder, const std::string& team) {
  for (int number = last_entry(files, folder, team); number > 0; --number) {
    const std::string verdict = folder.verdict(team, number);
    if (!files.exists(verdict)) return number;  // added by the host, without a check
    const auto text = files.read(verdict);
    const Json json = text ? Json::parse(*text, nullptr, false) : Json();
    if (json.is_object() && json.contains("accepted") && json["accepted"] == true) return number;
  }
  return 0;
}

Result<void> init_folder(system::Files& files, const Folder& folder, const LeagueFile& file) {
  if (files.exists(folder.config())) {
    return fail(Errc::input, folder.path + " is a league already");
  }
  if (auto made = files.make_folder(folder.path + "/records"); !made) return made;
  for (const TeamConfig& team : file.teams) {
    const auto library = library_of(files, team);
    if (!library) return tl::unexpected(library.error());
    if (auto added = add_entry(files, folder, team.name, 1, *library); !added) return added;
  }
  // Written last: a folder with league.json is a complete league.
  return files.write(folder.config(), print_league_file(file));
}

}  // namespace mirocup::league
