// SPDX-License-Identifier: MIT
#include "tournaments/league/league_store.hpp"

#include "server/system/digest.hpp"
#include "tournaments/journal/file_lock.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

Result<LeagueStore> LeagueStore::open(system::Files& files, Folder folder, std::string* notice) {
  if (!files.exists(folder.config())) {
    return fail(Errc::input, folder.path + " is not a league: there is no league.json in it");
  }
  const auto text = files.read(folder.config());
  if (!text) return tl::unexpected(text.error());
  auto file = parse_league_file(*text, folder.config());
  if (!file) return tl::unexpected(file.error());
  auto journal = Journal::open(files, folder.journal(), notice);
  if (!journal) return tl::unexpected(journal.error());
  // The teams' names in the journal would not fit a file that was changed: say that first.
  if (!journal->lines().empty()) {
    const Json& first = journal->lines().front();
    if (first.value("kind", "") == "start" &&
        first.value("config_sha256", "") != system::sha256(*text)) {
      return fail(Errc::input, folder.config() + " was changed after the league started");
    }
  }
  auto state = league_state(std::move(*file), *journal);
  if (!state) return tl::unexpected(state.error());
  LeagueStore store(std::move(folder), std::move(*journal), std::move(*state));
  store.applied_ = store.journal_.lines().size();
  return store;
}

Result<void> LeagueStore::refresh() {
  if (auto read = journal_.refresh(); !read) return read;
  for (; applied_ < journal_.lines().size(); ++applied_) {
    const Json& line = journal_.lines()[applied_];
    if (const auto valid = validate(state_, line); !valid) {
      return fail(Errc::damaged, journal_.path() + ": line " + std::to_string(applied_ + 1) +
                                     " does not fit the league: " + valid.error().what);
    }
    apply(state_, line);
  }
  return {};
}

Result<void> LeagueStore::write(const std::string& kind, Json fields) {
  const auto lock = FileLock::acquire(folder_.lock());
  if (!lock) return tl::unexpected(lock.error());
  if (auto fresh = refresh(); !fresh) return fresh;
  Json line{{"kind", kind}};
  line.update(fields);
  if (auto valid = validate(state_, line); !valid) return valid;
  if (auto written = journal_.append(kind, std::move(fields)); !written) return written;
  apply(state_, journal_.lines().back());
  applied_ = journal_.lines().size();
  return {};
}

}  // namespace mirocup::league
