// SPDX-License-Identifier: MIT
#include "record/scene_json.hpp"

#include "record/json_reader.hpp"
#include "record/motion_json.hpp"
#include "record/parameters_json.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace mirocup::record {

namespace {

using Json = nlohmann::ordered_json;
using namespace simulator;

constexpr std::string_view scene_schema = "mirocup/scene/1";
constexpr std::string_view result_schema = "mirocup/scene-result/1";

// What a scene may ask for, so that every scene ends and its result fits into memory. scene.md
// gives the reasons.
constexpr double max_duration = 3600.0;   // s
constexpr double max_away = 1000.0;       // m
constexpr double max_scene_speed = 50.0;  // m/s
constexpr double max_scene_turn = 300.0;  // rad/s
constexpr double max_size = 1e6;  // of headings, rad, and of wheels before their limit, rad/s
constexpr std::size_t max_sampled_states = 250'000;  // of all bodies in all samples

void read_wheels(const JsonReader& json, SceneRobot& robot) {
  robot.wheels_on_ground = !json.is_null();
  if (json.is_null()) return;
  double latest = 0.0;
  for (const JsonReader& row : json.elements()) {
    if (!row.expect_array(3, 3)) return;
    latest = row.at(0).number(latest);
    robot.wheels.push_back(
        {latest, {row.at(1).number(-max_size, max_size), row.at(2).number(-max_size, max_size)}});
  }
}

SceneRobot read_robot(const JsonReader& json, const std::string& default_name) {
  SceneRobot robot{.name = default_name, .state = {}, .wheels_on_ground = true, .wheels = {}};
  if (!json.expect_object({"name", "pose", "twist", "wheels"})) return robot;
  json.read_if_present("name", robot.name);
  if (const JsonReader pose = json.at("pose"); pose.expect_array(3, 3)) {
    robot.state.position = {pose.at(0).number(-max_away, max_away),
                            pose.at(1).number(-max_away, max_away)};
    robot.state.heading = read_heading(pose.at(2), max_size);
  }
  if (json.has("twist"))
    robot.state.twist = read_twist(json.at("twist"), max_scene_speed, max_scene_turn);
  if (json.has("wheels")) read_wheels(json.at("wheels"), robot);
  return robot;
}

void read_robots(const JsonReader& json, Scene& scene) {
  if (!json.expect_array(0, max_robots)) return;
  std::set<std::string> names{"ball", "wall"};
  for (std::size_t i = 0; i < json.size(); ++i) {
    scene.robots.push_back(read_robot(json.at(i), "robot" + std::to_string(i + 1)));
    const std::string& name = scene.robots.back().name;
    if (names.insert(name).second) continue;
    const JsonReader at = json.at(i).at("name");
    at.complain(at.quoted() + " is taken already");
  }
}

void read_samples(const JsonReader& json, Scene& scene) {
  const std::size_t bodies = scene.robots.size() + (scene.ball ? 1 : 0);
  for (const JsonReader& time :
       json.elements(0, max_sampled_states / std::max<std::size_t>(bodies, 1))) {
    scene.sample_at.push_back(time.number(0.0, scene.duration));
  }
  std::sort(scene.sample_at.begin(), scene.sample_at.end());
}

Scene read_scene(const JsonReader& json) {
  Scene scene;
  if (!json.expect_object(
          {"schema", "league", "parameters", "walls", "duration", "ball", "robots", "sample_at"})) {
    return scene;
  }
  json.expect_schema(scene_schema);
  json.read_if_present("league", scene.league);
  if (json.has("parameters")) read_physics(json.at("parameters"), scene.parameters);
  json.read_if_present("walls", scene.has_walls);
  scene.duration = json.at("duration").number(0.0, max_duration);
  if (json.has("ball")) {
    const JsonReader ball = json.at("ball");
    if (ball.expect_object({"position", "velocity"})) {
      scene.ball =
          BallState{.position = read_vector(ball.at("position"), max_away), .velocity = {0.0, 0.0}};
      if (ball.has("velocity"))
        scene.ball->velocity = read_vector(ball.at("velocity"), max_scene_speed);
    }
  }
  if (json.has("robots")) read_robots(json.at("robots"), scene);
  if (json.has("sample_at")) read_samples(json.at("sample_at"), scene);
  return scene;
}

std::string pointer_to(const Scene& scene, int body) {
  return body < static_cast<int>(scene.robots.size()) ? "/robots/" + std::to_string(body) + "/pose"
                                                      : "/ball/position";
}

std::string name_of(const Scene& scene, int body) {
  if (body == no_body) return "wall";
  return body < static_cast<int>(scene.robots.size()) ? scene.robots[body].name : "ball";
}

std::optional<JsonProblem> find_problem(const Scene& scene) {
  const Parameters& p = scene.parameters;
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    for (const WheelsFrom& row : scene.robots[i].wheels) {
      const double limit = p.wheel_speed_limit;
      const double left = std::clamp(row.speeds.left, -limit, limit);
      const double right = std::clamp(row.speeds.right, -limit, limit);
      if (std::abs(p.speed_reference(left, right)) > max_scene_speed ||
          std::abs(p.omega_reference(left, right)) > max_scene_turn)
        return JsonProblem{"/robots/" + std::to_string(i) + "/wheels",
                           "they drive the robot beyond 50 m/s or turn it beyond 300 rad/s"};
    }
  }
  const auto overlap = find_overlap(scene);
  if (!overlap) return std::nullopt;
  const std::string who = name_of(scene, overlap->first);
  if (overlap->second == no_body) {
    return JsonProblem{pointer_to(scene, overlap->first), who + " lies outside the field"};
  }
  return JsonProblem{pointer_to(scene, overlap->first),
                     who + " and " + name_of(scene, overlap->second) + " overlap"};
}

Json to_json(const Scene& scene, const Sample& sample) {
  Json json{{"t", sample.time}};
  if (sample.ball) {
    json["ball"] = {{"position", vector_json(sample.ball->position)},
                    {"velocity", vector_json(sample.ball->velocity)}};
  }
  json["robots"] = Json::array();
  for (std::size_t i = 0; i < sample.robots.size(); ++i) {
    const BodyState& r = sample.robots[i];
    json["robots"].push_back({{"name", scene.robots[i].name},
                              {"pose", {r.position.x(), r.position.y(), r.heading.angle()}},
                              {"twist", {r.twist.forward, r.twist.left, r.twist.omega}}});
  }
  return json;
}

Json to_json(const Scene& scene, const Impact& impact) {
  return {{"t", impact.time},
          {"bodies", {name_of(scene, impact.first), name_of(scene, impact.second)}},
          {"point", vector_json(impact.point)},
          {"normal", vector_json(impact.normal)},
          {"impulse", impact.impulse}};
}

}  // namespace

Result<Scene> parse_scene(std::string_view text, const std::string& path) {
  auto scene = read_json<Scene>(text, path, Errc::input, read_scene);
  if (!scene) return scene;
  if (const auto problem = find_problem(*scene)) {
    return tl::unexpected(error_of(*problem, path, Errc::input));
  }
  return scene;
}

Json to_json(const Scene& scene, const SceneResult& result, double cpu_seconds) {
  Json json{{"schema", result_schema}};
  json["samples"] = Json::array();
  for (const Sample& sample : result.samples) json["samples"].push_back(to_json(scene, sample));
  json["impacts"] = Json::array();
  for (const Impact& impact : result.statistics.impacts) {
    json["impacts"].push_back(to_json(scene, impact));
  }
  const RunStatistics& trace = result.statistics;
  json["statistics"] = {{"max_penetration", trace.deepest_overlap},
                        {"impacts", trace.impacts.size()},
                        {"lasting_contacts", trace.lasting_contacts},
                        {"position_evaluations", trace.position_evaluations},
                        {"contact_solves", trace.contact_solves},
                        {"cpu_seconds", cpu_seconds}};
  return json;
}

}  // namespace mirocup::record
