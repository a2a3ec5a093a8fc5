// SPDX-License-Identifier: MIT
#include "tournaments/publish/leg_facts.hpp"

#include "record/json_fields.hpp"
#include "record/statistics/statistics_json.hpp"
#include "tournaments/publish/site_file.hpp"

namespace mirocup::league {

namespace {

using record::value_in;

const Json& member(const Json& object, const char* key) {
  static const Json none;
  const auto found = object.find(key);
  return found == object.end() ? none : *found;
}

// `half` is the number of halves, and of parts of the extra time, that are over.
GoalFact goal(const Json& decision, double period, const std::string& home, int half) {
  GoalFact fact;
  fact.when = {static_cast<referee::Phase>(std::min(half, 2)), value_in(decision, "clock", 0.0)};
  fact.at = value_in(decision, "tick", 0.0) * period;
  fact.is_home = record::text_in(decision, "gainer") == home;
  fact.is_own_goal = value_in(decision, "own_goal", false);
  if (!fact.is_own_goal) fact.scorer = value_in(member(decision, "scorer"), "robot", -1);
  return fact;
}

}  // namespace

std::string name_in_words(const LegName& leg) {
  return leg.first + " leg " + std::to_string(leg.second);
}

std::optional<LegFacts> facts_of(const std::string& bytes, bool is_home_blue) {
  const record::ParsedJson parsed = record::parse_json(bytes);
  if (parsed.problem) return std::nullopt;
  const Json& json = parsed.value;
  const auto period = value_in<std::optional<double>>(json, "control_period");
  const auto ticks = value_in<std::optional<double>>(json, "ticks");
  const Json& decisions = member(json, "decisions");
  if (!period || !ticks || !decisions.is_array()) return std::nullopt;
  const std::string home = is_home_blue ? "blue" : "yellow";
  LegFacts facts;
  facts.length = *ticks * *period;
  int half = 0;
  for (const Json& decision : decisions) {
    const std::string verdict = record::text_in(decision, "decision");
    if (verdict == "HALF_END" || verdict == "PHASE") ++half;
    if (verdict == "GOAL") {
      facts.goals.push_back(goal(decision, *period, home, half));
    } else if (const std::string by = record::text_in(decision, "offender"); !by.empty()) {
      ++(by == home ? facts.fouls.home : facts.fouls.away);
    }
  }
  const Json& shoot_out = member(member(json, "result"), "shoot_out");
  const auto own = value_in<std::optional<int>>(shoot_out, home.c_str());
  const auto other = value_in<std::optional<int>>(shoot_out, is_home_blue ? "yellow" : "blue");
  if (own && other) facts.shoot_out = HomeAway{.home = *own, .away = *other};
  return facts;
}

std::optional<statistics::LegReport> kept_report(system::Files& files, const Folder& folder,
                                                 const LegName& leg, const std::string& record) {
  const std::string path = folder.site() + "/" + statistics_file_of(record);
  const auto text = files.read(path, {.max_size = system::size_limit::note});
  if (!text) return std::nullopt;
  auto report = statistics::parse_leg_report(*text, path);
  if (!report) return std::nullopt;
  report->leg = name_in_words(leg);
  report->record = record;
  return *std::move(report);
}

void read_legs(system::Files& files, const Folder& folder, const LeagueState& state,
               KnownLegs& known) {
  for (const FixtureState& f : state.fixtures) {
    for (int leg = 1; leg <= max_legs; ++leg) {
      const PlayedLeg* played = f.legs[leg - 1].played.get();
      if (played == nullptr || played->record.empty()) continue;
      const std::string& record = played->record;
      KnownLeg& one = known[record];
      if (!one.report) one.report = kept_report(files, folder, {f.fixture.id(), leg}, record);
      if (one.facts) continue;
      const auto bytes =
          files.read(folder.path + "/" + record, {.max_size = system::size_limit::record});
      if (bytes) one.facts = facts_of(*bytes, Fixture::is_home_blue(leg));
    }
  }
}

}  // namespace mirocup::league
