// SPDX-License-Identifier: MIT
#include "tournaments/handin/friendly_book.hpp"

#include "record/json_reader.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

namespace {

constexpr std::string_view asked_line = "friendly";
constexpr std::string_view ended_line = "ended";
constexpr std::int64_t last_time = std::int64_t{1} << 40;  // s

}  // namespace

Result<FriendlyBook> FriendlyBook::open(system::Files& files, const Folder& folder,
                                        std::string* notice) {
  const std::string path = folder.friendly_book();
  // Appending keeps the mode: only the host reads what a team has tried.
  if (!files.exists(path)) {
    MIROCUP_TRY_VOID(files.write(path, "", system::Readers::owner));
  }
  MIROCUP_TRY(auto journal, Journal::open(files, path, notice));
  FriendlyBook book(std::move(journal));
  for (const Json& line : book.journal_.lines()) {
    MIROCUP_TRY_VOID(book.apply(line));
  }
  return book;
}

Result<void> FriendlyBook::apply(const Json& line) {
  std::optional<record::JsonProblem> problem;
  const record::JsonReader json(line, "", problem);
  const std::string kind = json.at("kind").text();
  const std::string team = json.at("team").text();
  const int number = json.at("number").integer(1, max_count);
  const std::int64_t at = json.at("at").integer<std::int64_t>(0, last_time);
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
  if (!problem) return {};
  return tl::unexpected(record::error_of(
      *problem, journal_.path() + ": line " + record::json_text(line["n"]), Errc::damaged));
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
  auto written = journal_.append(std::string(ended_line), {{"team", team},
                                                           {"number", number},
                                                           {"state", to_string(state)},
                                                           {"goals", goals},
                                                           {"against", against},
                                                           {"end", end},
                                                           {"at", at}});
  if (!written) return written;
  friendlies_.finish(team, number, state, goals, against, end);
  return {};
}

}  // namespace mirocup::league
