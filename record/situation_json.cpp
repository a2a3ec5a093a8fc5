// SPDX-License-Identifier: MIT
#include "record/situation_json.hpp"

#include "core/field/field.hpp"
#include "core/simulator/scene.hpp"
#include "record/json_fields.hpp"
#include "record/motion_json.hpp"
#include "system/text.hpp"

#include <algorithm>
#include <cmath>

namespace mirocup::record {

namespace {

using Json = nlohmann::ordered_json;
using match::RestartStart;
using match::RobotStart;
using match::Start;

constexpr std::string_view situation_schema = "mirocup/situation/1";

constexpr double max_position = 10.0;        // m
constexpr double max_speed = 20.0;           // m/s
constexpr double max_turn = 500.0;           // rad/s
constexpr double max_wheels = 127.0;         // rad/s, as in records
constexpr double max_situation_angle = 1e3;  // rad
constexpr double full_turn = 6.2832;         // rad
constexpr double max_clock = 36000.0;        // s
constexpr int max_score = 1000;

simulator::BallState read_ball(const JsonReader& json) {
  simulator::BallState ball;
  if (!json.expect_object({"position", "velocity"})) return ball;
  ball.position = read_vector(json.at("position"), max_position);
  if (json.has("velocity")) ball.velocity = read_vector(json.at("velocity"), max_speed);
  return ball;
}

// The wheel speeds that keep a twist, within what a record can hold.
simulator::WheelSpeeds wheels_that_keep(const simulator::Twist& twist) {
  const simulator::Parameters p;
  const double turn = twist.omega * p.wheel_distance / 2.0;
  const auto clamped = [&p](double speed) {
    return std::clamp(speed / p.wheel_radius, -p.wheel_speed_limit, p.wheel_speed_limit);
  };
  return {clamped(twist.forward - turn), clamped(twist.forward + turn)};
}

RobotStart read_robot(const JsonReader& json) {
  RobotStart robot;
  if (json.is_null() || !json.expect_object({"pose", "twist", "wheels", "broken"})) return robot;
  json.read_if_present("broken", robot.is_broken);
  if (!json.has("pose")) {
    for (const char* key : {"twist", "wheels"}) {
      if (json.has(key)) json.at(key).complain("a robot that moves at the start needs a pose");
    }
    return robot;
  }
  simulator::BodyState& state = robot.state.emplace();
  if (const JsonReader pose = json.at("pose"); pose.expect_array(3, 3)) {
    state.position = {pose.at(0).number(-max_position, max_position),
                      pose.at(1).number(-max_position, max_position)};
    const JsonReader heading = pose.at(2);
    // A page saves headings of more than a turn; people write degrees as whole numbers.
    if (heading.json().is_number_integer() && std::abs(heading.number()) > full_turn) {
      heading.complain(
          "a heading is in radians, and this is more than a full turn; 90 degrees "
          "are 1.5708");
    }
    state.heading = read_heading(heading, max_situation_angle);
  }
  if (json.has("twist")) state.twist = read_twist(json.at("twist"), max_speed, max_turn);
  if (json.has("wheels")) {
    const Vec2 wheels = read_vector(json.at("wheels"), max_wheels);
    robot.wheels = {wheels.x(), wheels.y()};
  } else if (!robot.is_broken) {
    robot.wheels = wheels_that_keep(state.twist);
  }
  return robot;
}

referee::Quarter read_quarter(const JsonReader& json) {
  const std::string signs = json.text();
  if (signs.size() != 2 || signs.find_first_not_of("+-") != std::string::npos) {
    json.complain("two signs are expected, as in \"+-\"");
    return {};
  }
  return {signs[0] == '+' ? 1.0 : -1.0, signs[1] == '+' ? 1.0 : -1.0};
}

// `ball` tells the quarter of a free ball for which none is given.
RestartStart read_restart(const JsonReader& json, const std::optional<simulator::BallState>& ball) {
  RestartStart restart;
  if (!json.expect_object({"kind", "taker", "quarter"})) return restart;
  restart.kind = json.at("kind").name<referee::Restart>();
  if (restart.kind == referee::Restart::none) {
    json.at("kind").complain("a restart is expected; \"restart\": null means that play is on");
  }
  json.read_if_present("taker", restart.taker);
  if (ball) restart.quarter = referee::quarter_of(ball->position);
  if (json.has("quarter")) restart.quarter = read_quarter(json.at("quarter"));
  return restart;
}

bool moves(const RobotStart& robot) {
  if (!robot.state) return false;
  const simulator::Twist& twist = robot.state->twist;
  return twist.forward != 0.0 || twist.left != 0.0 || twist.omega != 0.0 ||
         robot.wheels.left != 0.0 || robot.wheels.right != 0.0;
}

// At a restart everything stands until the whistle.
void expect_rest(const JsonReader& json, const Start& start) {
  const std::string why = "at a restart everything stands until the whistle";
  if (start.ball && start.ball->velocity != Vec2{}) json.at("ball").at("velocity").complain(why);
  for (const Team team : both_teams) {
    for (std::size_t i = 0; i < max_robots_per_team; ++i) {
      if (!moves(start.robots[index_of(team)][i])) continue;
      json.at(std::string(to_string(team))).at(i).complain(why);
    }
  }
}

simulator::Scene scene_of(const Situation& situation, const field::Field& field) {
  const referee::Rules rules = referee::make_rules(referee::Preset::mirosot, situation.league);
  simulator::Scene scene;
  scene.league = situation.league;
  const referee::JudgedField pitch{.field = field,
                                   .rules = rules,
                                   .ball_radius = scene.parameters.ball_radius,
                                   .robot_side = scene.parameters.robot_side};
  const referee::Placement placement = match::placement_of(pitch, situation.start);
  for (const Team team : both_teams) {
    const End end = team == situation.start.left ? End::left : End::right;
    for (int i = 0; i < field.robots_per_team; ++i) {
      const Pose& pose = placement.robots[index_of(end)][i];
      scene.robots.push_back({.name = std::string(to_string(team)) + " robot " + std::to_string(i),
                              .state = {pose.position, pose.heading, {}},
                              .wheels_on_ground = true,
                              .wheels = {}});
    }
  }
  scene.ball = simulator::BallState{.position = placement.ball, .velocity = {0.0, 0.0}};
  return scene;
}

std::string millimetres(double metres) {
  return system::formatted("%.1f mm", 1e3 * metres);
}

void expect_no_overlap(const JsonReader& json, const Situation& situation) {
  const field::Field field = field::make_field(situation.league);
  const simulator::Scene scene = scene_of(situation, field);
  const auto overlap = simulator::find_overlap(scene, max_start_overlap);
  if (!overlap) return;
  const int robots = field.robots_per_team;
  const auto name_of = [&](int body) {
    if (body == 2 * robots) return std::string("the ball");
    const RobotStart& robot = situation.start.robots[body / robots][body % robots];
    return scene.robots[body].name + (robot.state ? "" : " in its default place");
  };
  const std::string who = name_of(overlap->first);
  json.complain(overlap->second == simulator::no_body
                    ? who + " lies outside the field by " + millimetres(overlap->depth)
                    : who + " and " + name_of(overlap->second) + " overlap by " +
                          millimetres(overlap->depth));
}

Json robot_json(const RobotStart& robot) {
  Json json = Json::object();
  if (robot.state) {
    const simulator::BodyState& s = *robot.state;
    json["pose"] = {s.position.x(), s.position.y(), {s.heading.cos, s.heading.sin}};
    json["twist"] = {s.twist.forward, s.twist.left, s.twist.omega};
    json["wheels"] = {robot.wheels.left, robot.wheels.right};
  }
  if (robot.is_broken) json["broken"] = true;
  return json;
}

constexpr int max_draws = 100;

bool is_range(const Json& json) {
  return json.is_object() && json.size() == 2 && json.contains("from") && json.contains("to");
}

Result<Situation> draw_once(const Json& ranges, RobotLeague league, Random& random,
                            const std::string& path) {
  Json json{{"schema", "mirocup/situation/1"}, {"league", to_string(league)}};
  const Json numbers = drawn(ranges, random);
  for (const auto& [key, value] : numbers.items()) json[key] = value;
  std::optional<JsonProblem> problem;
  Situation situation = read_situation(JsonReader(json, "", problem));
  if (problem) return tl::unexpected(error_of(*problem, path, Errc::input));
  return situation;
}

}  // namespace

Situation read_situation(const JsonReader& json) {
  Situation situation;
  Start& start = situation.start;
  if (!json.expect_object({"schema", "league", "left", "ball", "blue", "yellow", "restart", "phase",
                           "clock", "score"})) {
    return situation;
  }
  json.expect_schema(situation_schema);
  json.read_if_present("league", situation.league);
  json.read_if_present("left", start.left);
  if (const auto ball = json.find("ball")) start.ball = read_ball(*ball);
  const int robots = field::make_field(situation.league).robots_per_team;
  for (const Team team : both_teams) {
    const auto list = json.find(std::string(to_string(team)));
    if (!list) continue;
    int i = 0;
    for (const JsonReader& robot : list->elements(0, static_cast<std::size_t>(robots))) {
      start.robots[index_of(team)][i++] = read_robot(robot);
    }
  }
  if (const auto restart = json.find("restart")) start.restart = read_restart(*restart, start.ball);
  json.read_if_present("phase", start.phase);
  if (json.has("clock")) start.clock = json.at("clock").number(0.0, max_clock);
  if (json.has("score")) {
    const JsonReader score = json.at("score");
    if (score.expect_array(2, 2)) {
      start.score = {score.at(0).integer<int>(0, max_score),
                     score.at(1).integer<int>(0, max_score)};
    }
  }
  const bool kicks_penalty = start.restart && start.restart->kind == referee::Restart::PENALTY_KICK;
  if (start.phase == referee::Phase::SHOOT_OUT && !kicks_penalty) {
    json.at("phase").complain("a shoot-out starts with a restart of kind PENALTY_KICK");
  }
  if (start.restart) expect_rest(json, start);
  expect_no_overlap(json, situation);
  return situation;
}

Result<Situation> parse_situation(std::string_view text, const std::string& path) {
  return read_json<Situation>(text, path, Errc::input, read_situation);
}

Json to_json(const Situation& situation) {
  const Start& start = situation.start;
  Json json{{"schema", situation_schema},
            {"league", to_string(situation.league)},
            {"left", to_string(start.left)}};
  if (start.ball) {
    json["ball"] = {{"position", vector_json(start.ball->position)},
                    {"velocity", vector_json(start.ball->velocity)}};
  }
  const int robots = field::make_field(situation.league).robots_per_team;
  for (const Team team : both_teams) {
    Json& list = json[std::string(to_string(team))] = Json::array();
    for (int i = 0; i < robots; ++i) list.push_back(robot_json(start.robots[index_of(team)][i]));
  }
  json["restart"] = nullptr;
  if (start.restart) {
    const RestartStart& restart = *start.restart;
    json["restart"] = {{"kind", to_string(restart.kind)},
                       {"taker", to_string(restart.taker)},
                       {"quarter", std::string(restart.quarter.x > 0.0 ? "+" : "-") +
                                       (restart.quarter.y > 0.0 ? "+" : "-")}};
  }
  json["phase"] = to_string(start.phase);
  json["clock"] = start.clock;
  json["score"] = {start.score[0], start.score[1]};
  return json;
}

Json drawn(const Json& json, Random& random) {
  if (is_range(json) && json["from"].is_number() && json["to"].is_number()) {
    return random.uniform(value_in(json, "from", 0.0), value_in(json, "to", 0.0));
  }
  Json result = json;
  for (auto& member : result) {
    if (member.is_structured()) member = drawn(member, random);
  }
  return result;
}

Result<Situation> draw_situation(const Json& ranges, RobotLeague league, Random& random,
                                 const std::string& path) {
  auto situation = draw_once(ranges, league, random, path);
  for (int i = 1; !situation && i < max_draws; ++i) {
    situation = draw_once(ranges, league, random, path);
  }
  return situation;
}

}  // namespace mirocup::record
