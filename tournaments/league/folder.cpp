// SPDX-License-Identifier: MIT
#include "tournaments/league/folder.hpp"

#include "record/json_reader.hpp"
#include "system/file_lock.hpp"
#include "system/links.hpp"
#include "system/locations.hpp"
#include "system/printable.hpp"
#include "system/users.hpp"
#include "tournaments/league/book.hpp"

#include <algorithm>
#include <utility>

namespace mirocup::league {

namespace {

constexpr std::string_view pruned_schema = "mirocup/pruned/1";

std::set<int> nights_in(const record::JsonReader& json) {
  json.expect_object({"schema", "nights"});
  json.expect_schema(pruned_schema);
  std::set<int> nights;
  for (const record::JsonReader& night : json.at("nights").elements(0, max_count))
    nights.insert(night.integer(1, max_count));
  return nights;
}

}  // namespace

Folder::Folder(std::string folder, std::string site)
    : path(std::move(folder)), site_elsewhere_(std::move(site)) {
  for (const std::string& root : {path, site_elsewhere_}) system::follow_no_links_below(root);
}

Result<void> expect_league(system::Files& files, const Folder& folder) {
  if (files.exists(folder.config())) return {};
  // A folder that is closed to this user hides its league.json.
  MIROCUP_TRY_VOID(files.names_if_there(folder.path));
  return fail(Errc::input, folder.path + " is not a league: there is no league.json in it");
}

Result<void> expect_owner(const Folder& folder) {
  const auto owner = system::owner_of(folder.config());
  if (!owner || *owner == system::this_user()) return {};
  const std::string name = system::name_of_user(*owner);
  return fail(Errc::unavailable,
              folder.path + " belongs to " + name +
                  ", who must be able to write to all files in it: run this as " + name +
                  " (sudo -u), or give the folder to " + system::name_of_user(system::this_user()) +
                  " (chown -R)");
}

Result<std::string> library_of(system::Files& files, const TeamConfig& team,
                               const std::string& base) {
  if (team.is_firasim()) return print_firasim_team(team);
  std::string path = team.source;
  if (team.is_house()) {
    const std::string name = path.substr(TeamConfig::house_prefix.size());
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

Result<void> write_entry_file(system::Files& files, const Folder& folder, const std::string& team,
                              int number, const std::string& sha256) {
  const Json about{
      {"schema", "mirocup/entry/1"}, {"team", team}, {"entry", number}, {"sha256", sha256}};
  return files.write(folder.entry_file(team, number), record::json_text(about, 1) + "\n",
                     system::Readers::owner);
}

Result<std::set<int>> read_pruned_nights(system::Files& files, const Folder& folder) {
  MIROCUP_TRY(const auto text,
              files.read_if_there(folder.pruned(), {.max_size = system::size_limit::note}));
  if (!text) return std::set<int>();
  return record::read_json<std::set<int>>(*text, folder.pruned(), Errc::damaged, nights_in);
}

Result<void> write_pruned_nights(system::Files& files, const Folder& folder,
                                 const std::set<int>& nights) {
  if (nights.empty()) return files.remove(folder.pruned());
  const Json json{{"schema", pruned_schema}, {"nights", nights}};
  return files.write(folder.pruned(), record::json_text(json) + "\n");
}

Result<std::string> read_notice(system::Files& files, const Folder& folder) {
  MIROCUP_TRY(const auto text,
              files.read_if_there(folder.notice(), {.max_size = system::size_limit::note}));
  std::string shown = text.value_or("");
  std::erase(shown, '\r');
  shown = system::printable(shown, system::LineEnds::kept);
  return shown.substr(0, shown.find_last_not_of(" \t\n") + 1);
}

Result<void> write_notice(system::Files& files, const Folder& folder, const std::string& text) {
  if (text.empty()) return files.remove(folder.notice());
  if (text.size() > max_notice || system::printable(text, system::LineEnds::kept) != text)
    return fail(Errc::input,
                "a notice is text in UTF-8, of at most " + std::to_string(max_notice) + " bytes");
  return files.write(folder.notice(), text + "\n");
}

Result<void> init_folder(system::Files& files, const Folder& folder, const LeagueFile& file) {
  if (files.exists(folder.config())) {
    return fail(Errc::input, folder.path + " is a league already");
  }
  // Looked at before anything is written, so that nothing is left of a league without a team.
  for (const TeamConfig& team : file.teams) {
    if (team.hands_in()) continue;
    MIROCUP_TRY_VOID(library_of(files, team));
  }
  if (auto made = files.make_folder(folder.path + "/records"); !made) return made;
  // Another process may make a league there at the same time.
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder.lock()));
  if (files.exists(folder.config())) return fail(Errc::input, folder.path + " is a league already");
  MIROCUP_TRY_VOID(files.remove(folder.hand_in_book()));  // of a process that was killed
  MIROCUP_TRY(auto book, Book::open(files, folder));
  for (const TeamConfig& team : file.teams) {
    if (team.hands_in()) continue;
    MIROCUP_TRY(const auto library, library_of(files, team));
    MIROCUP_TRY_VOID(book.give(team.name, library));
  }
  // Written last: a folder with league.json is a complete league.
  return files.write(folder.config(), print_league_file(file));
}

}  // namespace mirocup::league
