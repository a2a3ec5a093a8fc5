// SPDX-License-Identifier: MIT
#include "tournaments/handin/own_legs.hpp"

#include "record/json_reader.hpp"
#include "tournaments/publish/site_file.hpp"

#include <filesystem>

namespace mirocup::league {

namespace {

using record::JsonReader;

constexpr std::size_t max_decisions = 100'000;

OwnLeg seen_from(const SeenState& seen, const FixtureState& f, int leg, int team) {
  const PlayedLeg& played = *f.legs[leg - 1].played;
  const bool is_home = f.fixture.home == team;
  OwnLeg own;
  own.fixture = f.fixture.id();
  own.leg = leg;
  own.opponent = seen->name(is_home ? f.fixture.away : f.fixture.home);
  own.goals = is_home ? played.result.home_goals : played.result.away_goals;
  own.against = is_home ? played.result.away_goals : played.result.home_goals;
  own.result = played.result.both_lose    ? 'L'
               : played.winner == team    ? 'W'
               : played.winner == no_team ? 'D'
                                          : 'L';
  if (played.fault && played.fault->team == seen->name(team))
    own.own_fault = played.fault->code + ": " + played.fault->text;
  own.record = played.record;
  own.colour = Fixture::is_home_blue(leg) == is_home ? "blue" : "yellow";
  return own;
}

}  // namespace

std::vector<OwnLeg> own_legs(const SeenState& seen, const std::string& team) {
  std::vector<OwnLeg> legs;
  const auto index = seen->find_team(team);
  if (!index) return legs;
  for (const FixtureState& f : seen->fixtures) {
    if (f.fixture.home != *index && f.fixture.away != *index) continue;
    for (int leg = 1; leg <= max_legs; ++leg) {
      if (f.legs[leg - 1].played) legs.push_back(seen_from(seen, f, leg, *index));
    }
  }
  return legs;
}

Json LegCosts::of(const OwnLeg& leg) {
  if (leg.record.empty()) return Json::object();
  const std::string key = leg.record + " " + leg.colour;
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
  }
  const auto text =
      files_.read(folder_.path + "/" + leg.record, {.max_size = system::size_limit::record});
  if (!text) return Json::object();
  const auto cost =
      record::read_json<Json>(*text, leg.record, Errc::damaged, [&leg](const JsonReader& json) {
        const JsonReader budget = json.at("budget").at(leg.colour);
        Json read;
        for (const char* number : {"cpu_seconds", "bank_seconds", "slowest_tick_ms"})
          read[number] = budget.at(number).number();
        read["late_ticks"] = budget.at("late_ticks").integer<int>(0);
        int fouls = 0;
        for (const JsonReader& call : json.at("decisions").elements(0, max_decisions)) {
          const bool is_foul = !call.at("offender").is_null() && !call.at("restart").is_null();
          if (is_foul && call.at("offender").text() == leg.colour) ++fouls;
        }
        read["fouls"] = fouls;
        return read;
      });
  if (!cost) return Json::object();
  const std::lock_guard lock(mutex_);
  return known_[key] = *cost;
}

record::Whose own_side(const OwnLeg& leg) {
  return {leg.colour == "blue", leg.colour == "yellow"};
}

std::string log_path(const Folder& folder, const OwnLeg& leg) {
  return folder.path + "/" + leg.record + "." + leg.colour + ".log";
}

std::string name_of_leg(const OwnLeg& leg) {
  return std::filesystem::path(leg.record).stem();
}

nlohmann::ordered_json own_legs_json(system::Files& files, const Folder& folder,
                                     const std::vector<OwnLeg>& legs, LegCosts& costs) {
  Json list = Json::array();
  for (auto leg = legs.rbegin(); leg != legs.rend(); ++leg) {
    Json one{{"fixture", leg->fixture},
             {"leg", leg->leg},
             {"opponent", leg->opponent},
             {"colour", leg->colour},
             {"goals", leg->goals},
             {"against", leg->against},
             {"result", std::string(1, leg->result)},
             {"fault", leg->own_fault ? Json(*leg->own_fault) : Json()}};
    if (!leg->record.empty()) {
      one["record"] = "/" + leg->record;
      one["replay"] = "/" + replay_page_of(leg->record);
      one["log"] = files.exists(log_path(folder, *leg))
                       ? Json("/api/v1/legs/" + name_of_leg(*leg) + "/log")
                       : Json();
      if (record::has_thoughts(files, folder.path + "/" + leg->record, own_side(*leg)))
        one["thoughts"] = std::string(own_replays_path) + name_of_leg(*leg) + ".html";
    }
    one.update(costs.of(*leg));
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace mirocup::league
