// SPDX-License-Identifier: MIT
#include "tournaments/league/submission.hpp"

#include "server/system/digest.hpp"
#include "server/system/locations.hpp"
#include "server/system/process_set.hpp"
#include "tournaments/journal/file_lock.hpp"

namespace mirocup::league {

namespace {

// Returns the answer of `mirocup check --json` about a library. Any exit code but yes and no is an
// error of the host.
Result<Json> check(system::Files& files, const std::string& library, League league,
                   const std::string& log) {
  system::ProcessSet processes;
  const auto started = processes.start({system::sibling_program("mirocup"), "check", library,
                                        "--json", "--league", std::string(to_string(league))},
                                       0, -1, log);
  if (!started) return tl::unexpected(started.error());
  const auto exit = processes.wait();
  if (!exit) return fail(Errc::interrupted, "interrupted while an entry was checked");
  const auto text = files.read(log);
  if (!text) return tl::unexpected(text.error());
  // The answer is the last line; the log of the check precedes it.
  const std::size_t begin = text->rfind("\n{");
  Json verdict =
      Json::parse(text->substr(begin == std::string::npos ? 0 : begin + 1), nullptr, false);
  if (exit->signal != 0 || (exit->code != exit_yes && exit->code != exit_no) ||
      verdict.is_discarded() || !verdict.contains("accepted")) {
    return fail(Errc::host, "the check of an entry failed: " + *text);
  }
  return verdict;
}

// Returns why no entry of this team is taken now; "" if entries are taken.
std::string objection_to(const LeagueState& state, const std::string& team,
                         const std::string& now) {
  const bool is_ladder = state.file.format.kind == FormatKind::ladder;
  const auto known = state.find_team(team);
  if (!state.file.freeze.empty() && now >= state.file.freeze)
    return "entries are frozen since " + state.file.freeze;
  if (state.is_started && !is_ladder) return "entries are frozen: the league has started";
  if (state.is_started && !known) return "there is no team " + team + " in this league";
  if (known && state.teams[*known].status == TeamStatus::withdrawn) return team + " has withdrawn";
  return "";
}

// Adds a team to league.json of a league that has not started.
Result<void> add_team(system::Files& files, const Folder& folder, LeagueFile file,
                      const std::string& team) {
  file.teams.push_back({.name = team, .source = "submitted", .over_dds = false});
  return files.write(folder.config(), print_league_file(file));
}

// Stores the library as that entry, checks it there, and writes the verdict beside it.
Result<Json> store_and_check(system::Files& files, const Folder& folder, League league,
                             const std::string& team, int number, const std::string& path,
                             const std::string& library) {
  const std::string entry = folder.entry(team, number);
  const std::string stored = folder.library(team, number);
  auto written = files.make_folder(entry).and_then([&] { return files.write(stored, library); });
  if (!written) return tl::unexpected(written.error());
  auto verdict = check(files, stored, league, entry + "/check.log");
  if (!verdict) return verdict;
  (*verdict)["file"] = path;
  auto added = add_entry(files, folder, team, number, library, verdict->dump(1) + "\n");
  if (!added) return tl::unexpected(added.error());
  return verdict;
}

// Makes an accepted entry the one that plays: before the start a new team joins the league, after
// the start the entry is booked.
Result<void> let_play(system::Files& files, LeagueStore& store, const std::string& team, int number,
                      const std::string& library) {
  if (!store.state().find_team(team)) {
    if (auto added = add_team(files, store.folder(), store.state().file, team); !added)
      return added;
  }
  if (!store.state().is_started) return {};
  return store.write(EntryBooked{.team = team, .entry = number, .sha256 = system::sha256(library)});
}

}  // namespace

Result<Submission> submit(system::Files& files, const Folder& folder, const std::string& team,
                          const std::string& path, const std::string& now) {
  // Submissions are handled one at a time, so that each number is used once and checks do not slow
  // each other down.
  const auto lock = FileLock::acquire(folder.submitting());
  if (!lock) return tl::unexpected(lock.error());
  auto store = LeagueStore::open(files, folder);
  if (!store) return tl::unexpected(store.error());
  if (!is_good_name(team)) {
    return fail(Errc::input,
                "\"" + team + "\" is no name: letters, digits, '-', '_' and '.', at most 40");
  }
  Submission result;
  if (const std::string why = objection_to(store->state(), team, now); !why.empty()) {
    result.message = team + ": not taken: " + why;
    return result;
  }
  const auto library = files.read(path);
  if (!library) return tl::unexpected(library.error());

  const int before = last_accepted_entry(files, folder, team);
  result.entry = last_entry(files, folder, team) + 1;
  auto verdict = store_and_check(files, folder, store->state().file.league, team, result.entry,
                                 path, *library);
  if (!verdict) return tl::unexpected(verdict.error());
  result.verdict = std::move(*verdict);
  result.is_accepted = result.verdict["accepted"] == true;
  result.message = team + ": entry " + std::to_string(result.entry) +
                   (result.is_accepted ? " was accepted" : " was not accepted");
  if (!result.is_accepted) {
    result.message += ": " + result.verdict.value("reason", "");
    if (before > 0) result.message += "; entry " + std::to_string(before) + " plays on";
    return result;
  }
  if (auto playing = let_play(files, *store, team, result.entry, *library); !playing) {
    return tl::unexpected(playing.error());
  }
  return result;
}

}  // namespace mirocup::league
