// SPDX-License-Identifier: MIT
#include "tournaments/league/book.hpp"

#include "system/digest.hpp"
#include "system/file_lock.hpp"
#include "tournaments/journal/kinds.hpp"

namespace mirocup::league {

namespace {

constexpr std::int64_t latest_time = std::int64_t{1} << 40;  // s
constexpr std::size_t max_listed = 1000;                     // legs of a burst, dropped entries

// Whose line, and when it was written.
void list_origin(auto& f, auto& line) {
  f("team", line.team);
  f("at", line.at, 0, latest_time);
}

}  // namespace

static void list_fields(auto& f, HandedIn& line) {
  list_origin(f, line);
  f("entry", line.entry, 1, max_count);
  f("file", line.file);
  f("sha256", line.sha256);
  f("bytes", line.bytes);
  f("network", line.is_network);
  f.if_set("late", line.is_late);
}

static void list_fields(auto& f, Answered& line) {
  list_origin(f, line);
  f("entry", line.entry, 1, max_count);
  f("state", line.state);
  f("message", line.message);
  f("plays", line.plays, 0, max_count);
  f("library", line.library);
}

static void list_fields(auto& f, Rejected& line) {
  list_origin(f, line);
  f("message", line.message);
}

static void list_fields(auto& f, Dropped& line) {
  f("team", line.team);
  f("entries", line.entries, 0, max_listed);
}

static void list_fields(auto& f, TakenLate& line) {
  list_origin(f, line);
  f("entry", line.entry, 1, max_count);
}

static void list_fields(auto& f, Pinned& line) {
  list_origin(f, line);
  f("entry", line.entry, 0, max_count);
}

static void list_fields(auto& f, Friendly& line) {
  list_origin(f, line);
  f("number", line.number, 1, max_count);
  f("entry", line.entry, 1, max_count);
  f("opponent", line.opponent);
  f("opponent_entry", line.opponent_entry, 0, max_count);
}

static void list_fields(auto& f, Burst::Leg& leg) {
  f("opponent", leg.opponent);
  f("opponent_entry", leg.opponent_entry, 0, max_count);
}

static void list_fields(auto& f, Burst& line) {
  list_origin(f, line);
  f("entry", line.entry, 1, max_count);
  f("legs", line.legs, 0, max_listed);
}

static void list_fields(auto& f, FriendlyEnded& line) {
  list_origin(f, line);
  f("number", line.number, 1, max_count);
  f("state", line.state);
  f("goals", line.goals, 0, max_count);
  f("against", line.against, 0, max_count);
  f("end", line.end);
}

namespace {

// Returns why a line cannot follow the lines before it; "" if it can.
struct Objection {
  const HandIns& hand_ins;
  const Friendlies& friendlies;

  std::string operator()(const HandedIn& line) const {
    const bool is_known = hand_ins.find(line.team, line.entry) != nullptr;
    return is_known ? "/entry: the team has an entry of that number already" : "";
  }
  std::string operator()(const Answered& line) const {
    if (hand_ins.find(line.team, line.entry) == nullptr)
      return "/entry: no entry of that number was handed in";
    return is_final(line.state) ? "" : "/state: accepted, refused or void is expected";
  }
  std::string operator()(const Friendly& line) const {
    const bool is_next = line.number == friendlies.last_number(line.team) + 1;
    return is_next ? "" : "/number: the team's next number is expected";
  }
  std::string operator()(const FriendlyEnded& line) const {
    const bool is_known = friendlies.find(line.team, line.number) != nullptr;
    return is_known ? "" : "/number: the team has no friendly of that number";
  }
  std::string operator()(const auto&) const { return ""; }
};

}  // namespace

Result<Book> Book::open(system::Files& files, const Folder& folder, std::string* notice) {
  MIROCUP_TRY(auto journal, Journal::open(files, folder.hand_in_book(), notice));
  Book book(files, folder, std::move(journal));
  MIROCUP_TRY_VOID(book.refresh());
  return book;
}

Result<void> Book::refresh() {
  MIROCUP_TRY_VOID(journal_.refresh());
  for (const std::string where = journal_.path() + ": "; applied_ < journal_.lines().size();) {
    const Json& json = journal_.lines()[applied_];
    MIROCUP_TRY(const auto line, read_line<BookLine>(json, where));
    if (const std::string why = objection_to(line); !why.empty())
      return fail(Errc::damaged, where + name_of_line(json) + ": " + why);
    apply(line);
  }
  return {};
}

std::string Book::objection_to(const BookLine& line) const {
  const std::string& team =
      std::visit([](const auto& one) -> const std::string& { return one.team; }, line);
  return is_good_name(team) ? std::visit(Objection{hand_ins_, friendlies_}, line)
                            : "/team: the name of a team is expected";
}

void Book::apply(const BookLine& line) {
  std::visit(
      [this](const auto& one) {
        if constexpr (requires { hand_ins_.apply(one); }) {
          hand_ins_.apply(one);
        } else {
          friendlies_.apply(one);
        }
      },
      line);
  ++applied_;
}

Result<void> Book::append(const BookLine& line) {
  if (const std::string why = objection_to(line); !why.empty())
    return fail(Errc::input, journal_.path() + ": " + why);
  MIROCUP_TRY_VOID(journal_.append(std::string(line_kind(line)), line_fields(line)));
  apply(line);
  return {};
}

Result<void> Book::write(const BookLine& line) {
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(journal_.path()));
  MIROCUP_TRY_VOID(refresh());
  return append(line);
}

Result<int> Book::take(HandedIn handed, const Store& store) {
  MIROCUP_TRY(const auto lock, system::FileLock::acquire(journal_.path()));
  MIROCUP_TRY_VOID(refresh());
  const std::string& team = handed.team;
  const int number = handed.entry = hand_ins_.last_number(team) + 1;
  const std::string place = folder_.entry(team, number);
  const bool is_source = handed.is_network && source_kind_of(handed.file) != SourceKind::none;
  const auto taken =
      make_entries_folder(*files_, folder_, team)
          .and_then([&] { return files_->remove(place); })  // of a process that was killed
          .and_then([&] { return files_->make_folder(place, system::Readers::owner); })
          .and_then([&] {
            return store(is_source ? folder_.source(team, number) : folder_.library(team, number));
          })
          .and_then([&] { return append(handed); });
  if (taken) return number;
  (void)files_->remove(place);
  return tl::unexpected(taken.error());
}

Result<void> Book::give(const std::string& team, const std::string& library) {
  const std::string sha256 = system::sha256(library);
  MIROCUP_TRY(const int entry, take({.team = team, .sha256 = sha256, .bytes = library.size()},
                                    [&](const std::string& path) {
                                      return files_->write(path, library, system::Readers::owner);
                                    }));
  MIROCUP_TRY_VOID(write(
      Answered{.team = team, .entry = entry, .state = HandInState::accepted, .library = sha256}));
  return write_entry_file(*files_, folder_, team, entry, sha256);
}

}  // namespace mirocup::league
