// SPDX-License-Identifier: MIT
#include "tournaments/league/event.hpp"

#include "record/conditions_json.hpp"
#include "tournaments/journal/kinds.hpp"

namespace mirocup::league {

namespace {

using record::JsonReader;

constexpr std::size_t max_entries = 1000;        // of a night
constexpr std::string_view strikes = "strikes";  // the cause of a pause by the program

}  // namespace

static void list_signature(auto& f, Signature& signature) {
  f("why", signature.why);
  f.if_set("by", signature.by);
  f.if_set("at", signature.at);
}

static void list_fields(auto& f, HomeAway& numbers) {
  f("home", numbers.home, 0, max_count);
  f("away", numbers.away, 0, max_count);
}

static void list_fields(auto& f, LegFault& fault) {
  f("team", fault.team);
  f("code", fault.code);
  f("text", fault.text);
}

static void list_fields(auto& f, Started& e) {
  f("config_sha256", e.config_sha256);
  f("version", e.version);
  f("build", e.build);
  f("game", e.game);
  f.as(
      "conditions", [&] { return record::to_json(e.conditions); },
      [&](const JsonReader& json) { e.conditions = record::read_conditions(json); });
}

static void list_fields(auto& f, EntryBooked& e) {
  f("team", e.team);
  f("entry", e.entry);
  f("sha256", e.sha256);
}

static void list_fields(auto& f, TeamJoined& e) {
  f("team", e.team);
  f("source", e.source);
}

static void list_fields(auto& f, LegPlayed& e) {
  f("fixture", e.fixture);
  f("leg", e.leg);
  f("attempt", e.attempt);
  f("home", e.home);
  f("away", e.away);
  f("blue", e.blue);
  f("score", e.score);
  f("winner", e.winner);
  f("end", e.end);
  f("fault", e.fault);
  f("penalties", e.penalties);
  f("record", e.record);
  f("state_hash", e.state_hash);
}

static void list_fields(auto& f, LegVoided& e) {
  f("fixture", e.fixture);
  f("leg", e.leg);
  f("attempt", e.attempt);
  f("cause", e.cause);
  f.if_set("new_seed", e.has_new_seed);
  list_signature(f, e.signature);
}

static void list_fields(auto& f, Ruled& e) {
  f("fixture", e.fixture);
  f("leg", e.leg);
  f("score", e.score);
  list_signature(f, e.signature);
}

static void list_fields(auto& f, Withdrawn& e) {
  f("results", e.results);
  f("team", e.team);
  list_signature(f, e.signature);
}

static void list_fields(auto& f, Paused& e) {
  f("team", e.team);
  std::string cause(e.is_by_program ? strikes : "");
  f.if_set("cause", cause);
  e.is_by_program = cause == strikes;
  list_signature(f, e.signature);
}

static void list_fields(auto& f, Resumed& e) {
  f("team", e.team);
  list_signature(f, e.signature);
}

static void list_fields(auto& f, NightBegan& e) {
  f("number", e.number, 1, max_count);
  f("entries", e.entries, 0, max_entries);
  f("at", e.at);
}

static void list_fields(auto& f, Frozen& e) {
  f("from", e.from);
  list_signature(f, e.signature);
}

static void list_fields(auto& f, Extended& e) {
  f("team", e.team);
  f("until", e.until);
  f("reason_sha256", e.reason_sha256);
  list_signature(f, e.signature);
}

static void list_fields(auto& f, Closed& e) {
  f.if_set("final", e.closing_round);
  list_signature(f, e.signature);
}

static void list_fields(auto& f, Released& e) {
  f("level", e.level);
  f("through", e.through);
  list_signature(f, e.signature);
}

static void list_fields(auto& f, Undone& e) {
  f("line", e.line);
  list_signature(f, e.signature);
}

Result<Event> read_event(const Json& line) {
  return read_line<Event>(line);
}

std::string_view kind_of(const Event& event) {
  return line_kind(event);
}

Json fields_of(const Event& event) {
  return line_fields(event);
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
