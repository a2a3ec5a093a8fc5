// SPDX-License-Identifier: MIT
#include "record/traces/trace.hpp"

#include "core/referee/decide.hpp"
#include "record/json_reader.hpp"
#include "record/rules_json.hpp"

#include <algorithm>

namespace mirocup::traces {

namespace {

using Json = nlohmann::ordered_json;
using record::JsonReader;
using referee::RobotId;

// What a situation may have. It is sampled every 33 ms and judged at each sample, so the longest
// takes a second.
constexpr double max_time = 3600.0;  // s
constexpr double max_size = 1e6;     // of every other number: m, rad, m/s, Hz, goals
constexpr std::size_t max_frames = 10'000;
constexpr std::size_t max_contacts = 500;  // of a frame; each body with each other is fewer
constexpr std::size_t max_events = 1000;

double read_time(const JsonReader& json) {
  return json.number(-max_time, max_time);
}

End read_end(const JsonReader& json) {
  const std::string name = json.text();
  if (name != "L" && name != "R") json.complain("\"L\" or \"R\" is expected");
  return name == "R" ? End::right : End::left;
}

double read_number(const JsonReader& json) {
  return json.number(-max_size, max_size);
}

Vec2 read_point(const JsonReader& json) {
  return {read_number(json.at(0)), read_number(json.at(1))};
}

Pose read_pose(const JsonReader& json) {
  return {read_point(json), Heading::from_angle(json.size() > 2 ? read_number(json.at(2)) : 0.0)};
}

// A robot by its name, "L0" or "R10". `at` is where the name stands, for the complaint.
RobotId robot_of(const std::string& name, int robots, const JsonReader& at) {
  const bool is_well_formed =
      name.size() >= 2 && name.size() <= 3 && (name[0] == 'L' || name[0] == 'R') &&
      std::all_of(name.begin() + 1, name.end(), [](char c) { return c >= '0' && c <= '9'; });
  const int index = is_well_formed ? std::stoi(name.substr(1)) : robots;
  if (index < robots) return {name[0] == 'L' ? End::left : End::right, index};
  at.complain("\"" + name + "\" is no robot of this league");
  return {End::left, 0};
}

RobotId read_robot(const JsonReader& json, int robots) {
  return robot_of(json.text(), robots, json);
}

void read_robots(const JsonReader& json, int robots, referee::ByEnd<std::vector<Pose>>& into) {
  for (const End end : both_ends) {
    const std::string key = end == End::left ? "L" : "R";
    if (!json.has(key)) continue;
    const JsonReader list = json.at(key);
    auto& poses = into[index_of(end)];
    poses.clear();
    if (list.size() > static_cast<std::size_t>(robots)) {
      list.complain("this league has " + std::to_string(robots) + " robots a team");
      continue;
    }
    for (const JsonReader& pose : list.elements()) poses.push_back(read_pose(pose));
  }
}

std::vector<KeyFrame::Contact> read_contacts(const JsonReader& json, int robots) {
  std::vector<KeyFrame::Contact> contacts;
  for (const JsonReader& pair : json.elements(0, max_contacts)) {
    JsonReader a = pair.at(0);
    JsonReader b = pair.at(1);
    if (a.json() == "ball") std::swap(a, b);
    const bool is_ball = b.json() == "ball";
    const RobotId robot = read_robot(a, robots);
    if (is_ball) {
      contacts.emplace_back(robot, std::nullopt);
    } else if (const RobotId other = read_robot(b, robots); robot == other) {
      pair.complain("no robot touches itself");
    } else {
      contacts.emplace_back(robot, other);
    }
  }
  return contacts;
}

// Reads a frame. `frame` is the frame before it, from which missing values are taken.
KeyFrame read_frame(const JsonReader& json, KeyFrame frame, int robots) {
  if (json.has("t")) frame.t = read_time(json.at("t"));
  if (json.has("ball")) {
    frame.ball = read_point(json.at("ball"));
    frame.ball_since = frame.t;
  }
  read_robots(json, robots, frame.robots);
  if (json.has("contacts")) {
    frame.contacts.reset();
    if (const auto contacts = json.find("contacts")) {
      frame.contacts = read_contacts(*contacts, robots);
    }
  }
  if (json.has("drive")) {
    for (const auto& [name, value] : json.at("drive").members()) {
      const RobotId robot = robot_of(name, robots, value);
      frame.drive[index_of(robot.end)][robot.index] = read_number(value);
    }
  }
  if (json.has("last_touch")) frame.last_touch = read_robot(json.at("last_touch"), robots);
  if (json.has("fallen")) {
    frame.fallen = {};
    for (const JsonReader& name : json.at("fallen").elements()) {
      const RobotId robot = read_robot(name, robots);
      frame.fallen[index_of(robot.end)].set(robot.index);
    }
  }
  return frame;
}

Motion read_motion(const JsonReader& json) {
  Motion motion;
  const JsonReader type = json.at("type");
  if (type.text() == "sine") {
    motion.type = Motion::Type::sine;
    motion.amplitude = read_number(json.at("amp"));
    motion.frequency = read_number(json.at("hz"));
  } else if (type.text() == "line") {
    motion.type = Motion::Type::line;
    motion.velocity = read_point(json.at("v"));
  } else {
    type.complain("\"sine\" or \"line\" is expected");
  }
  return motion;
}

void read_frames(const JsonReader& json, int robots, Trace& trace) {
  KeyFrame before;
  if (json.has("frames")) {
    for (const JsonReader& frame : json.at("frames").elements(0, max_frames)) {
      if (frame.has("motion")) trace.motion = read_motion(frame.at("motion"));
      before = read_frame(frame, before, robots);
      if (!trace.frames.empty() && before.t < trace.frames.back().t) {
        frame.at("t").complain("the times of frames must not decrease");
      }
      trace.frames.push_back(before);
    }
  }
  if (const auto attempt = json.find("attempt")) {
    before.ball = read_point(attempt->at("ball"));
    before.ball_since = before.t;
    trace.frames.assign(1, before);
    trace.attempt = Attempt{.taker = read_end(attempt->at("taker")), .t = 0.0};
    if (attempt->has("t")) trace.attempt->t = read_time(attempt->at("t"));
  }
  if (trace.frames.empty()) trace.frames.push_back(before);
}

// The names of presets may end with the number of robots.
referee::Rules read_situation_rules(const JsonReader& json, RobotLeague league) {
  auto preset = referee::Preset::mirosot;
  if (json.has("preset")) {
    const JsonReader name = json.at("preset");
    const bool is_vsss = name.json() == "vsss_3v3" || name.json() == "vsss_5v5";
    preset = is_vsss ? referee::Preset::vsss : name.name<referee::Preset>();
  }
  referee::Rules rules = referee::make_rules(preset, league);
  if (json.has("params")) record::read_parameters(json.at("params"), rules);
  return rules;
}

// The signs of a quarter of the field, "+-" for x > 0 and y < 0.
Vec2 read_quarter(const JsonReader& json) {
  if (!json.has("quarter")) return {1.0, 1.0};
  const std::string signs = json.at("quarter").text();
  if (signs.size() != 2) {
    json.at("quarter").complain("two signs are expected, as in \"+-\"");
    return {1.0, 1.0};
  }
  return {signs[0] == '-' ? -1.0 : 1.0, signs[1] == '-' ? -1.0 : 1.0};
}

referee::Decision read_restart(const JsonReader& json, const Trace& trace,
                               const field::Field& field) {
  using referee::Restart;
  referee::Decision d;
  json.read_if_present("restart", d.restart);
  if (json.has("taker")) d.taker = read_end(json.at("taker"));
  if (trace.attempt) d.taker = trace.attempt->taker;
  if (trace.progress.phase == referee::Phase::SHOOT_OUT) d.restart = Restart::PENALTY_KICK;
  if (d.restart == Restart::KICK_OFF) d.spot = trace.frames.front().ball;
  if (d.restart == Restart::FREE_BALL) {
    give_free_ball({field, trace.rules}, read_quarter(json), d);
  }
  return d;
}

void read_requested_placement(const JsonReader& json, const field::Field& field, Trace& trace) {
  if (trace.state != TraceState::PLACE) return;
  trace.requested_placement = default_placement({field, trace.rules}, trace.restart.restart,
                                                trace.restart.taker, trace.restart.spot);
  if (!json.has("place")) return;
  const JsonReader place = json.at("place");
  if (place.has("ball")) trace.requested_placement->ball = read_point(place.at("ball"));
  referee::ByEnd<std::vector<Pose>> robots;
  read_robots(place, field.robots_per_team, robots);
  for (const End end : both_ends) {
    const int e = index_of(end);
    trace.requested_robots[e] = static_cast<int>(robots[e].size());
    std::copy(robots[e].begin(), robots[e].end(), trace.requested_placement->robots[e].begin());
  }
}

void read_event(const JsonReader& event, int robots, Trace& trace) {
  const double t = event.has("t") ? read_time(event.at("t")) : 0.0;
  if (event.has("call")) {
    trace.requests.push_back({.t = t, .team = read_end(event.at("call")), .to_replace = {}});
  }
  if (event.has("substitute")) {
    const RobotId robot = read_robot(event.at("substitute"), robots);
    trace.requests.push_back({.t = t, .team = robot.end, .to_replace = robot});
  }
  if (event.has("hand")) trace.hands.push_back({.t = t, .team = read_end(event.at("hand"))});
}

Trace read_trace(const JsonReader& json) {
  Trace trace;
  if (!json.expect_object()) return trace;
  json.read_if_present("id", trace.id);
  json.read_if_present("league", trace.league);
  trace.rules = read_situation_rules(json, trace.league);
  json.read_if_present("state", trace.state);
  trace.progress.clock = 60.0;
  if (json.has("clock")) trace.progress.clock = read_number(json.at("clock"));
  json.read_if_present("phase", trace.progress.phase);
  json.read_if_present("stage", trace.progress.stage);
  if (json.has("score")) {
    const JsonReader score = json.at("score");
    constexpr int most = static_cast<int>(max_size);
    trace.progress.score = {score.at(0).integer(0, most), score.at(1).integer(0, most)};
  }
  const field::Field field = field::make_field(trace.league);
  const int robots = field.robots_per_team;
  read_frames(json, robots, trace);
  trace.restart = read_restart(json, trace, field);
  json.read_if_present("lerp", trace.is_interpolated);
  if (json.has("motion")) trace.motion = read_motion(json.at("motion"));
  if (json.has("hold")) trace.hold = read_time(json.at("hold"));
  if (json.has("clock_stops")) {
    for (const JsonReader& stop : json.at("clock_stops").elements(0, max_events)) {
      trace.clock_stops.emplace_back(read_number(stop.at(0)), read_number(stop.at(1)));
    }
  }
  if (json.has("events")) {
    for (const JsonReader& event : json.at("events").elements(0, max_events))
      read_event(event, robots, trace);
  }
  if (json.has("missing")) {
    for (const JsonReader& team : json.at("missing").elements()) {
      trace.missing[index_of(read_end(team))] = true;
    }
  }
  read_requested_placement(json, field, trace);
  return trace;
}

}  // namespace

Result<Trace> trace_from_json(Json json) {
  // In a situation, a limit that is off may be "off" as well as null.
  if (json.is_object() && json.contains("params") && json["params"].is_object()) {
    for (Json& value : json["params"]) {
      if (value == "off") value = nullptr;
    }
  }
  std::optional<record::JsonProblem> problem;
  Trace trace = read_trace(JsonReader(json, "", problem));
  if (problem) return fail(Errc::input, problem->pointer + ": " + problem->reason);
  return trace;
}

}  // namespace mirocup::traces
