// SPDX-License-Identifier: MIT
#include "tournaments/handin/book.hpp"

#include "record/json_reader.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>

namespace mirocup::league {

namespace {

using record::JsonReader;

constexpr std::string_view taken = "hand_in";
constexpr std::string_view answered = "answer";
constexpr std::string_view pinned = "pin";
constexpr std::int64_t latest_time = std::int64_t{1} << 40;  // s

std::string lock_path(const Folder& folder) {
  return folder.path + "/.handing-in";
}

}  // namespace

Result<HandInBook> HandInBook::open(system::Files& files, const Folder& folder,
                                    std::string* notice) {
  MIROCUP_TRY(auto lock, system::FileLock::try_acquire(lock_path(folder)));
  if (!lock) {
    return fail(Errc::unavailable,
                folder.path + ": another process takes hand-ins for this league already");
  }
  const std::string path = folder.hand_in_book();
  // Appending keeps the mode: only the host reads what teams are told.
  if (!files.exists(path)) {
    MIROCUP_TRY_VOID(files.write(path, "", system::Readers::owner));
  }
  MIROCUP_TRY(auto journal, Journal::open(files, path, notice));
  HandInBook book(files, folder, std::move(journal));
  book.lock_ = std::move(*lock);
  for (const Json& line : book.journal_.lines()) {
    MIROCUP_TRY_VOID(book.apply(line));
  }
  return book;
}

Result<void> HandInBook::apply(const Json& line) {
  std::optional<record::JsonProblem> problem;
  const JsonReader json(line, "", problem);
  const std::string kind = json.at("kind").text();
  const std::string team = json.at("team").text();
  const int entry = json.at("entry").integer(kind == pinned ? 0 : 1, max_count);
  const std::int64_t at = json.at("at").integer<std::int64_t>(0, latest_time);
  if (!problem && !is_good_name(team)) json.at("team").complain("the name of a team is expected");
  const bool is_known = queue_.find(team, entry) != nullptr;
  if (kind == taken) {
    if (is_known) json.at("entry").complain("the team has an entry of that number already");
    WaitingHandIn handed{.team = team,
                         .entry = entry,
                         .file = json.at("file").text(),
                         .sha256 = json.at("sha256").text(),
                         .bytes = json.at("bytes").integer<std::uint64_t>(),
                         .at = at};
    if (!problem) queue_.add(std::move(handed));
  } else if (kind == answered) {
    if (!is_known) json.at("entry").complain("no entry of that number was handed in");
    const auto state = json.at("state").name<HandInState>();
    if (!is_final(state)) json.at("state").complain("accepted, refused or void is expected");
    const std::string message = json.at("message").text();
    if (!problem) queue_.answer(team, entry, state, message);
  } else if (kind == pinned) {
    if (!problem) {
      pins_[team] = entry;
      pin_times_[team].push_back(at);
    }
  } else {
    json.at("kind").complain("no kind of journal line is called " + json.at("kind").quoted());
  }
  if (!problem) return {};
  return tl::unexpected(record::error_of(
      *problem, journal_.path() + ": line " + record::json_text(line["n"]), Errc::damaged));
}

Result<int> HandInBook::take(WaitingHandIn handed,
                             const std::function<Result<void>(const std::string& path)>& store) {
  using system::Readers;
  const std::string& team = handed.team;
  {
    // `league submit` numbers entries, too.
    MIROCUP_TRY(const auto lock, system::FileLock::acquire(folder_.submitting()));
    MIROCUP_TRY(const auto next, next_entry(*files_, folder_, team));
    handed.entry = std::max(next, queue_.last_entry(team) + 1);
    MIROCUP_TRY_VOID(make_entries_folder(*files_, folder_, team).and_then([&] {
      return files_->make_folder(folder_.entry(team, handed.entry), Readers::owner);
    }));
  }
  const Json line{{"team", team},          {"entry", handed.entry},
                  {"file", handed.file},   {"sha256", handed.sha256},
                  {"bytes", handed.bytes}, {"at", handed.at}};
  const bool is_source = source_kind_of(handed.file) != SourceKind::none;
  const std::string path =
      is_source ? folder_.source(team, handed.entry) : folder_.library(team, handed.entry);
  auto done = store(path).and_then([&] { return journal_.append(std::string(taken), line); });
  if (!done) {
    (void)files_->remove(folder_.entry(team, handed.entry));
    return tl::unexpected(done.error());
  }
  const int entry = handed.entry;
  queue_.add(std::move(handed));
  return entry;
}

Result<void> HandInBook::answer(const std::string& team, int entry, HandInState state,
                                const std::string& message, std::int64_t at) {
  auto written = journal_.append(std::string(answered), {{"team", team},
                                                         {"entry", entry},
                                                         {"state", to_string(state)},
                                                         {"message", message},
                                                         {"at", at}});
  if (!written) return written;
  queue_.answer(team, entry, state, message);
  return {};
}

Result<void> HandInBook::pin(const std::string& team, int entry, std::int64_t at) {
  auto written =
      journal_.append(std::string(pinned), {{"team", team}, {"entry", entry}, {"at", at}});
  if (!written) return written;
  pins_[team] = entry;
  pin_times_[team].push_back(at);
  return {};
}

int HandInBook::pins_in_last_hour(const std::string& team, std::int64_t now) const {
  constexpr std::int64_t hour = 3600;  // s
  const auto times = pin_times_.find(team);
  if (times == pin_times_.end()) return 0;
  return static_cast<int>(
      std::count_if(times->second.begin(), times->second.end(),
                    [now](std::int64_t at) { return std::abs(now - at) < hour; }));
}

}  // namespace mirocup::league
