// SPDX-License-Identifier: MIT
#include "tournaments/handin/friendly_desk.hpp"

#include "record/answer.hpp"
#include "record/json_reader.hpp"
#include "record/match_record.hpp"
#include "record/thoughts_file.hpp"
#include "system/printable.hpp"
#include "tournaments/handin/replies.hpp"
#include "tournaments/league/hand_ins.hpp"

#include <algorithm>

namespace mirocup::league {

namespace {

constexpr int legs_against_former = 10;  // of an accepted entry against the entry before it
constexpr int most_failures = 5;         // of the host, until a leg is void

// The leg as the team of that colour sees it, for LegCosts and log_path().
OwnLeg leg_of(const Friendly& friendly, const std::string& viewer) {
  OwnLeg leg;
  leg.record = Folder::friendly_name(friendly.team, friendly.number);
  leg.colour = viewer == friendly.team ? "blue" : "yellow";
  return leg;
}

// How a leg ended, from its record.
struct FriendlyEnd {
  int blue = 0;
  int yellow = 0;
  std::string end;
};

FriendlyEnd read_end(const record::JsonReader& json) {
  const record::JsonReader result = json.at("result");
  FriendlyEnd read;
  read.blue = result.at("score").at("blue").integer(0, max_count);
  read.yellow = result.at("score").at("yellow").integer(0, max_count);
  read.end = result.at("end").text();
  if (const record::JsonReader fault = result.at("fault"); !fault.is_null()) {
    read.end += ": " + fault.at("team").text() + ": " + fault.at("code").text() + ": " +
                fault.at("text").text();
  }
  return read;
}

}  // namespace

Result<std::unique_ptr<FriendlyDesk>> FriendlyDesk::open(system::Files& files, const Folder& folder,
                                                         FriendlyOptions options,
                                                         std::string* notice) {
  MIROCUP_TRY(auto book, FriendlyBook::open(files, folder, notice));
  return std::unique_ptr<FriendlyDesk>(
      new FriendlyDesk(files, folder, std::move(options), std::move(book)));
}

Result<void> FriendlyDesk::entry_accepted(const std::string& team, int entry, std::int64_t now) {
  const auto neighbours = options_.neighbours(team);
  const auto teams = neighbours.empty() ? std::map<std::string, int>() : options_.teams();
  const std::lock_guard lock(mutex_);
  if (book_.friendlies().has_burst(team, entry)) return {};
  for (const int number : book_.friendlies().waiting_of_older(team, entry)) {
    MIROCUP_TRY_VOID(
        book_.finish(team, number, FriendlyState::void_, 0, 0, "a later entry was accepted", now));
  }
  Friendly leg{.team = team, .entry = entry, .is_burst = true, .at = now};
  const auto before = book_.friendlies().bursts().find(team);
  const int former = before == book_.friendlies().bursts().end() ? 0 : before->second;
  for (int i = 0; former > 0 && i < legs_against_former; ++i) {
    leg.opponent = team;
    leg.opponent_entry = former;
    MIROCUP_TRY_VOID(book_.add(leg));
  }
  leg.opponent_entry = 0;
  for (const std::string& house : options_.house) {
    leg.opponent = "house:" + house;
    MIROCUP_TRY_VOID(book_.add(leg));
  }
  for (const std::string& neighbour : neighbours) {
    const auto known = teams.find(neighbour);
    if (known == teams.end() || neighbour == team) continue;
    leg.opponent = neighbour;
    leg.opponent_entry = known->second;
    MIROCUP_TRY_VOID(book_.add(leg));
  }
  forget_old_records(team);
  return {};
}

web::Reply FriendlyDesk::ask(const std::string& team, const std::string& opponent,
                             std::int64_t now) {
  const auto teams = options_.teams();
  const auto entry = playing_entry(files_, folder_, team);
  if (!entry) return host_failed(entry.error());
  if (*entry == 0) return problem_reply(403, team + " has no accepted entry to play with");
  Friendly leg{.team = team, .entry = *entry, .opponent = opponent, .at = now};
  if (is_house(opponent)) {
    const std::string name = opponent.substr(opponent.find(':') + 1);
    if (std::find(options_.house.begin(), options_.house.end(), name) == options_.house.end())
      return problem_reply(404, "no house team has this name");
  } else {
    const auto known = teams.find(opponent);
    if (known == teams.end() || opponent == team)
      return problem_reply(404, "no other team with an accepted entry has this name");
    leg.opponent_entry = known->second;
  }
  const std::lock_guard lock(mutex_);
  if (book_.friendlies().asked_in_last_hour(team, now) >= Friendlies::per_hour) {
    return problem_reply(429, team + " has asked for " + std::to_string(Friendlies::per_hour) +
                                  " friendlies in the last hour; ask later");
  }
  const auto number = book_.add(std::move(leg));
  if (!number) return host_failed(number.error());
  forget_old_records(team);
  return json_reply(202, {{"friendly", *number}});
}

// Requires mutex_.
void FriendlyDesk::forget_old_records(const std::string& team) {
  const int last = book_.friendlies().last_number(team);
  for (int number = last - Friendlies::kept; number > 0; --number) {
    const std::string record = folder_.friendly(team, number);
    if (!files_.exists(record)) break;
    for (const std::string& path :
         {record, record::replay_path_of(record), record + ".blue.log", record + ".yellow.log",
          record::thoughts_path(record, Team::blue), record::thoughts_path(record, Team::yellow)}) {
      (void)files_.remove(path);
    }
  }
}

std::vector<std::string> FriendlyDesk::opponents(const std::string& team) {
  std::vector<std::string> names;
  for (const auto& [name, entry] : options_.teams()) {
    if (name != team) names.push_back(name);
  }
  for (const std::string& house : options_.house) names.push_back("house:" + house);
  return names;
}

// Requires mutex_.
Json FriendlyDesk::json_of(const Friendly& one, const std::string& viewer, LegCosts& costs) {
  const bool is_own = one.team == viewer;
  const bool is_played = one.state == FriendlyState::played;
  Json json{{"team", one.team},
            {"number", one.number},
            {"burst", one.is_burst},
            {"opponent", is_own ? one.opponent : one.team},
            {"entry", is_own ? one.entry : one.opponent_entry},
            {"colour", is_own ? "blue" : "yellow"},
            {"asked", utc_text(one.at)},
            {"state", to_string(one.state)},
            {"goals", is_played ? Json(is_own ? one.goals : one.against) : Json()},
            {"against", is_played ? Json(is_own ? one.against : one.goals) : Json()},
            {"end", record::or_null(one.end)}};
  if (one.opponent == one.team) json["opponent_entry"] = one.opponent_entry;
  const std::string record = folder_.friendly(one.team, one.number);
  if (!is_played || !files_.exists(record)) return json;
  const std::string path = "/" + one.team + "/" + std::to_string(one.number);
  json["replay"] = "/hand-in/friendlies" + path + "/replay";
  const bool has_log = files_.exists(log_path(folder_, leg_of(one, viewer)));
  json["log"] = has_log ? Json("/api/v1/friendlies" + path + "/log") : Json();
  if (const auto cost = costs.of(leg_of(one, viewer))) {
    json["cpu_seconds"] = cost->cpu_seconds;
    json["bank_seconds"] = cost->bank_seconds;
    json["slowest_tick_ms"] = cost->slowest_tick_ms;
    json["late_ticks"] = cost->late_ticks;
    json["fouls"] = cost->fouls;
  }
  return json;
}

Json FriendlyDesk::list(const std::string& team, LegCosts& costs) {
  const std::lock_guard lock(mutex_);
  Json list = Json::array();
  for (const Friendly* one : book_.friendlies().of_team(team)) {
    if (static_cast<int>(list.size()) >= Friendlies::kept) break;
    list.push_back(json_of(*one, team, costs));
  }
  return list;
}

web::Reply FriendlyDesk::show(const std::string& visitor, std::string_view rest,
                              const std::string& root) {
  const auto nothing = [&] {
    return problem_reply(404, visitor + " has played no friendly of this name");
  };
  if (!rest.starts_with('/')) return nothing();
  rest.remove_prefix(1);
  const std::size_t first = std::min(rest.find('/'), rest.size());
  const std::size_t second = std::min(rest.find('/', first + 1), rest.size());
  if (second == rest.size()) return nothing();
  const std::string team(rest.substr(0, first));
  const auto number = number_of(rest.substr(first + 1, second - first - 1));
  const std::string_view what = rest.substr(second + 1);
  std::optional<Friendly> known;
  {
    const std::lock_guard lock(mutex_);
    const Friendly* found = number ? book_.friendlies().find(team, *number) : nullptr;
    if (found != nullptr) known = *found;
  }
  const bool may_see =
      known && (known->team == visitor || (known->opponent == visitor && !known->is_burst));
  if (!may_see || known->state != FriendlyState::played) return nothing();
  const std::string record = folder_.friendly(team, *number);
  if (!files_.exists(record)) return nothing();
  if (what == "log") {
    const std::string path = log_path(folder_, leg_of(*known, visitor));
    const auto log = files_.read_if_there(path, {.max_size = system::size_limit::log});
    if (!log) return host_failed(log.error());
    return {.status = 200, .bytes = system::printable(log->value_or(""), system::LineEnds::kept)};
  }
  if (what != "replay") return nothing();
  auto page = options_.replay(record, own_side(leg_of(*known, visitor)), root);
  if (!page) return problem_reply(503, "the replay cannot be made here");
  return {.status = 200, .type = "text/html; charset=utf-8", .bytes = std::move(*page)};
}

std::optional<Friendly> FriendlyDesk::begin_next() {
  const std::lock_guard lock(mutex_);
  const Friendly* next = book_.friendlies().next();
  if (next == nullptr) return next_drills();
  Friendly begun = *next;
  if (!files_.make_folder(folder_.friendlies(begun.team), system::Readers::owner))
    return std::nullopt;
  book_.begin(begun.team, begun.number);
  return begun;
}

// Requires mutex_. Drills that fail are tried again by the next server.
std::optional<Friendly> FriendlyDesk::next_drills() {
  if (!options_.has_drills) return std::nullopt;
  for (const auto& [team, entry] : book_.friendlies().bursts()) {
    const bool is_new = drills_begun_.emplace(team, entry).second;
    if (is_new && !files_.exists(folder_.drill_marks(team, entry)))
      return Friendly{.team = team, .entry = entry, .opponent = "drills"};
  }
  return std::nullopt;
}

Json FriendlyDesk::drills_of(const std::string& team, int entry) const {
  const auto text =
      files_.read(folder_.drill_marks(team, entry), {.max_size = system::size_limit::note});
  if (!text) return {};
  const auto marks =
      record::read_json<Json>(*text, "drills", Errc::damaged, [](const record::JsonReader& json) {
        Json read{{"score", json.at("score").as<double>()}, {"drills", Json::array()}};
        for (const record::JsonReader& one : json.at("drills").elements(0, max_count)) {
          read["drills"].push_back({{"name", one.at("name").text()},
                                    {"version", one.at("version").integer(0, max_count)},
                                    {"score", one.at("score").as<double>()}});
        }
        return read;
      });
  return marks.value_or(Json());
}

Result<void> FriendlyDesk::played(const Friendly& friendly, std::int64_t now) {
  if (friendly.number == 0) {
    const std::string marks = folder_.drill_marks(friendly.team, friendly.entry);
    MIROCUP_TRY(const auto answer, record::last_answer(files_, marks + ".answer"));
    for (const char* end : {".answer", ".out"}) (void)files_.remove(marks + end);
    return files_.write(marks, record::json_text(answer) + "\n");
  }
  const std::string path = folder_.friendly(friendly.team, friendly.number);
  const auto text = files_.read(path, {.max_size = system::size_limit::record});
  if (!text) return failed(friendly, now);
  const auto end = record::read_json<FriendlyEnd>(*text, path, Errc::damaged, read_end);
  if (!end) return failed(friendly, now);
  (void)files_.remove(path + ".out");
  const std::lock_guard lock(mutex_);
  return book_.finish(friendly.team, friendly.number, FriendlyState::played, end->blue, end->yellow,
                      end->end, now);
}

Result<void> FriendlyDesk::failed(const Friendly& friendly, std::int64_t now, bool is_spoiled) {
  const std::lock_guard lock(mutex_);
  if (friendly.number == 0) {
    if (!is_spoiled) drills_begun_.erase({friendly.team, friendly.entry});
    return {};
  }
  book_.wait_again(friendly.team, friendly.number, is_spoiled);
  const Friendly* known = book_.friendlies().find(friendly.team, friendly.number);
  if (known == nullptr || known->failures < most_failures) return {};
  return book_.finish(friendly.team, friendly.number, FriendlyState::void_, 0, 0,
                      "it could not be played here", now);
}

}  // namespace mirocup::league
