// SPDX-License-Identifier: MIT
#include "tournaments/league/league_store.hpp"

#include "system/digest.hpp"
#include "system/file_lock.hpp"
#include "tournaments/league/apply.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

Result<LeagueStore> LeagueStore::open(system::Files& files, Folder folder, std::string* notice) {
  if (!files.exists(folder.config())) {
    return fail(Errc::input, folder.path + " is not a league: there is no league.json in it");
  }
  const auto text = files.read(folder.config(), {.max_size = system::size_limit::league_file,
                                                 .links = system::Links::followed});
  if (!text) return tl::unexpected(text.error());
  auto file = parse_league_file(*text, folder.config());
  if (!file) return tl::unexpected(file.error());
  auto journal = Journal::open(files, folder.journal(), notice);
  if (!journal) return tl::unexpected(journal.error());
  // Checked first: teams of the journal may be missing in a changed file, which would look like
  // damage.
  if (!journal->lines().empty()) {
    const auto first = read_event(journal->lines().front());
    const Started* started = first ? std::get_if<Started>(&*first) : nullptr;
    if (started != nullptr && started->config_sha256 != system::sha256(*text)) {
      return fail(Errc::input, folder.config() + " was changed after the league started");
    }
  }
  auto state = state_from_journal(std::move(*file), *journal);
  if (!state) return tl::unexpected(state.error());
  LeagueStore store(std::move(folder), std::move(*journal), std::move(*state));
  store.applied_ = store.journal_.lines().size();
  return store;
}

Result<void> LeagueStore::refresh() {
  if (auto read = journal_.refresh(); !read) return read;
  for (; applied_ < journal_.lines().size(); ++applied_) {
    const Json& line = journal_.lines()[applied_];
    if (auto applied = apply_line(state_, line, journal_.path()); !applied) return applied;
  }
  return {};
}

Result<void> LeagueStore::write(const Event& event) {
  const auto lock = system::FileLock::acquire(folder_.lock());
  if (!lock) return tl::unexpected(lock.error());
  if (auto fresh = refresh(); !fresh) return fresh;
  if (auto valid = validate(state_, event); !valid) return valid;
  const std::string kind(kind_of(event));
  if (auto written = journal_.append(kind, fields_of(event)); !written) return written;
  apply(state_, event);
  applied_ = journal_.lines().size();
  return {};
}

}  // namespace mirocup::league
