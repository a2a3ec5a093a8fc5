// SPDX-License-Identifier: MIT
#include "tournaments/handin/book.hpp"

#include "record/json_reader.hpp"

#include <algorithm>
#include <cstdlib>

namespace mirocup::league {

namespace {

using record::JsonReader;

constexpr std::string_view taken = "hand_in";
constexpr std::string_view answered = "answer";
constexpr std::string_view pinned = "pin";
constexpr std::string_view asked_line = "friendly";
constexpr std::string_view ended_line = "ended";
constexpr std::int64_t latest_time = std::int64_t{1} << 40;  // s

std::string lock_path(const Folder& folder) {
  return folder.path + "/.handing-in";
}

// Appending keeps the mode: only the host reads what teams have tried and are told.
Result<Journal> open_private(system::Files& files, const std::string& path, std::string* notice) {
  if (!files.exists(path)) {
    MIROCUP_TRY_VOID(files.write(path, "", system::Readers::owner));
  }
  return Journal::open(files, path, notice);
}

// Returns the error of a line with a problem.
Result<void> accepted(const std::optional<record::JsonProblem>& problem, const Journal& journal,
                      const Json& line) {
  if (!problem) return {};
  return tl::unexpected(record::error_of(
      *problem, journal.path() + ": line " + record::json_text(line["n"]), Errc::damaged));
}

}  // namespace

Result<HandInBook> HandInBook::open(system::Files& files, const Folder& folder,
                                    std::string* notice) {
  MIROCUP_TRY(auto lock, system::FileLock::try_acquire(lock_path(folder)));
  if (!lock) {
    return fail(Errc::unavailable,
                folder.path + ": another process takes hand-ins for this league already");
  }
  MIROCUP_TRY(auto journal, open_private(files, folder.hand_in_book(), notice));
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
    int plays = 0;
    json.read_if_present("plays", plays);
    if (!problem) queue_.answer(team, entry, state, message, plays);
  } else if (kind == pinned) {
    if (!problem) {
      pins_[team] = entry;
      pin_times_[team].push_back(at);
    }
  } else {
    json.at("kind").complain("no kind of journal line is called " + json.at("kind").quoted());
  }
  return accepted(problem, journal_, line);
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
                                const std::string& message, std::int64_t at, int plays) {
  MIROCUP_TRY_VOID(journal_.append(std::string(answered), {{"team", team},
                                                           {"entry", entry},
                                                           {"state", to_string(state)},
                                                           {"message", message},
                                                           {"plays", plays},
                                                           {"at", at}}));
  queue_.answer(team, entry, state, message, plays);
  return {};
}

Result<void> HandInBook::pin(const std::string& team, int entry, std::int64_t at) {
  MIROCUP_TRY_VOID(
      journal_.append(std::string(pinned), {{"team", team}, {"entry", entry}, {"at", at}}));
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

Result<FriendlyBook> FriendlyBook::open(system::Files& files, const Folder& folder,
                                        std::string* notice) {
  MIROCUP_TRY(auto journal, open_private(files, folder.friendly_book(), notice));
  FriendlyBook book(std::move(journal));
  for (const Json& line : book.journal_.lines()) {
    MIROCUP_TRY_VOID(book.apply(line));
  }
  return book;
}

Result<void> FriendlyBook::apply(const Json& line) {
  std::optional<record::JsonProblem> problem;
  const JsonReader json(line, "", problem);
  const std::string kind = json.at("kind").text();
  const std::string team = json.at("team").text();
  const int number = json.at("number").integer(1, max_count);
  const std::int64_t at = json.at("at").integer<std::int64_t>(0, latest_time);
  if (!problem && !is_good_name(team)) json.at("team").complain("the name of a team is expected");
  if (kind == asked_line) {
    Friendly friendly{.team = team,
                      .number = number,
                      .entry = json.at("entry").integer(1, max_count),
                      .opponent = json.at("opponent").text(),
                      .opponent_entry = json.at("opponent_entry").integer(0, max_count),
                      .is_burst = json.at("burst").boolean(),
                      .at = at};
    if (number != friendlies_.last_number(team) + 1)
      json.at("number").complain("the team's next number is expected");
    if (!problem) friendlies_.add(std::move(friendly));
  } else if (kind == ended_line) {
    const auto state = json.at("state").name<FriendlyState>();
    const int goals = json.at("goals").integer(0, max_count);
    const int against = json.at("against").integer(0, max_count);
    const std::string end = json.at("end").text();
    if (friendlies_.find(team, number) == nullptr)
      json.at("number").complain("the team has no friendly of that number");
    if (!problem) friendlies_.finish(team, number, state, goals, against, end);
  } else {
    json.at("kind").complain("no kind of journal line is called " + json.at("kind").quoted());
  }
  return accepted(problem, journal_, line);
}

Result<int> FriendlyBook::add(Friendly friendly) {
  friendly.number = friendlies_.last_number(friendly.team) + 1;
  MIROCUP_TRY_VOID(
      journal_.append(std::string(asked_line), {{"team", friendly.team},
                                                {"number", friendly.number},
                                                {"entry", friendly.entry},
                                                {"opponent", friendly.opponent},
                                                {"opponent_entry", friendly.opponent_entry},
                                                {"burst", friendly.is_burst},
                                                {"at", friendly.at}}));
  const int number = friendly.number;
  friendlies_.add(std::move(friendly));
  return number;
}

Result<void> FriendlyBook::finish(const std::string& team, int number, FriendlyState state,
                                  int goals, int against, const std::string& end, std::int64_t at) {
  MIROCUP_TRY_VOID(journal_.append(std::string(ended_line), {{"team", team},
                                                             {"number", number},
                                                             {"state", to_string(state)},
                                                             {"goals", goals},
                                                             {"against", against},
                                                             {"end", end},
                                                             {"at", at}}));
  friendlies_.finish(team, number, state, goals, against, end);
  return {};
}

}  // namespace mirocup::league
