// SPDX-License-Identifier: MIT
#include "tournaments/league/gaps.hpp"

#include "record/match_record.hpp"
#include "system/file_lock.hpp"
#include "system/number_of.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <filesystem>

namespace mirocup::league {

namespace {

namespace fs = std::filesystem;

// True if a regular file has this name, or if this user may not look at it.
bool is_file(const std::string& path) {
  std::error_code failed;
  const fs::file_type type = fs::symlink_status(path, failed).type();
  return type == fs::file_type::regular || type == fs::file_type::none;
}

// Takes the number behind the last '-' off a name; returns 0 if there is none.
int cut_number(std::string& name) {
  const std::size_t at = std::min(name.rfind('-'), name.size());
  const int number = system::number_of<int>(name.substr(std::min(at + 1, name.size()))).value_or(0);
  name.resize(at);
  return number;
}

// Compares records with the schedule. In a format that takes entries, lines of the journal make the
// fixtures. In other formats, a result that was taken back may have made a fixture for a time.
void look_at_records(const std::vector<std::string>& names, const LeagueState& state,
                     std::vector<std::string>& lost, std::vector<std::string>& not_booked) {
  const bool lines_make_fixtures = !state.is_started || state.file.format.is_open_ended();
  for (const std::string& name : names) {
    if (name.starts_with('.') || !name.ends_with(".json")) continue;
    std::string id = name.substr(0, name.size() - 5);
    const int version = cut_number(id);
    const int leg = cut_number(id);
    if (version < 1 || leg < 1 || leg > max_legs) continue;
    const auto index = state.is_started ? state.find_fixture(id) : std::nullopt;
    const FixtureState* f = index ? &state.fixtures[static_cast<std::size_t>(*index)] : nullptr;
    const auto was_voided = [&](const Decision& d) {
      const auto* voided = std::get_if<LegVoided>(&d.event);
      return voided != nullptr && d.undone_by && voided->fixture == id && voided->leg == leg;
    };
    const int last = f == nullptr ? 0 : f->legs[leg - 1].version;
    if (f == nullptr ? lines_make_fixtures
                     : version > last + std::ranges::count_if(state.decisions, was_voided)) {
      lost.push_back("records/" + name);
    } else if (f == nullptr ||
               (version == last && leg <= f->needed() && !f->legs[leg - 1].played)) {
      not_booked.push_back("records/" + name);
    }
  }
}

}  // namespace

std::string listed(std::vector<std::string> names) {
  constexpr std::size_t most = 5;
  const std::size_t all = names.size();
  names.resize(std::min(all, most));
  return system::joined(names, ", ") +
         (all > most ? " and " + std::to_string(all - most) + " more" : "");
}

std::vector<std::string> named_files(const LeagueState& state) {
  std::vector<std::string> names;
  for (const FixtureState& f : state.fixtures) {
    for (const LegState& leg : f.legs) {
      if (!leg.played || leg.played->record.empty()) continue;
      names.push_back(leg.played->record);
      names.push_back(record::replay_path_of(leg.played->record));
    }
  }
  for (std::size_t i = 0; i < state.teams.size(); ++i) {
    if (const int entry = state.teams[i].entry; entry > 0)
      names.push_back(Folder{""}.library(state.file.teams[i].name, entry).substr(1));
  }
  return names;
}

bool is_being_played(const Folder& folder) {
  return system::FileLock::signal_holder(folder.running(), {}).value_or(true);
}

Result<Gaps> gaps(system::Files& files, const LeagueStore& store, bool is_being_played) {
  const std::string& path = store.folder().path;
  Gaps gaps;
  if (const auto known = store.journal().known_lines(); !known) gaps.lost = known.error().what;
  for (const std::string& name : named_files(store.state())) {
    if (!is_file(path + "/" + name)) gaps.missing.push_back(name);
  }
  if (is_being_played) return gaps;
  std::vector<std::string> lost;  // nights and records of lost lines
  // Only the host may look at the nights.
  const auto nights = files.names_if_there(store.folder().nights());
  for (const std::string& name : nights.value_or(std::vector<std::string>{})) {
    std::error_code failed;
    const bool is_night = fs::symlink_status(store.folder().nights() + "/" + name, failed).type() ==
                          fs::file_type::directory;
    const int number = system::number_of<int>(name).value_or(0);
    if (is_night && number > static_cast<int>(store.state().nights.size()))
      lost.push_back("nights/" + name);
  }
  MIROCUP_TRY(const auto records, files.names_if_there(path + "/records"));
  look_at_records(records, store.state(), lost, gaps.not_booked);
  gaps.not_booked.insert(gaps.not_booked.begin(), lost.begin(), lost.end());
  if (gaps.lost.empty() && !lost.empty())
    gaps.lost = store.journal().path() + ": the lines of " + listed(lost) + " are lost" +
                restore_journal +
                "; if no copy has these lines, move these files out of the league's folder";
  return gaps;
}

std::vector<std::string> Gaps::in_words() const {
  std::vector<std::string> sentences;
  if (!lost.empty()) sentences.push_back(lost);
  if (lost.empty() && !not_booked.empty())
    sentences.push_back("the journal does not have the legs of " + listed(not_booked) +
                        ": the next start of the league enters them");
  if (!missing.empty())
    sentences.push_back("the journal names " + listed(missing) +
                        ", missing or no regular files: put them back from the last copy that "
                        "league backup made");
  return sentences;
}

}  // namespace mirocup::league
