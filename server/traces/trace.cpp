// SPDX-License-Identifier: MIT
#include "server/traces/trace.hpp"

#include "core/referee/decide.hpp"
#include "server/record/rules_json.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace mirocup::traces {

namespace {

using Json = nlohmann::ordered_json;
using referee::RobotId;

// What a line says that cannot be; caught in trace_from_json().
struct Wrong {
  std::string text;
};

template <class E>
E named(const Json& json, const std::string& key, E otherwise) {
  if (!json.contains(key)) return otherwise;
  const auto value = from_string<E>(json[key].get<std::string>());
  if (!value) throw Wrong{"/" + key + ": one of " + list_of_names<E>() + " is expected"};
  return *value;
}

End end_of(const std::string& name, const std::string& key) {
  if (name == "L") return End::left;
  if (name == "R") return End::right;
  throw Wrong{"/" + key + ": \"L\" or \"R\" is expected"};
}

Vec2 point_of(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>()};
}

Pose pose_of(const Json& json) {
  return {point_of(json), Heading::from_angle(json.size() > 2 ? json.at(2).get<double>() : 0.0)};
}

RobotId robot_of(const std::string& name, int robots) {
  const bool well_formed =
      name.size() >= 2 && name.size() <= 3 && (name[0] == 'L' || name[0] == 'R') &&
      std::all_of(name.begin() + 1, name.end(), [](char c) { return c >= '0' && c <= '9'; });
  const int index = well_formed ? std::stoi(name.substr(1)) : robots;
  if (index >= robots) throw Wrong{"\"" + name + "\" is no robot of this league"};
  return {name[0] == 'L' ? End::left : End::right, index};
}

void read_robots(const Json& json, int robots, referee::ByEnd<std::vector<Pose>>& into) {
  for (const End end : both_ends) {
    const std::string key = end == End::left ? "L" : "R";
    if (!json.contains(key)) continue;
    auto& poses = into[index_of(end)];
    poses.clear();
    for (const Json& pose : json[key]) poses.push_back(pose_of(pose));
    if (static_cast<int>(poses.size()) > robots) {
      throw Wrong{"/" + key + ": this league has " + std::to_string(robots) + " robots a team"};
    }
  }
}

std::vector<KeyFrame::Contact> contacts_of(const Json& json, int robots) {
  std::vector<KeyFrame::Contact> contacts;
  for (const Json& pair : json) {
    std::string a = pair.at(0).get<std::string>();
    std::string b = pair.at(1).get<std::string>();
    if (a == "ball") std::swap(a, b);
    contacts.emplace_back(robot_of(a, robots), b == "ball" ? std::optional<RobotId>()
                                                           : std::optional(robot_of(b, robots)));
  }
  return contacts;
}

KeyFrame frame_of(const Json& json, KeyFrame frame, int robots) {
  frame.t = json.value("t", frame.t);
  if (json.contains("ball")) {
    frame.ball = point_of(json["ball"]);
    frame.ball_since = frame.t;
  }
  read_robots(json, robots, frame.robots);
  if (json.contains("contacts")) {
    frame.contacts.reset();
    if (!json["contacts"].is_null()) frame.contacts = contacts_of(json["contacts"], robots);
  }
  if (json.contains("drive")) {
    for (const auto& [name, value] : json["drive"].items()) {
      const RobotId robot = robot_of(name, robots);
      frame.drive[index_of(robot.end)][robot.index] = value.get<double>();
    }
  }
  if (json.contains("last_touch")) {
    frame.last_touch = robot_of(json["last_touch"].get<std::string>(), robots);
  }
  if (json.contains("fallen")) {
    frame.fallen = {};
    for (const Json& name : json["fallen"]) {
      const RobotId robot = robot_of(name.get<std::string>(), robots);
      frame.fallen[index_of(robot.end)].set(robot.index);
    }
  }
  return frame;
}

Motion motion_of(const Json& json) {
  Motion motion;
  const std::string type = json.at("type").get<std::string>();
  if (type == "sine") {
    motion.type = Motion::Type::sine;
    motion.amplitude = json.at("amp").get<double>();
    motion.frequency = json.at("hz").get<double>();
  } else if (type == "line") {
    motion.type = Motion::Type::line;
    motion.velocity = point_of(json.at("v"));
  } else {
    throw Wrong{"/motion/type: \"sine\" or \"line\" is expected"};
  }
  return motion;
}

void read_frames(const Json& json, int robots, Trace& trace) {
  KeyFrame before;
  for (const Json& frame : json.value("frames", Json::array())) {
    if (frame.contains("motion")) trace.motion = motion_of(frame["motion"]);
    before = frame_of(frame, before, robots);
    if (!trace.frames.empty() && before.t < trace.frames.back().t) {
      throw Wrong{"/frames: their times do not count up"};
    }
    trace.frames.push_back(before);
  }
  if (json.contains("attempt")) {
    const Json& attempt = json["attempt"];
    before = frame_of({{"ball", attempt.at("ball")}}, before, robots);
    trace.frames.assign(1, before);
    trace.attempt = Attempt{end_of(attempt.at("taker").get<std::string>(), "attempt/taker"),
                            attempt.value("t", 0.0)};
  }
  if (trace.frames.empty()) trace.frames.push_back(before);
}

// Presets may be named for their number of robots, and a limit may be "off".
referee::Rules rules_of(const Json& json, League league) {
  Json rules = json.value("params", Json::object());
  for (auto& value : rules) {
    if (value == "off") value = nullptr;
  }
  std::string preset = json.value("preset", "mirosot");
  if (preset == "vsss_3v3" || preset == "vsss_5v5") preset = "vsss";
  rules["preset"] = preset;
  auto read = record::rules_from_json(rules, Errc::input, league);
  if (!read) throw Wrong{read.error().what};
  return *read;
}

referee::Decision restart_of(const Json& json, const Trace& trace, const field::Field& field) {
  using referee::Restart;
  referee::Decision d;
  d.restart = named(json, "restart", Restart::none);
  d.taker = trace.attempt ? trace.attempt->taker : end_of(json.value("taker", "L"), "taker");
  if (trace.progress.phase == referee::Phase::SHOOT_OUT) d.restart = Restart::PENALTY_KICK;
  if (d.restart == Restart::KICK_OFF) d.spot = trace.frames.front().ball;
  if (d.restart == Restart::FREE_BALL) {
    const std::string quarter = json.value("quarter", "++");
    if (quarter.size() != 2) throw Wrong{"/quarter: two signs are expected, as in \"+-\""};
    const Vec2 signs{quarter[0] == '-' ? -1.0 : 1.0, quarter[1] == '-' ? -1.0 : 1.0};
    give_free_ball({field, trace.rules}, signs, d);
  }
  return d;
}

void read_asked(const Json& json, const field::Field& field, Trace& trace) {
  if (trace.state != TraceState::PLACE) return;
  trace.asked = default_placement({field, trace.rules}, trace.restart.restart, trace.restart.taker,
                                  trace.restart.spot);
  const Json place = json.value("place", Json::object());
  if (place.contains("ball")) trace.asked->ball = point_of(place["ball"]);
  referee::ByEnd<std::vector<Pose>> robots;
  read_robots(place, field.robots_per_team, robots);
  for (const End end : both_ends) {
    const int e = index_of(end);
    trace.asked_robots[e] = static_cast<int>(robots[e].size());
    std::copy(robots[e].begin(), robots[e].end(), trace.asked->robots[e].begin());
  }
}

void read_events(const Json& json, int robots, Trace& trace) {
  for (const Json& event : json.value("events", Json::array())) {
    const double t = event.value("t", 0.0);
    if (event.contains("call")) {
      trace.calls.push_back({t, end_of(event["call"].get<std::string>(), "events/call"), {}});
    }
    if (event.contains("substitute")) {
      const RobotId robot = robot_of(event["substitute"].get<std::string>(), robots);
      trace.calls.push_back({t, robot.end, robot});
    }
    if (event.contains("hand")) {
      trace.hands.push_back({t, end_of(event["hand"].get<std::string>(), "events/hand")});
    }
  }
  for (const Json& team : json.value("missing", Json::array())) {
    trace.missing[index_of(end_of(team.get<std::string>(), "missing"))] = true;
  }
}

Trace trace_of(const Json& json) {
  Trace trace;
  trace.id = json.value("id", "");
  trace.league = named(json, "league", League::small);
  trace.rules = rules_of(json, trace.league);
  trace.state = named(json, "state", TraceState::PLAY);
  trace.progress.clock = json.value("clock", 60.0);
  trace.progress.phase = named(json, "phase", referee::Phase::FIRST_HALF);
  trace.progress.stage = named(json, "stage", referee::Stage::group);
  if (json.contains("score")) {
    trace.progress.score = {json["score"].at(0).get<int>(), json["score"].at(1).get<int>()};
  }
  const field::Field field = field::make_field(trace.league);
  read_frames(json, field.robots_per_team, trace);
  trace.restart = restart_of(json, trace, field);
  trace.is_interpolated = json.value("lerp", false);
  if (json.contains("motion")) trace.motion = motion_of(json["motion"]);
  if (json.contains("hold")) trace.hold = json["hold"].get<double>();
  for (const Json& stop : json.value("clock_stops", Json::array())) {
    trace.clock_stops.emplace_back(stop.at(0).get<double>(), stop.at(1).get<double>());
  }
  read_events(json, field.robots_per_team, trace);
  read_asked(json, field, trace);
  return trace;
}

}  // namespace

Result<Trace> trace_from_json(const Json& json) {
  try {
    if (!json.is_object()) throw Wrong{"an object is expected"};
    return trace_of(json);
  } catch (const Wrong& wrong) {
    return fail(Errc::input, wrong.text);
  } catch (const std::exception& e) {
    return fail(Errc::input, e.what());
  }
}

}  // namespace mirocup::traces
