// SPDX-License-Identifier: MIT
#include "tournaments/handin/friendly_desk.hpp"

#include "record/answer.hpp"
#include "record/json_reader.hpp"
#include "record/match_record.hpp"
#include "record/thoughts_file.hpp"
#include "tournaments/handin/replies.hpp"

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

// How a leg ended, from its record; the team is blue.
FriendlyEnded read_end(const record::JsonReader& json) {
  const record::JsonReader result = json.at("result");
  FriendlyEnded read;
  read.state = FriendlyState::played;
  read.goals = result.at("score").at("blue").integer(0, max_count);
  read.against = result.at("score").at("yellow").integer(0, max_count);
  read.end = result.at("end").text();
  if (const record::JsonReader fault = result.at("fault"); !fault.is_null()) {
    read.end += ": " + fault.at("team").text() + ": " + fault.at("code").text() + ": " +
                fault.at("text").text();
  }
  return read;
}

}  // namespace

Result<void> FriendlyDesk::entry_accepted(const std::string& team, int entry) {
  const Friendlies& known = state_.book.friendlies();
  if (entry == 0 || known.has_burst(team, entry)) return {};
  Burst burst{.team = team, .entry = entry, .at = state_.options.now()};
  if (const auto before = known.bursts().find(team); before != known.bursts().end())
    burst.legs.assign(legs_against_former, {team, before->second});
  for (const std::string& house : state_.options.house) burst.legs.push_back({"house:" + house});
  const auto neighbours = state_.league.neighbours_of(team);
  const auto teams = neighbours.empty() ? std::map<std::string, int>() : entries_that_play();
  for (const std::string& neighbour : neighbours) {
    const auto found = teams.find(neighbour);
    if (found != teams.end() && neighbour != team) burst.legs.push_back({neighbour, found->second});
  }
  MIROCUP_TRY_VOID(state_.book.write(burst));
  forget_old_records(team);
  return {};
}

// Requires the mutex of the state.
std::map<std::string, int> FriendlyDesk::entries_that_play() {
  auto teams = state_.league.booked_entries();
  for (auto& [team, entry] : teams) {
    if (entry == 0) entry = state_.book.hand_ins().playing(team);
  }
  std::erase_if(teams, [](const auto& one) { return one.second == 0; });
  return teams;
}

web::Reply FriendlyDesk::ask(const std::string& team, const std::string& opponent) {
  const std::lock_guard lock(state_.mutex);
  const std::int64_t now = state_.options.now();
  const Friendlies& known = state_.book.friendlies();
  Friendly leg{.team = team,
               .number = known.last_number(team) + 1,
               .entry = state_.book.hand_ins().playing(team),
               .opponent = opponent,
               .at = now};
  if (leg.entry == 0) return problem_reply(403, team + " has no accepted entry to play with");
  if (is_house(opponent)) {
    const auto& house = state_.options.house;
    const std::string name = opponent.substr(opponent.find(':') + 1);
    if (std::ranges::find(house, name) == house.end())
      return problem_reply(404, "no house team has this name");
  } else {
    const auto teams = entries_that_play();
    const auto found = teams.find(opponent);
    if (found == teams.end() || opponent == team)
      return problem_reply(404, "no other team with an accepted entry has this name");
    leg.opponent_entry = found->second;
  }
  if (known.asked_in_last_hour(team, now) >= Friendlies::per_hour) {
    return problem_reply(429, team + " has asked for " + std::to_string(Friendlies::per_hour) +
                                  " friendlies in the last hour; ask later");
  }
  if (const auto written = state_.book.write(leg); !written) return host_failed(written.error());
  forget_old_records(team);
  return json_reply(202, {{"friendly", leg.number}});
}

// Requires the mutex of the state.
void FriendlyDesk::forget_old_records(const std::string& team) {
  const int last = state_.book.friendlies().last_number(team);
  for (int number = last - Friendlies::kept; number > 0; --number) {
    const std::string record = state_.folder.friendly(team, number);
    if (!state_.files.exists(record)) break;
    for (const std::string& path :
         {record, record::replay_path_of(record), record + ".blue.log", record + ".yellow.log",
          record::thoughts_path(record, Team::blue), record::thoughts_path(record, Team::yellow)}) {
      (void)state_.files.remove(path);
    }
  }
}

std::vector<std::string> FriendlyDesk::opponents(const std::string& team) {
  std::vector<std::string> names;
  {
    const std::lock_guard lock(state_.mutex);
    for (const auto& [name, entry] : entries_that_play()) {
      if (name != team) names.push_back(name);
    }
  }
  for (const std::string& house : state_.options.house) names.push_back("house:" + house);
  return names;
}

Json FriendlyDesk::json_of(const Friendly& one, const std::string& viewer, LegCosts& costs) const {
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
  const std::string record = state_.folder.friendly(one.team, one.number);
  if (!is_played || !state_.files.exists(record)) return json;
  const std::string path = "/" + one.team + "/" + std::to_string(one.number);
  json["replay"] = "/hand-in/friendlies" + path + "/replay";
  const bool has_log = state_.files.exists(log_path(state_.folder, leg_of(one, viewer)));
  json["log"] = has_log ? Json("/api/v1/friendlies" + path + "/log") : Json();
  json.update(costs.of(leg_of(one, viewer)));
  return json;
}

Json FriendlyDesk::list(const std::string& team, LegCosts& costs) {
  std::vector<Friendly> shown;
  {
    const std::lock_guard lock(state_.mutex);
    for (const Friendly* one : state_.book.friendlies().of_team(team)) {
      if (static_cast<int>(shown.size()) >= Friendlies::kept) break;
      shown.push_back(*one);
    }
  }
  Json list = Json::array();
  for (const Friendly& one : shown) list.push_back(json_of(one, team, costs));
  return list;
}

web::Reply FriendlyDesk::show(const std::string& visitor, const std::string& team,
                              std::string_view number, std::string_view what,
                              const std::string& root) {
  std::optional<Friendly> known;
  {
    const std::lock_guard lock(state_.mutex);
    const Friendly* found = state_.book.friendlies().find(team, number_of(number).value_or(0));
    if (found != nullptr) known = *found;
  }
  const bool may_see =
      known && (known->team == visitor || (known->opponent == visitor && !known->is_burst));
  const std::string record = may_see ? state_.folder.friendly(team, known->number) : "";
  if (!may_see || known->state != FriendlyState::played || !state_.files.exists(record) ||
      (what != "log" && what != "replay"))
    return problem_reply(404, visitor + " has played no friendly of this name");
  const OwnLeg leg = leg_of(*known, visitor);
  return what == "log" ? log_reply(state_.files, log_path(state_.folder, leg))
                       : replay_reply(state_.league.replay_of(record, own_side(leg), root));
}

std::optional<Friendly> FriendlyDesk::begin_next() {
  const std::lock_guard lock(state_.mutex);
  const Friendly* next = state_.book.friendlies().next();
  if (next == nullptr) return next_drills();
  Friendly begun = *next;
  if (!state_.files.make_folder(state_.folder.friendlies(begun.team), system::Readers::owner))
    return std::nullopt;
  state_.book.friendlies().begin(begun.team, begun.number);
  return begun;
}

// Requires the mutex of the state. Drills that fail are tried again by the next server.
std::optional<Friendly> FriendlyDesk::next_drills() {
  if (!state_.league.has_drills()) return std::nullopt;
  for (const auto& [team, entry] : state_.book.friendlies().bursts()) {
    const bool is_new = drills_begun_.emplace(team, entry).second;
    if (is_new && !state_.files.exists(state_.folder.drill_marks(team, entry)))
      return Friendly{.team = team, .entry = entry, .opponent = "drills"};
  }
  return std::nullopt;
}

Json FriendlyDesk::drills_of(const std::string& team, int entry) const {
  const auto text = state_.files.read(state_.folder.drill_marks(team, entry),
                                      {.max_size = system::size_limit::note});
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

Result<void> FriendlyDesk::played(const Friendly& friendly) {
  if (friendly.number == 0) {
    const std::string marks = state_.folder.drill_marks(friendly.team, friendly.entry);
    MIROCUP_TRY(const auto answer, record::last_answer(state_.files, marks + ".answer"));
    for (const char* end : {".answer", ".out"}) (void)state_.files.remove(marks + end);
    return state_.files.write(marks, record::json_text(answer) + "\n");
  }
  const std::string path = state_.folder.friendly(friendly.team, friendly.number);
  const auto text = state_.files.read(path, {.max_size = system::size_limit::record});
  if (!text) return failed(friendly);
  auto end = record::read_json<FriendlyEnded>(*text, path, Errc::damaged, read_end);
  if (!end) return failed(friendly);
  (void)state_.files.remove(path + ".out");
  const std::lock_guard lock(state_.mutex);
  end->team = friendly.team;
  end->number = friendly.number;
  end->at = state_.options.now();
  return state_.book.write(*end);
}

Result<void> FriendlyDesk::failed(const Friendly& friendly, bool is_spoiled) {
  const std::lock_guard lock(state_.mutex);
  if (friendly.number == 0) {
    if (!is_spoiled) drills_begun_.erase({friendly.team, friendly.entry});
    return {};
  }
  state_.book.friendlies().wait_again(friendly.team, friendly.number, is_spoiled);
  const Friendly* known = state_.book.friendlies().find(friendly.team, friendly.number);
  if (known == nullptr || known->failures < most_failures) return {};
  return state_.book.write(FriendlyEnded{.team = friendly.team,
                                         .number = friendly.number,
                                         .end = "it could not be played here",
                                         .at = state_.options.now()});
}

}  // namespace mirocup::league
