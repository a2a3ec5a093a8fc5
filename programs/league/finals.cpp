// SPDX-License-Identifier: MIT
#include "programs/league/finals.hpp"

#include "tournaments/league/book.hpp"
#include "tournaments/league/people.hpp"

#include <algorithm>
#include <filesystem>

namespace mirocup::league {

namespace {

// Returns a team of another league with one of its entries; 0: the entry that was accepted last.
Result<TeamConfig> finalist(const LeagueStore& store, const Book& book, int team, int entry) {
  namespace fs = std::filesystem;
  TeamConfig config = store.state().file.teams[team];
  config.has_joined = false;
  const fs::path base = fs::absolute(store.folder().path).lexically_normal();
  if (config.is_firasim()) {
    config.program.folder = (base / config.program.folder).lexically_normal().string();
  } else if (!config.is_house() && !config.over_dds) {
    if (entry == 0) entry = book.hand_ins().last_accepted(config.name);
    if (entry == 0) return fail(Errc::input, config.name + " has no accepted entry");
    config.source = Folder{base.string()}.library(config.name, entry);
  }
  return config;
}

LeagueFile as_season(const LeagueStore& store, const std::string& title) {
  LeagueFile file = store.state().file;
  file.title = title;
  file.freeze.clear();
  file.extensions.clear();
  file.site.clear();
  file.teams.clear();
  return file;
}

}  // namespace

Result<LeagueFile> finals(system::Files& files, const LeagueStore& store, const std::string& title,
                          int top) {
  const LeagueState& season = store.state();
  LeagueFile file = as_season(store, title);
  file.format = {.kind = FormatKind::knockout};
  MIROCUP_TRY(const auto book, Book::open(files, store.folder()));
  for (const TableRow& row : season.table()) {
    if (season.teams[row.team].status == TeamStatus::withdrawn || row.played == 0) continue;
    if (static_cast<int>(file.teams.size()) == top) break;
    MIROCUP_TRY(auto team, finalist(store, book, row.team, season.teams[row.team].entry));
    file.teams.push_back(std::move(team));
  }
  if (static_cast<int>(file.teams.size()) < top)
    return fail(Errc::input, "--top " + std::to_string(top) + ": only " +
                                 std::to_string(file.teams.size()) + " teams of " +
                                 store.folder().path + " have played and have not withdrawn");
  return file;
}

Result<LeagueFile> closing_round(system::Files& files, const LeagueStore& store, FormatKind kind,
                                 int legs) {
  const LeagueState& season = store.state();
  LeagueFile file = as_season(store, season.file.title + ", closing round");
  // A double round robin of more legs is a round robin.
  file.format = {.kind = legs == legs_per_fixture ? kind : FormatKind::round_robin, .legs = legs};
  MIROCUP_TRY(const auto book, Book::open(files, store.folder()));
  for (const TableRow& row : season.table()) {
    if (season.teams[row.team].status == TeamStatus::withdrawn) continue;
    const int entry = book.hand_ins().playing(season.name(row.team));
    const TeamConfig& config = season.file.teams[row.team];
    if (entry == 0 && config.hands_in()) continue;
    MIROCUP_TRY(auto team, finalist(store, book, row.team, entry));
    file.teams.push_back(std::move(team));
  }
  if (file.teams.size() < 2)
    return fail(Errc::input,
                store.folder().path + ": a closing round needs two teams with entries");
  return file;
}

Result<void> init_from(system::Files& files, const LeagueStore& season, const Folder& folder,
                       const LeagueFile& file, bool knows_everybody) {
  MIROCUP_TRY_VOID(init_folder(files, folder, file));
  MIROCUP_TRY(auto people, read_people(files, season.folder()));
  std::erase_if(people, [&](const auto& one) {
    return !knows_everybody && std::ranges::count(file.teams, one.first, &TeamConfig::name) == 0;
  });
  if (people.empty()) return {};
  return write_people(files, folder, people);
}

}  // namespace mirocup::league
