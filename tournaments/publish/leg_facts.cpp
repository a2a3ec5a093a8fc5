// SPDX-License-Identifier: MIT
#include "tournaments/publish/leg_facts.hpp"

#include "record/json_reader.hpp"

#include <nlohmann/json.hpp>

namespace mirocup::league {

namespace {

const Json& member(const Json& object, const char* key) {
  static const Json none;
  const auto found = object.find(key);
  return found == object.end() ? none : *found;
}

// The team that gains from a goal. Records from before `gainer` name the scoring team `team`.
std::string gainer(const Json& decision) {
  const std::string known = record::text_in(decision, "gainer");
  return known.empty() ? record::text_in(decision, "team") : known;
}

GoalFact goal(const Json& decision, double period, const std::string& home) {
  GoalFact fact;
  const Json& tick = member(decision, "tick");
  fact.at = tick.is_number() ? tick.get<double>() * period : 0.0;
  fact.is_home = gainer(decision) == home;
  const Json& own = member(decision, "own_goal");
  fact.is_own_goal = own.is_boolean() && own.get<bool>();
  const Json& robot = member(member(decision, "scorer"), "robot");
  if (robot.is_number_integer() && !fact.is_own_goal) fact.scorer = robot.get<int>();
  return fact;
}

}  // namespace

std::optional<LegFacts> facts_of(const std::string& bytes, bool is_home_blue) {
  const record::ParsedJson parsed = record::parse_json(bytes);
  if (parsed.problem) return std::nullopt;
  const Json& json = parsed.value;
  const Json& period = member(json, "control_period");
  const Json& ticks = member(json, "ticks");
  const Json& decisions = member(json, "decisions");
  if (!period.is_number() || !ticks.is_number() || !decisions.is_array()) return std::nullopt;
  const std::string home = is_home_blue ? "blue" : "yellow";
  LegFacts facts;
  facts.length = ticks.get<double>() * period.get<double>();
  for (const Json& decision : decisions) {
    if (record::text_in(decision, "decision") == "GOAL") {
      facts.goals.push_back(goal(decision, period.get<double>(), home));
    } else if (const std::string by = record::text_in(decision, "offender"); !by.empty()) {
      ++(by == home ? facts.fouls.home : facts.fouls.away);
    }
  }
  const Json& shoot_out = member(member(json, "result"), "shoot_out");
  const Json& own = member(shoot_out, home.c_str());
  const Json& other = member(shoot_out, is_home_blue ? "yellow" : "blue");
  if (own.is_number() && other.is_number())
    facts.shoot_out = HomeAway{.home = own.get<int>(), .away = other.get<int>()};
  return facts;
}

FactsOfLegs read_facts(system::Files& files, const Folder& folder, const LeagueState& state,
                       FactsOfLegs known) {
  for (const FixtureState& f : state.fixtures) {
    for (int leg = 1; leg <= max_legs; ++leg) {
      const PlayedLeg* played = f.legs[leg - 1].played.get();
      if (played == nullptr || played->record.empty() || known.contains(played->record)) continue;
      const auto bytes =
          files.read(folder.path + "/" + played->record, {.max_size = system::size_limit::record});
      if (!bytes) continue;
      const bool is_home_blue = blue_team(f.fixture, leg) == f.fixture.home;
      if (auto facts = facts_of(*bytes, is_home_blue)) known[played->record] = *std::move(facts);
    }
  }
  return known;
}

}  // namespace mirocup::league
