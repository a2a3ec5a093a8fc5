// SPDX-License-Identifier: MIT
#include "tournaments/league/start.hpp"

#include "record/match_record.hpp"
#include "system/digest.hpp"
#include "tournaments/league/gaps.hpp"
#include "tournaments/league/hand_ins.hpp"

namespace mirocup::league {

namespace {

Result<void> write_start(system::Files& files, LeagueStore& store) {
  const LeagueState& state = store.state();
  if (state.is_started) return {};
  const std::string why = objection(state.file.format, static_cast<int>(state.file.teams.size()));
  if (!why.empty()) return fail(Errc::input, store.folder().config() + ": " + why);
  MIROCUP_TRY_VOID(adopt_libraries(files, store.folder(), state.file));
  const bool is_nightly = state.file.format.kind == FormatKind::nightly;
  int ready = 0;
  std::string missing;
  for (const TeamConfig& team : state.file.teams) {
    MIROCUP_TRY(const auto accepted, last_accepted_entry(files, store.folder(), team.name));
    if (accepted > 0) {
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
Result<void> book_entries(system::Files& files, LeagueStore& store) {
  const LeagueState& state = store.state();
  for (std::size_t i = 0; i < state.teams.size(); ++i) {
    const std::string& team = state.file.teams[i].name;
    const TeamState& booked = state.teams[i];
    if (booked.status == TeamStatus::withdrawn) continue;
    // A night books the entries of a nightly league.
    if (booked.entry == 0 && state.file.format.kind == FormatKind::nightly) continue;
    MIROCUP_TRY(const auto number, booked.entry > 0 ? Result<int>(booked.entry)
                                                    : playing_entry(files, store.folder(), team));
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
  if (auto started = write_start(files, store); !started) return started;
  return book_entries(files, store);
}

}  // namespace mirocup::league
