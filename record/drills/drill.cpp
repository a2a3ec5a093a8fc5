// SPDX-License-Identifier: MIT
#include "record/drills/drill.hpp"

#include "core/field/field.hpp"
#include "record/conditions_json.hpp"
#include "record/json_reader.hpp"
#include "record/rules_json.hpp"
#include "record/situation_json.hpp"
#include "record/team_parameters_json.hpp"

#include <filesystem>

namespace mirocup::drills {

namespace {

using Json = nlohmann::ordered_json;
using record::JsonReader;

constexpr std::string_view schema = "mirocup/drill/1";

constexpr double max_seconds = 600.0;
constexpr int max_tries = 10000;
constexpr std::size_t max_events = 16;
constexpr double max_length = 10.0;  // m
constexpr double max_angle = 1e3;    // rad

void read_robot(const JsonReader& json, int robots, Event& event) {
  const JsonReader robot = json.at("robot");
  event.is_of_ball = false;
  if (robot.is_string()) {
    if (robot.text() != "any") robot.complain("a number or \"any\" is expected");
    return;
  }
  event.robot = robot.integer<int>(0, robots - 1);
}

void read_pose(const JsonReader& json, Event& event) {
  const JsonReader pose = json.at("pose");
  if (!pose.expect_array(3, 3)) return;
  event.pose = {
      {pose.at(0).number(-max_length, max_length), pose.at(1).number(-max_length, max_length)},
      Heading::from_angle(pose.at(2).number(-max_angle, max_angle))};
}

void read_area(const JsonReader& json, Event& event) {
  const JsonReader area = json.at("area");
  if (!area.expect_array(4, 4)) return;
  for (std::size_t i = 0; i < 4; ++i) event.area[i] = area.at(i).number(-max_length, max_length);
  if (!(event.area[0] < event.area[2] && event.area[1] < event.area[3])) {
    area.complain("[low x, low y, high x, high y] is expected");
  }
}

// The keys of an event besides "event", "marks" and "by".
void expect_keys(const JsonReader& json, EventKind kind) {
  using enum EventKind;
  if (kind == goal || kind == save || kind == pass)
    json.expect_object({"event", "marks", "by", "count"});
  if (kind == no_goal || kind == no_foul) json.expect_object({"event", "marks", "most"});
  if (kind == touch) json.expect_object({"event", "marks", "by", "count", "robot", "first"});
  if (kind == pose)
    json.expect_object(
        {"event", "marks", "by", "robot", "pose", "of", "within", "within_angle", "for"});
  if (kind == in_area) json.expect_object({"event", "marks", "by", "robot", "area", "for"});
}

Event read_event(const JsonReader& json, int robots) {
  Event event;
  if (!json.expect_object()) return event;
  event.kind = json.at("event").name<EventKind>();
  expect_keys(json, event.kind);
  if (json.has("marks")) event.marks = json.at("marks").positive_number();
  if (json.has("by")) event.by = json.at("by").number(0.0, max_seconds);
  if (json.has("count")) event.count = json.at("count").integer<int>(1, 1000);
  if (json.has("most")) event.most = json.at("most").integer<int>(0, 1000);
  json.read_if_present("first", event.first);
  if (json.has("robot")) read_robot(json, robots, event);
  if (event.kind == EventKind::pose) read_pose(json, event);
  if (event.kind == EventKind::in_area) read_area(json, event);
  json.read_if_present("of", event.frame);
  if (json.has("within")) event.within = json.at("within").positive_number();
  if (json.has("within_angle")) event.within_angle = json.at("within_angle").positive_number();
  if (json.has("for")) event.hold = json.at("for").number(0.0, max_seconds);
  return event;
}

Deductions read_deductions(const JsonReader& json) {
  Deductions deductions;
  if (!json.expect_object({"time", "foul"})) return deductions;
  if (json.has("time")) deductions.time = json.at("time").number(0.0, 1.0);
  if (json.has("foul")) deductions.foul = json.at("foul").number(0.0, 1.0);
  return deductions;
}

Drill read_drill(const JsonReader& json) {
  Drill drill;
  if (!json.expect_object({"schema", "title", "teaches", "version", "league", "rules", "situation",
                           "opponent", "mates", "robots", "parameters", "seconds", "tries",
                           "conditions", "plays_on", "success", "score"})) {
    return drill;
  }
  json.expect_schema(schema);
  drill.title = json.at("title").text();
  json.read_if_present("teaches", drill.teaches);
  if (json.has("version")) drill.version = json.at("version").integer<int>(1, 1000000);
  json.read_if_present("league", drill.league);
  drill.rules = referee::make_rules(referee::Preset::mirosot, drill.league);
  if (json.has("rules")) drill.rules = record::read_rules(json.at("rules"), drill.league);
  drill.conditions = match::conditions_of(match::default_preset);
  if (json.has("conditions")) drill.conditions = record::read_conditions(json.at("conditions"));
  drill.situation = Json::object();
  if (json.has("situation") && json.at("situation").expect_object()) {
    drill.situation = json.at("situation").json();
    const JsonReader situation = json.at("situation");
    if (situation.has("league") && situation.at("league").name<RobotLeague>() != drill.league) {
      situation.at("league").complain("the situation must be of the drill's league");
    }
  }
  drill.opponent = json.at("opponent").text();
  const int robots = field::make_field(drill.league).robots_per_team;
  for (int i = 0; i < robots; ++i) drill.robots.set(static_cast<std::size_t>(i));
  if (json.has("mates") && json.at("mates").text() != "own") {
    drill.mates = json.at("mates").text();
    drill.robots.reset();
    for (const JsonReader& robot : json.at("robots").elements(1)) {
      drill.robots.set(static_cast<std::size_t>(robot.integer<int>(0, robots - 1)));
    }
  } else if (json.has("robots")) {
    json.at("robots").complain(
        "with \"mates\": \"own\" the tested team steers all robots: leave this key out");
  }
  if (json.has("parameters")) {
    drill.parameters = record::read_team_parameters(json.at("parameters"));
  }
  drill.seconds = json.at("seconds").number(0.1, max_seconds);
  if (json.has("tries")) drill.tries = json.at("tries").integer<int>(1, max_tries);
  json.read_if_present("plays_on", drill.plays_on);
  for (const JsonReader& event : json.at("success").elements(1, max_events)) {
    drill.success.push_back(read_event(event, robots));
  }
  if (json.has("score")) drill.deductions = read_deductions(json.at("score"));
  return drill;
}

}  // namespace

Result<Drill> parse_drill(std::string_view text, const std::string& path) {
  auto drill = record::read_json<Drill>(text, path, Errc::input, read_drill);
  if (!drill) return drill;
  drill->name = std::filesystem::path(path).stem().string();
  const auto once = setup_of(*drill, 1);
  if (!once) return fail(Errc::input, path + once.error().what.substr(drill->name.size()));
  return drill;
}

Result<match::Setup> setup_of(const Drill& drill, std::uint64_t seed) {
  Random random(mix_seed(~seed));  // the leg draws from mix_seed(seed)
  MIROCUP_TRY(const auto situation, record::draw_situation(drill.situation, drill.league, random,
                                                           drill.name + ": /situation"));
  match::Setup setup;
  setup.league = drill.league;
  setup.rules = drill.rules;
  setup.conditions = drill.conditions;
  setup.seed = seed;
  setup.control_period = match::control_period_of(setup.rules.preset);
  setup.start = situation.start;
  // A try is the end of a leg, so its record is that of a whole one.
  setup.start->phase = referee::Phase::SECOND_HALF;
  setup.rules.half_s = setup.start->clock + drill.seconds;
  return setup;
}

}  // namespace mirocup::drills
