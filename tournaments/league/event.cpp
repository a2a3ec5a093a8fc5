// SPDX-License-Identifier: MIT
#include "tournaments/league/event.hpp"

#include "record/conditions_json.hpp"
#include "record/json_reader.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace mirocup::league {

namespace {

using record::JsonReader;

constexpr std::size_t max_entries = 1000;        // of a night
constexpr std::string_view strikes = "strikes";  // the cause of a pause by the program

// Keys that were added to the format later have defaults, because old lines lack them.
template <class T>
T value_or(const JsonReader& object, const std::string& key, T fallback) {
  object.read_if_present(key, fallback);
  return fallback;
}

HomeAway read_home_away(const JsonReader& json) {
  return {.home = json.at("home").integer(0, max_count),
          .away = json.at("away").integer(0, max_count)};
}

std::optional<LegFault> read_fault(const JsonReader& json) {
  if (json.is_null()) return std::nullopt;
  return LegFault{.team = json.at("team").text(),
                  .code = json.at("code").text(),
                  .text = json.at("text").text()};
}

Event read_started(const JsonReader& line) {
  const auto conditions = line.find("conditions");
  return Started{
      .config_sha256 = line.at("config_sha256").text(),
      .version = value_or<std::string>(line, "version", ""),
      .conditions = conditions ? record::read_conditions(*conditions) : match::Conditions{},
      .build = value_or<std::string>(line, "build", ""),
      .game = value_or<std::string>(line, "game", "")};
}

Event read_entry(const JsonReader& line) {
  return EntryBooked{.team = line.at("team").text(),
                     .entry = line.at("entry").integer<int>(),
                     .sha256 = line.at("sha256").text()};
}

Event read_join(const JsonReader& line) {
  return TeamJoined{.team = line.at("team").text(), .source = line.at("source").text()};
}

Event read_leg(const JsonReader& line) {
  const JsonReader winner = line.at("winner");
  return LegPlayed{
      .fixture = line.at("fixture").text(),
      .leg = line.at("leg").integer<int>(),
      .attempt = value_or(line, "attempt", 1),
      .home = line.at("home").text(),
      .away = line.at("away").text(),
      .blue = value_or<std::string>(line, "blue", ""),
      .score = read_home_away(line.at("score")),
      .winner = winner.is_null() ? std::nullopt : std::optional(winner.text()),
      .end = line.at("end").name<LegEnd>(),
      .fault = read_fault(line.at("fault")),
      .penalties = read_home_away(line.at("penalties")),
      .record = line.at("record").text(),
      .state_hash = line.at("state_hash").text(),
  };
}

Event read_void(const JsonReader& line) {
  return LegVoided{.fixture = line.at("fixture").text(),
                   .leg = line.at("leg").integer<int>(),
                   .attempt = value_or(line, "attempt", 1),
                   .cause = value_or(line, "cause", VoidCause::host),
                   .why = line.at("why").text(),
                   .by = value_or<std::string>(line, "by", ""),
                   .at = value_or<std::string>(line, "at", ""),
                   .has_new_seed = value_or(line, "new_seed", false)};
}

Event read_ruling(const JsonReader& line) {
  return Ruled{.fixture = line.at("fixture").text(),
               .leg = line.at("leg").integer<int>(),
               .score = read_home_away(line.at("score")),
               .why = line.at("why").text(),
               .by = value_or<std::string>(line, "by", ""),
               .at = value_or<std::string>(line, "at", "")};
}

Event read_withdrawal(const JsonReader& line) {
  return Withdrawn{.team = line.at("team").text(),
                   .results = line.at("results").name<WithdrawnResults>(),
                   .why = line.at("why").text(),
                   .by = value_or<std::string>(line, "by", ""),
                   .at = value_or<std::string>(line, "at", "")};
}

Event read_pause(const JsonReader& line) {
  return Paused{.team = line.at("team").text(),
                .why = line.at("why").text(),
                .by = value_or<std::string>(line, "by", ""),
                .at = value_or<std::string>(line, "at", ""),
                .is_by_program = value_or<std::string>(line, "cause", "") == strikes};
}

Event read_resume(const JsonReader& line) {
  return Resumed{.team = line.at("team").text(),
                 .why = line.at("why").text(),
                 .by = value_or<std::string>(line, "by", ""),
                 .at = value_or<std::string>(line, "at", "")};
}

Event read_night(const JsonReader& line) {
  NightBegan night{.number = line.at("number").integer(1, max_count),
                   .at = value_or<std::string>(line, "at", "")};
  for (const JsonReader& entry : line.at("entries").elements(0, max_entries)) {
    night.entries.push_back({.team = entry.at("team").text(),
                             .entry = entry.at("entry").integer<int>(),
                             .sha256 = entry.at("sha256").text()});
  }
  return night;
}

Event read_freeze(const JsonReader& line) {
  return Frozen{.from = line.at("from").text(),
                .why = line.at("why").text(),
                .by = value_or<std::string>(line, "by", ""),
                .at = value_or<std::string>(line, "at", "")};
}

Event read_close(const JsonReader& line) {
  return Closed{.why = line.at("why").text(),
                .by = value_or<std::string>(line, "by", ""),
                .at = value_or<std::string>(line, "at", "")};
}

Event read_release(const JsonReader& line) {
  return Released{.level = line.at("level").name<ReleaseLevel>(),
                  .through = line.at("through").text(),
                  .why = line.at("why").text(),
                  .by = value_or<std::string>(line, "by", ""),
                  .at = value_or<std::string>(line, "at", "")};
}

Event read_undo(const JsonReader& line) {
  return Undone{.line = line.at("line").integer<int>(),
                .why = line.at("why").text(),
                .by = value_or<std::string>(line, "by", ""),
                .at = value_or<std::string>(line, "at", "")};
}

Event read_program(const JsonReader& line) {
  return ProgramChosen{.version = line.at("version").text(),
                       .build = line.at("build").text(),
                       .game = line.at("game").text(),
                       .at = value_or<std::string>(line, "at", "")};
}

struct Kind {
  std::string_view name;
  Event (*read)(const JsonReader& line);
};

constexpr Kind kinds[] = {
    {Started::kind, read_started},  {EntryBooked::kind, read_entry},
    {LegPlayed::kind, read_leg},    {LegVoided::kind, read_void},
    {Ruled::kind, read_ruling},     {Withdrawn::kind, read_withdrawal},
    {Paused::kind, read_pause},     {Resumed::kind, read_resume},
    {NightBegan::kind, read_night}, {Frozen::kind, read_freeze},
    {Closed::kind, read_close},     {Released::kind, read_release},
    {Undone::kind, read_undo},      {ProgramChosen::kind, read_program},
    {TeamJoined::kind, read_join},
};
static_assert(std::size(kinds) == std::variant_size_v<Event>, "every kind of event can be read");

Event read_any(const JsonReader& line) {
  const JsonReader name = line.at("kind");
  const auto kind = std::find_if(std::begin(kinds), std::end(kinds),
                                 [&name](const Kind& k) { return name.json() == k.name; });
  if (kind != std::end(kinds)) return kind->read(line);
  name.complain("no kind of line is called " + name.quoted());
  return Event();
}

Json to_json(const HomeAway& numbers) {
  return {{"home", numbers.home}, {"away", numbers.away}};
}

Json to_json(const std::optional<LegFault>& fault) {
  if (!fault) return Json();
  return {{"team", fault->team}, {"code", fault->code}, {"text", fault->text}};
}

// Adds the reason of a decision and, if they are known, the person who made it and the time.
template <class Decision>
Json signed_by(Json fields, const Decision& e) {
  fields["why"] = e.why;
  if (!e.by.empty()) fields["by"] = e.by;
  if (!e.at.empty()) fields["at"] = e.at;
  return fields;
}

Json fields(const Started& e) {
  Json json{{"config_sha256", e.config_sha256}, {"version", e.version}};
  if (!e.build.empty()) json["build"] = e.build;
  if (!e.game.empty()) json["game"] = e.game;
  json["conditions"] = record::to_json(e.conditions);
  return json;
}

Json fields(const EntryBooked& e) {
  return {{"team", e.team}, {"entry", e.entry}, {"sha256", e.sha256}};
}

Json fields(const TeamJoined& e) {
  return {{"team", e.team}, {"source", e.source}};
}

Json fields(const LegPlayed& e) {
  return {{"fixture", e.fixture},
          {"leg", e.leg},
          {"attempt", e.attempt},
          {"home", e.home},
          {"away", e.away},
          {"blue", e.blue},
          {"score", to_json(e.score)},
          {"winner", e.winner ? Json(*e.winner) : Json()},
          {"end", to_string(e.end)},
          {"fault", to_json(e.fault)},
          {"penalties", to_json(e.penalties)},
          {"record", e.record},
          {"state_hash", e.state_hash}};
}

Json fields(const LegVoided& e) {
  Json place{{"fixture", e.fixture},
             {"leg", e.leg},
             {"attempt", e.attempt},
             {"cause", to_string(e.cause)}};
  if (e.has_new_seed) place["new_seed"] = true;
  return signed_by(place, e);
}

Json fields(const Ruled& e) {
  const Json place{{"fixture", e.fixture}, {"leg", e.leg}, {"score", to_json(e.score)}};
  return signed_by(place, e);
}

Json fields(const Withdrawn& e) {
  const Json what{{"results", to_string(e.results)}, {"team", e.team}};
  return signed_by(what, e);
}

Json fields(const Paused& e) {
  Json json{{"team", e.team}};
  if (e.is_by_program) json["cause"] = strikes;
  return signed_by(json, e);
}

Json fields(const NightBegan& e) {
  Json entries = Json::array();
  for (const EntryBooked& entry : e.entries) entries.push_back(fields(entry));
  Json json{{"number", e.number}, {"entries", entries}};
  if (!e.at.empty()) json["at"] = e.at;
  return json;
}

Json fields(const Frozen& e) {
  return signed_by({{"from", e.from}}, e);
}

Json fields(const Closed& e) {
  return signed_by(Json::object(), e);
}

Json fields(const Released& e) {
  return signed_by({{"level", to_string(e.level)}, {"through", e.through}}, e);
}

Json fields(const Undone& e) {
  return signed_by({{"line", e.line}}, e);
}

Json fields(const ProgramChosen& e) {
  Json json{{"version", e.version}, {"build", e.build}, {"game", e.game}};
  if (!e.at.empty()) json["at"] = e.at;
  return json;
}

Json fields(const Resumed& e) {
  return signed_by({{"team", e.team}}, e);
}

// Returns "line 7", with the number that the journal gave to the line.
std::string name_of(const Json& line) {
  return line.is_object() && line.contains("n") ? "line " + record::json_text(line["n"]) : "a line";
}

}  // namespace

Result<Event> read_event(const Json& line) {
  std::optional<record::JsonProblem> problem;
  Event event = read_any(JsonReader(line, "", problem));
  if (problem) return tl::unexpected(record::error_of(*problem, name_of(line), Errc::damaged));
  return event;
}

std::string_view kind_of(const Event& event) {
  return std::visit([](const auto& e) { return e.kind; }, event);
}

Json fields_of(const Event& event) {
  return std::visit([](const auto& e) { return fields(e); }, event);
}

const std::string* fixture_of(const Event& event) {
  return std::visit(
      [](const auto& e) -> const std::string* {
        if constexpr (requires { e.fixture; }) {
          return &e.fixture;
        } else {
          return nullptr;
        }
      },
      event);
}

}  // namespace mirocup::league
