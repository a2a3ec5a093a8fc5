// SPDX-License-Identifier: MIT
#include "record/parameters_json.hpp"

#include "record/json_reader.hpp"
#include "record/motion_json.hpp"

#include <algorithm>
#include <vector>

namespace mirocup::record {

namespace {

using Json = nlohmann::ordered_json;
using simulator::infinite_grip;
using simulator::Parameters;
using simulator::PerPair;

constexpr double min_grip = 1e-6;
constexpr double max_corner = 1.0;   // m
constexpr double min_reach = 0.005;  // m, of the edges from the centre of mass
constexpr double min_parameter = 1e-9;
constexpr double max_parameter = 1e9;

// A number, or an identified one with its interval: {"value", "low", "high"}.
JsonReader plain_value(const JsonReader& json) {
  if (!json.has("value")) return json;
  json.expect_object({"value", "low", "high"});
  return json.at("value");
}

void read_per_pair(const JsonReader& json, double max, PerPair& value) {
  if (!json.expect_object({"ball_wall", "ball_robot", "robot_wall", "robot_robot"})) return;
  const auto read = [&](const char* key, double& member) {
    if (json.has(key)) member = plain_value(json.at(key)).number(0.0, max);
  };
  read("ball_wall", value.ball_wall);
  read("ball_robot", value.ball_robot);
  read("robot_wall", value.robot_wall);
  read("robot_robot", value.robot_robot);
}

double read_grip(const JsonReader& json) {
  if (!json.is_string()) return json.number(min_grip, max_parameter);
  if (json.text() != "infinite") json.complain("a number or \"infinite\" is expected");
  return infinite_grip;
}

Json to_json(const PerPair& value) {
  return {{"ball_wall", value.ball_wall},
          {"ball_robot", value.ball_robot},
          {"robot_wall", value.robot_wall},
          {"robot_robot", value.robot_robot}};
}

}  // namespace

// A convex polygon around the origin, with its corners in either direction.
geometry::OutlineCorners read_outline(const JsonReader& json) {
  geometry::OutlineCorners outline;
  if (!json.expect_array(3, geometry::max_corners)) return outline;
  const std::size_t n = json.size();
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i < n; ++i) corners.push_back(read_vector(json.at(i), max_corner));
  double area = 0.0;
  for (std::size_t i = 0; i < n; ++i) area += cross(corners[i], corners[(i + 1) % n]);
  if (area < 0.0) std::reverse(corners.begin(), corners.end());
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 edge = corners[(i + 1) % n] - corners[i];
    const Vec2 next = corners[(i + 2) % n] - corners[(i + 1) % n];
    if (!(cross(edge, next) > 0.0)) {
      json.complain("the corners must be those of a convex polygon, in their order");
    } else if (!(cross(corners[i], corners[(i + 1) % n]) > 0.0)) {
      json.complain("the centre of mass, [0, 0], is not inside the polygon");
    } else if (cross(corners[i], edge) < min_reach * edge.norm()) {
      json.complain("an edge is nearer to the centre of mass, [0, 0], than 0.005 m");
    }
    outline.x[i] = corners[i].x();
    outline.y[i] = corners[i].y();
  }
  outline.corners = static_cast<int>(n);
  return outline;
}

void read_physics(const JsonReader& json, Parameters& p) {
  if (!json.expect_object({"robot_side", "robot_mass", "wheel_distance", "wheel_radius",
                           "motor_time_constant", "turn_time_constant", "brake_time_constant",
                           "wheel_speed_limit", "grip", "ball_radius", "ball_mass",
                           "rolling_resistance", "viscous_friction", "rolling_friction", "k",
                           "restitution", "contact_friction", "shape"})) {
    return;
  }
  const auto number = [&](const char* key, double& member, double min, double max = max_parameter) {
    if (json.has(key)) member = plain_value(json.at(key)).number(min, max);
  };
  number("robot_side", p.robot_side, 0.02, 2.0);
  number("robot_mass", p.robot_mass, min_parameter);
  number("wheel_distance", p.wheel_distance, min_parameter);
  number("wheel_radius", p.wheel_radius, min_parameter);
  number("motor_time_constant", p.motor_time_constant, min_parameter);
  number("turn_time_constant", p.turn_time_constant, 0.0);
  number("brake_time_constant", p.brake_time_constant, 0.0);
  number("wheel_speed_limit", p.wheel_speed_limit, 0.0);
  if (json.has("grip")) p.grip = read_grip(plain_value(json.at("grip")));
  number("ball_radius", p.ball_radius, 0.002, 0.2);
  number("ball_mass", p.ball_mass, min_parameter);
  number("rolling_resistance", p.rolling_resistance, 0.0, 10.0);
  number("viscous_friction", p.viscous_friction, 0.0);
  json.read_if_present("rolling_friction", p.rolling_friction);
  number("k", p.k, 1e-4);
  if (json.has("restitution")) read_per_pair(json.at("restitution"), 1.0, p.restitution);
  if (json.has("contact_friction")) {
    read_per_pair(json.at("contact_friction"), infinite_grip, p.contact_friction);
  }
  if (json.has("shape")) p.robot_corners = read_outline(json.at("shape"));
}

Json to_json(const Parameters& p) {
  Json json{{"robot_side", p.robot_side},
            {"robot_mass", p.robot_mass},
            {"wheel_distance", p.wheel_distance},
            {"wheel_radius", p.wheel_radius},
            {"motor_time_constant", p.motor_time_constant},
            {"wheel_speed_limit", p.wheel_speed_limit},
            {"grip", p.grip == infinite_grip ? Json("infinite") : Json(p.grip)},
            {"ball_radius", p.ball_radius},
            {"ball_mass", p.ball_mass},
            {"rolling_resistance", p.rolling_resistance},
            {"viscous_friction", p.viscous_friction},
            {"rolling_friction", to_string(p.rolling_friction)},
            {"restitution", to_json(p.restitution)},
            {"contact_friction", to_json(p.contact_friction)}};
  const Parameters plain;
  if (p.turn_time_constant > 0.0) json["turn_time_constant"] = p.turn_time_constant;
  if (p.brake_time_constant > 0.0) json["brake_time_constant"] = p.brake_time_constant;
  if (p.k != plain.k) json["k"] = p.k;
  return json;
}

Json outline_json(const Parameters& p) {
  Json corners = Json::array();
  for (int i = 0; i < p.robot_corners.corners; ++i) {
    corners.push_back({p.robot_corners.x[i], p.robot_corners.y[i]});
  }
  return corners;
}

}  // namespace mirocup::record
