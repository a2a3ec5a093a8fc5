// SPDX-License-Identifier: MIT
#include "tournaments/league/league_store.hpp"

#include "system/digest.hpp"
#include "system/file_lock.hpp"
#include "tournaments/league/apply.hpp"
#include "tournaments/league/people.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

LeagueStore::LeagueStore(Folder folder, Journal journal, LeagueState state)
    : folder_(std::move(folder)),
      journal_(std::move(journal)),
      state_(std::move(state)),
      applied_(journal_.lines().size()) {}

Result<LeagueStore> LeagueStore::open(system::Files& files, Folder folder, std::string* notice) {
  auto store = open_unplanned(files, std::move(folder), notice);
  if (store) plan(store->state_);
  return store;
}

Result<LeagueStore> LeagueStore::open_unplanned(system::Files& files, Folder folder,
                                                std::string* notice) {
  MIROCUP_TRY_VOID(expect_league(files, folder));
  MIROCUP_TRY(const auto text, files.read_named(folder.config(), system::size_limit::league_file));
  MIROCUP_TRY(auto file, parse_league_file(text, folder.config()));
  folder = Folder(folder.path, file.site);
  MIROCUP_TRY(auto journal, Journal::open(files, folder.journal(), notice, Journal::max_values,
                                          folder.journal_head()));
  // Checked first: teams of the journal may be missing in a changed file, which would look like
  // damage.
  if (!journal.lines().empty()) {
    const auto first = read_event(journal.lines().front());
    const Started* started = first ? std::get_if<Started>(&*first) : nullptr;
    if (started != nullptr && started->config_sha256 != system::sha256(without_site(text))) {
      return fail(Errc::input, folder.config() + " was changed after the league started");
    }
  }
  MIROCUP_TRY(auto state, state_from_journal(std::move(file), journal));
  MIROCUP_TRY(const auto people, read_people(files, folder));
  state.shown_names = shown_names(state.file, people);
  MIROCUP_TRY(state.pruned_nights, read_pruned_nights(files, folder));
  MIROCUP_TRY(state.notice, read_notice(files, folder));
  return LeagueStore(std::move(folder), std::move(journal), std::move(state));
}

Result<void> LeagueStore::refresh() {
  if (auto read = journal_.refresh(); !read) return read;
  const std::size_t lines = journal_.lines().size();
  if (undone_lines(journal_, lines) != undone_lines(journal_, applied_)) return rebuild();
  for (; applied_ < lines; ++applied_) {
    const Json& line = journal_.lines()[applied_];
    if (auto applied = apply_line(state_, line, journal_.path()); !applied) return applied;
  }
  return {};
}

Result<void> LeagueStore::write(const Event& event) {
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder_.lock()));
  if (auto fresh = refresh(); !fresh) return fresh;
  if (auto valid = validate(state_, event); !valid) return valid;
  if (const auto* undone = std::get_if<Undone>(&event)) {
    // The league without that decision must be one in which all that followed is possible.
    auto without = state_from_lines(state_.file, journal_, journal_.lines().size(), undone->line);
    if (!without) {
      return fail(Errc::input, "it cannot be undone, because a later line depends on it: " +
                                   without.error().what);
    }
    if (auto written = write_line(event); !written) return written;
    return rebuild();
  }
  if (auto written = write_line(event); !written) return written;
  apply(state_, event, static_cast<int>(journal_.lines().size()));
  applied_ = journal_.lines().size();
  return {};
}

// Every line has the time at which it was written.
Result<void> LeagueStore::write_line(const Event& event) {
  Json fields = fields_of(event);
  if (!fields.contains("at")) fields["at"] = utc_text(system::now_s());
  return journal_.append(std::string(kind_of(event)), std::move(fields));
}

Result<void> LeagueStore::rebuild() {
  MIROCUP_TRY(auto state, state_from_journal(state_.file, journal_));
  state.shown_names = std::move(state_.shown_names);
  state.pruned_nights = std::move(state_.pruned_nights);
  state.notice = std::move(state_.notice);
  state_ = std::move(state);
  applied_ = journal_.lines().size();
  return {};
}

}  // namespace mirocup::league
