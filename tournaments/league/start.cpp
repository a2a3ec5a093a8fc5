// SPDX-License-Identifier: MIT
#include "record/match_record.hpp"
#include "system/digest.hpp"
#include "system/file_lock.hpp"
#include "tournaments/league/gaps.hpp"
#include "tournaments/league/league_store.hpp"
#include "tournaments/league/submission.hpp"

namespace mirocup::league {

namespace {

// Stores the libraries that league.json names, for teams without an entry and for house teams whose
// library has changed. So a person may add teams to league.json after `init`. Relative paths begin
// at the league's folder.
Result<void> adopt_libraries(system::Files& files, const Folder& folder, const LeagueFile& file,
                             Book& book) {
  for (const TeamConfig& team : file.teams) {
    if (team.hands_in()) continue;
    const HandedIn* last = book.hand_ins().find(team.name, book.hand_ins().last_kept(team.name));
    const bool may_change = team.is_house() || team.is_firasim();
    if (last != nullptr && (!may_change || !last->file.empty())) continue;
    MIROCUP_TRY(const auto library, library_of(files, team, folder.path));
    if (last != nullptr && last->library == system::sha256(library)) continue;
    MIROCUP_TRY_VOID(book.give(team.name, library));
  }
  return {};
}

Result<void> write_start(system::Files& files, LeagueStore& store, Book& book) {
  const LeagueState& state = store.state();
  if (state.is_started) return {};
  const std::string why = objection(state.file.format, static_cast<int>(state.file.teams.size()));
  if (!why.empty()) return fail(Errc::input, store.folder().config() + ": " + why);
  MIROCUP_TRY_VOID(adopt_libraries(files, store.folder(), state.file, book));
  const bool is_nightly = state.file.format.kind == FormatKind::nightly;
  int ready = 0;
  std::string missing;
  for (const TeamConfig& team : state.file.teams) {
    if (book.hand_ins().last_accepted(team.name) > 0) {
      ++ready;
    } else if (!is_nightly) {
      missing += (missing.empty() ? "" : ", ") + team.name;
    }
  }
  if (!missing.empty()) {
    return fail(Errc::input, "no entry of " + missing +
                                 " was accepted; league withdraw takes a team out of the league");
  }
  if (ready < 2)
    return fail(Errc::input,
                "a league needs two teams with an accepted entry and has " + std::to_string(ready));
  MIROCUP_TRY(const auto config,
              files.read_named(store.folder().config(), system::size_limit::league_file));
  const record::Software program = record::this_software();
  return store.write(Started{.config_sha256 = system::sha256(without_site(config)),
                             .version = program.version,
                             .conditions = state.file.conditions.value_or(default_conditions()),
                             .build = program.build,
                             .game = program.behaviour_hash});
}

// Books the entry of each team that has none, and checks the libraries of the others against the
// SHA-256 that the journal names.
Result<void> book_entries(system::Files& files, LeagueStore& store, const HandIns& hand_ins) {
  const LeagueState& state = store.state();
  for (std::size_t i = 0; i < state.teams.size(); ++i) {
    const std::string& team = state.file.teams[i].name;
    const TeamState& booked = state.teams[i];
    if (booked.status == TeamStatus::withdrawn) continue;
    // A night books the entries of a nightly league.
    if (booked.entry == 0 && state.file.format.kind == FormatKind::nightly) continue;
    const int number = booked.entry > 0 ? booked.entry : hand_ins.playing(team);
    const std::string path = store.folder().library(team, number);
    MIROCUP_TRY(const auto library, files.read(path, {.max_size = system::size_limit::entry}));
    const std::string sha256 = system::sha256(library);
    if (booked.entry == 0) {
      MIROCUP_TRY_VOID(store.write(EntryBooked{.team = team, .entry = number, .sha256 = sha256}));
    } else if (booked.sha256 != sha256) {
      return fail(Errc::damaged, path + " is not the library that the league was started with");
    }
  }
  return {};
}

}  // namespace

Result<void> start_league(system::Files& files, LeagueStore& store) {
  // Another process may have played the league until now.
  MIROCUP_TRY_VOID(store.refresh());
  MIROCUP_TRY(const auto found, gaps(files, store, false));
  if (!found.lost.empty()) return fail(Errc::damaged, found.lost);
  // A folder that is empty gets lost when a league is kept in git or packed by some programs.
  if (auto made = files.make_folder(store.folder().path + "/records"); !made) return made;
  MIROCUP_TRY(const auto alone, system::FileLock::acquire(store.folder().submitting()));
  MIROCUP_TRY(auto book, Book::open(files, store.folder()));
  MIROCUP_TRY_VOID(write_start(files, store, book));
  MIROCUP_TRY_VOID(book_entries(files, store, book.hand_ins()));
  for (const TeamConfig& team : store.state().file.teams)
    MIROCUP_TRY_VOID(follow_book(files, store, book.hand_ins(), team.name));
  return {};
}

}  // namespace mirocup::league
