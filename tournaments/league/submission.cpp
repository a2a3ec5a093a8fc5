// SPDX-License-Identifier: MIT
#include "tournaments/league/submission.hpp"

#include "server/system/digest.hpp"
#include "server/system/locations.hpp"
#include "server/system/process_set.hpp"
#include "tournaments/journal/file_lock.hpp"

namespace mirocup::league {

namespace {

// What `mirocup check --json` says of a library, its exit code being yes or no.
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
  // One line of JSON, after what else was said.
  const std::size_t begin = text->rfind("\n{");
  Json verdict =
      Json::parse(text->substr(begin == std::string::npos ? 0 : begin + 1), nullptr, false);
  if (exit->signal != 0 || (exit->code != exit_yes && exit->code != exit_no) ||
      verdict.is_discarded() || !verdict.contains("accepted")) {
    return fail(Errc::host, "the check of an entry failed: " + *text);
  }
  return verdict;
}

Submission refused(const std::string& message) {
  return {false, 0, message, Json()};
}

// Why no entry of this team is taken now; "" if one is.
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

// Adds a team to the file of a league that has not started.
Result<void> add_team(system::Files& files, const Folder& folder, LeagueFile file,
                      const std::string& team) {
  file.teams.push_back({team, "submitted", false});
  return files.write(folder.config(), print_league_file(file));
}

}  // namespace

Result<Submission> submit(system::Files& files, const Folder& folder, const std::string& team,
                          const std::string& path, const std::string& now) {
  // One at a time: numbers are given once, and checks do not slow each other down.
  const auto alone = FileLock::acquire(folder.submitting());
  if (!alone) return tl::unexpected(alone.error());
  auto store = LeagueStore::open(files, folder);
  if (!store) return tl::unexpected(store.error());
  if (!is_good_name(team)) {
    return fail(Errc::input,
                "\"" + team + "\" is no name: letters, digits, '-', '_' and '.', at most 40");
  }
  if (const std::string why = objection_to(store->state(), team, now); !why.empty())
    return refused(team + ": not taken: " + why);

  const auto library = files.read(path);
  if (!library) return tl::unexpected(library.error());
  const int number = last_entry(files, folder, team) + 1;
  const int before = last_accepted_entry(files, folder, team);
  const std::string own = folder.library(team, number);
  auto stored = files.make_folder(folder.entry(team, number)).and_then([&] {
    return files.write(own, *library);
  });
  if (!stored) return tl::unexpected(stored.error());
  auto verdict =
      check(files, own, store->state().file.league, folder.entry(team, number) + "/check.log");
  if (!verdict) return tl::unexpected(verdict.error());
  (*verdict)["file"] = path;
  if (auto added = add_entry(files, folder, team, number, *library, verdict->dump(1) + "\n");
      !added) {
    return tl::unexpected(added.error());
  }

  Submission done{(*verdict)["accepted"] == true, number, "", *verdict};
  const std::string entry = team + ": entry " + std::to_string(number);
  if (!done.is_accepted) {
    done.message = entry + " was not accepted: " + verdict->value("reason", "") +
                   (before > 0 ? "; entry " + std::to_string(before) + " plays on" : "");
    return done;
  }
  done.message = entry + " was accepted";
  if (!store->state().find_team(team)) {
    if (auto added = add_team(files, folder, store->state().file, team); !added)
      return tl::unexpected(added.error());
  }
  if (!store->state().is_started) return done;
  if (auto written = store->write(
          EntryBooked{.team = team, .entry = number, .sha256 = system::sha256(*library)});
      !written) {
    return tl::unexpected(written.error());
  }
  return done;
}

}  // namespace mirocup::league
