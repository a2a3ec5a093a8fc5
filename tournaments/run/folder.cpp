// SPDX-License-Identifier: MIT
#include "tournaments/run/folder.hpp"

#include "server/record/digest.hpp"
#include "server/record/locations.hpp"

namespace mirocup::league {

namespace {

constexpr std::string_view house_prefix = "house:";

Result<std::string> library_of(record::Files& files, const TeamEntry& team) {
  std::string path = team.source;
  if (path.rfind(house_prefix, 0) == 0) {
    const std::string name = path.substr(house_prefix.size());
    path = record::house_team(name);
    if (path.empty())
      return fail(Errc::input, team.name + ": there is no house team \"" + name + "\"");
  }
  return files.read(path);
}

Result<void> add_entry(record::Files& files, const Folder& folder, const TeamEntry& team) {
  const auto library = library_of(files, team);
  if (!library) return tl::unexpected(library.error());
  const int number = 1;
  const Json about{{"schema", "mirocup/entry/1"},
                   {"team", team.name},
                   {"entry", number},
                   {"sha256", record::sha256(*library)}};
  return files.make_folder(folder.entry(team.name, number))
      .and_then([&] { return files.write(folder.library(team.name, number), *library); })
      .and_then([&] {
        return files.write(folder.entry(team.name, number) + "/entry.json", about.dump(1) + "\n");
      });
}

}  // namespace

Result<void> init_folder(record::Files& files, const Folder& folder, const LeagueFile& file) {
  if (files.exists(folder.config())) {
    return fail(Errc::input, folder.path + " is a league already");
  }
  if (auto made = files.make_folder(folder.path + "/records"); !made) return made;
  for (const TeamEntry& team : file.teams) {
    if (auto added = add_entry(files, folder, team); !added) return added;
  }
  // Last: with league.json the folder is a league, and all of it is there.
  return files.write(folder.config(), print_league_file(file));
}

Result<OpenLeague> open_folder(record::Files& files, const Folder& folder, std::string* notice) {
  if (!files.exists(folder.config())) {
    return fail(Errc::input, folder.path + " is not a league: there is no league.json in it");
  }
  const auto text = files.read(folder.config());
  if (!text) return tl::unexpected(text.error());
  auto file = parse_league_file(*text, folder.config());
  if (!file) return tl::unexpected(file.error());
  auto journal = Journal::open(files, folder.journal(), notice);
  if (!journal) return tl::unexpected(journal.error());
  auto state = league_state(std::move(*file), *journal);
  if (!state) return tl::unexpected(state.error());
  if (state->is_started && state->config_sha256 != record::sha256(*text)) {
    return fail(Errc::input, folder.config() + " was changed after the league started");
  }
  return OpenLeague{std::move(*journal), std::move(*state)};
}

}  // namespace mirocup::league
