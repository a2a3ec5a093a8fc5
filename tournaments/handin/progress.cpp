// SPDX-License-Identifier: MIT
#include "tournaments/handin/progress.hpp"

#include "record/json_fields.hpp"
#include "system/text.hpp"
#include "tournaments/table/rating.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace mirocup::league {

namespace {

using Json = nlohmann::ordered_json;
using record::text_in;
using record::value_in;

constexpr std::string_view house = "house:";

struct HouseGoals {
  int legs = 0;
  int goals = 0;
  int against = 0;
};

struct EntryLegs {
  int legs = 0;
  std::map<std::string, HouseGoals> against;
  int fouls = 0;
  int known = 0;  // legs whose record tells of fouls and time
  double slowest_ms = 0.0;
};

// A leg against a house team, by the indices of entry and house team.
struct HouseLeg {
  int entry = 0;
  std::string house_team;
  int goals = 0;
  int against = 0;
};

std::vector<HouseLeg> house_legs(const Json& friendlies, std::map<int, EntryLegs>& entries) {
  std::vector<HouseLeg> legs;
  for (const Json& one : friendlies) {
    const std::string opponent = text_in(one, "opponent");
    if (!opponent.starts_with(house) || text_in(one, "state") != "played") continue;
    HouseLeg leg{.entry = value_in(one, "entry", 0),
                 .house_team = opponent.substr(house.size()),
                 .goals = value_in(one, "goals", 0),
                 .against = value_in(one, "against", 0)};
    EntryLegs& entry = entries[leg.entry];
    ++entry.legs;
    HouseGoals& met = entry.against[leg.house_team];
    ++met.legs;
    met.goals += leg.goals;
    met.against += leg.against;
    if (one.contains("fouls")) {
      ++entry.known;
      entry.fouls += value_in(one, "fouls", 0);
      entry.slowest_ms = std::max(entry.slowest_ms, value_in(one, "slowest_tick_ms", 0.0));
    }
    legs.push_back(std::move(leg));
  }
  return legs;
}

// Returns the strength of each entry above the mean of the house teams, in the order of entries.
std::vector<Strength> ratings_of(const std::vector<HouseLeg>& legs,
                                 const std::map<int, EntryLegs>& entries) {
  std::map<std::string, int> houses;
  std::map<int, int> index;
  for (const auto& entry : entries) index.emplace(entry.first, static_cast<int>(index.size()));
  const auto count = static_cast<int>(entries.size());
  std::vector<FixtureResults> fixtures;
  for (const HouseLeg& leg : legs) {
    const int other =
        houses.emplace(leg.house_team, count + static_cast<int>(houses.size())).first->second;
    fixtures.push_back({LegResult{.home = index.at(leg.entry),
                                  .away = other,
                                  .home_goals = leg.goals,
                                  .away_goals = leg.against}});
  }
  std::vector<Strength> all = rate(count + static_cast<int>(houses.size()), fixtures).strengths;
  double mean = 0.0;
  for (std::size_t i = entries.size(); i < all.size(); ++i) mean += all[i].value;
  mean /= static_cast<double>(std::max<std::size_t>(houses.size(), 1));
  all.resize(entries.size());
  for (Strength& one : all) one = {one.value - mean, one.low - mean, one.high - mean};
  return all;
}

// Returns what is said of an entry and the entry before it, by the legs in which they met; null if
// there are none.
Json against_former(const Json& friendlies, int entry) {
  FixtureResults legs;
  int former = 0;
  for (const Json& one : friendlies) {
    if (!one.contains("opponent_entry") || text_in(one, "state") != "played" ||
        value_in(one, "entry", 0) != entry)
      continue;
    former = value_in(one, "opponent_entry", 0);
    legs.push_back({.home = 0,
                    .away = 1,
                    .home_goals = value_in(one, "goals", 0),
                    .away_goals = value_in(one, "against", 0)});
  }
  if (legs.empty()) return {};
  // The mean of the two strengths is 0.
  const Strength half = rate(2, {legs}).strengths[0];
  return {{"entry", former},
          {"legs", legs.size()},
          {"difference", 2.0 * half.value},
          {"low", 2.0 * half.low},
          {"high", 2.0 * half.high},
          {"verdict", half.low > 0.0    ? "better"
                      : half.high < 0.0 ? "worse"
                                        : "not told apart"}};
}

Json entry_json(int number, const EntryLegs& entry, const Strength& rating) {
  Json against = Json::object();
  for (const auto& [name, met] : entry.against)
    against[name] = {{"legs", met.legs}, {"goals", met.goals}, {"against", met.against}};
  const bool is_known = entry.known > 0;
  return {{"entry", number},
          {"legs", entry.legs},
          {"rating", rating.value},
          {"low", rating.low},
          {"high", rating.high},
          {"against", std::move(against)},
          {"fouls", is_known ? Json(static_cast<double>(entry.fouls) / entry.known) : Json()},
          {"slowest_tick_ms", is_known ? Json(entry.slowest_ms) : Json()}};
}

std::string after(const char* format, double now, double before) {
  return system::formatted(format, now) + " after " + system::formatted(format, before);
}

// The marks of one drill in two entries.
struct Marks {
  std::string drill;
  double now = 0.0;
  double before = 0.0;

  double gain() const { return now - before; }
  std::string text() const { return drill + " " + after("%.0f", now, before); }
};

std::vector<Marks> common_marks(const Json& now, const Json& before) {
  std::vector<Marks> all;
  for (const Json& a : now["drills"]) {
    for (const Json& b : before["drills"]) {
      if (a["name"] == b["name"] && a["version"] == b["version"])
        all.push_back({text_in(a, "name"), value_in(a, "score", 0.0), value_in(b, "score", 0.0)});
    }
  }
  return all;
}

// Returns the change of the mean of all drills, and the drills that changed most; "" if none is
// known of both entries.
std::string drills_in_words(const Json& now, const Json& before) {
  const std::vector<Marks> all = common_marks(now, before);
  if (all.empty()) return "";
  double sums[] = {0.0, 0.0};
  for (const Marks& one : all) {
    sums[0] += one.now;
    sums[1] += one.before;
  }
  const auto count = static_cast<double>(all.size());
  std::string text = ", drills " + after("%.1f", sums[0] / count, sums[1] / count);
  const auto [worst, best] = std::ranges::minmax_element(
      all, [](const Marks& a, const Marks& b) { return a.gain() < b.gain(); });
  std::string most = best->gain() > 0.0 ? "better: " + best->text() : "";
  if (worst->gain() < 0.0) most += (most.empty() ? "worse: " : "; worse: ") + worst->text();
  return most.empty() ? text : text + " (" + most + ")";
}

}  // namespace

Json progress_of(const Json& friendlies, const std::function<Json(int)>& drills_of) {
  std::map<int, EntryLegs> entries;
  const std::vector<HouseLeg> legs = house_legs(friendlies, entries);
  if (legs.empty()) return Json::array();
  const std::vector<Strength> ratings = ratings_of(legs, entries);
  std::vector<Json> rows;
  for (const auto& [number, entry] : entries) {
    rows.push_back(entry_json(number, entry, ratings[rows.size()]));
    rows.back()["drills"] = drills_of(number);
    rows.back()["former"] = against_former(friendlies, number);
  }
  std::ranges::reverse(rows);
  return Json(rows);
}

std::string change_in_words(const Json& progress) {
  if (progress.size() < 2) return "";
  const Json& now = progress[0];
  const Json& before = progress[1];
  int goals[] = {0, 0};
  int against[] = {0, 0};
  for (const auto& [name, met] : now["against"].items()) {
    if (!before["against"].contains(name)) continue;
    const Json* const both[] = {&met, &before["against"][name]};
    for (int i = 0; i < 2; ++i) {
      goals[i] += value_in(*both[i], "goals", 0);
      against[i] += value_in(*both[i], "against", 0);
    }
  }
  const auto score = [&](int i) {
    return std::to_string(goals[i]) + " : " + std::to_string(against[i]);
  };
  const auto change = [&](const char* format, const char* key) {
    return after(format, value_in(now, key, 0.0), value_in(before, key, 0.0));
  };
  std::string text = "Entry " + now["entry"].dump() + " after entry " + before["entry"].dump() +
                     ": rating " + change("%+.0f", "rating") + ", goals " + score(0) + " after " +
                     score(1);
  if (now["fouls"].is_number() && before["fouls"].is_number()) {
    text += ", fouls a leg " + change("%.1f", "fouls") + ", slowest tick " +
            change("%.2f", "slowest_tick_ms") + " ms";
  }
  if (now["drills"].is_object() && before["drills"].is_object())
    text += drills_in_words(now["drills"], before["drills"]);
  if (const Json& former = now["former"]; former.is_object()) {
    text += ". In " + former["legs"].dump() + " legs against entry " + former["entry"].dump() +
            ": " + text_in(former, "verdict") +
            system::formatted(", difference in strength %+.0f (95 %% interval %+.0f to %+.0f)",
                              value_in(former, "difference", 0.0), value_in(former, "low", 0.0),
                              value_in(former, "high", 0.0));
  }
  return text + ".";
}

}  // namespace mirocup::league
