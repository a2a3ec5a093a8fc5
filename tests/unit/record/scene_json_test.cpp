// SPDX-License-Identifier: MIT
#include "record/scene_json.hpp"

#include "tests/support/is_ok.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <vector>

namespace mirocup::record {
namespace {

using nlohmann::ordered_json;

ordered_json good() {
  return ordered_json::parse(R"({
    "schema": "mirocup/scene/1", "league": "middle", "duration": 0.5, "walls": true,
    "parameters": {"grip": "infinite", "k": 0.01, "rolling_friction": "per_axis",
                   "restitution": {"ball_wall": 1}, "contact_friction": {"robot_robot": 0.3},
                   "shape": [[0.03, -0.03], [0.03, 0.03], [-0.03, 0.03], [-0.03, -0.03]]},
    "ball": {"position": [0.2, 0.1], "velocity": [1, 0]},
    "robots": [{"name": "a", "pose": [0, 0, 1.5], "twist": [0.1, 0, 2],
                "wheels": [[0, 1, 2], [0.1, 3, 4]]},
               {"pose": [0.5, 0, 0], "wheels": null}],
    "sample_at": [0.3, 0.1]})");
}

TEST(SceneJson, ReadsEverything) {
  const auto scene = parse_scene(good().dump(), "s.json");
  ASSERT_TRUE(test_support::is_ok(scene));
  EXPECT_EQ(scene->league, RobotLeague::middle);
  EXPECT_EQ(scene->parameters.grip, simulator::infinite_grip);
  EXPECT_EQ(scene->parameters.rolling_friction, simulator::RollingFriction::per_axis);
  EXPECT_EQ(scene->parameters.k, 0.01);
  EXPECT_EQ(scene->parameters.restitution.ball_wall, 1.0);
  EXPECT_EQ(scene->parameters.restitution.ball_robot, 0.6);
  EXPECT_EQ(scene->parameters.contact_friction.robot_robot, 0.3);
  EXPECT_EQ(scene->parameters.robot_corners.corners, 4);
  EXPECT_EQ(scene->robots[0].wheels[1].speeds.right, 4.0);
  EXPECT_EQ(scene->robots[0].state.twist.omega, 2.0);
  EXPECT_EQ(scene->robots[1].name, "robot2");
  EXPECT_FALSE(scene->robots[1].wheels_on_ground);
  EXPECT_EQ(scene->sample_at, (std::vector<double>{0.1, 0.3}));
}

// The vector is neither normalized nor turned into an angle and back.
TEST(SceneJson, TakesAHeadingAsAUnitVectorBitForBit) {
  constexpr double cosine = -0x1.6a96aea0e5e78p-1;
  constexpr double sine = 0x1.697ce75b17af6p-1;
  ordered_json json = good();
  json["robots"][0]["pose"][2] = {cosine, sine};
  const auto scene = parse_scene(json.dump(), "s.json");
  ASSERT_TRUE(test_support::is_ok(scene));
  EXPECT_EQ(scene->robots[0].state.heading.cos, cosine);
  EXPECT_EQ(scene->robots[0].state.heading.sin, sine);
}

TEST(SceneJson, WritesNumbersThatReadBackTheSame) {
  const auto scene = parse_scene(good().dump(), "s.json");
  const auto result =
      simulator::run_scene(*scene, simulator::tolerances_of(simulator::Accuracy::standard));
  const auto json = ordered_json::parse(to_json(*scene, result, 0.5).dump());
  EXPECT_EQ(json["schema"], "mirocup/scene-result/1");
  ASSERT_EQ(json["samples"].size(), 4u);
  const auto& last = json["samples"].back();
  EXPECT_EQ(last["t"], 0.5);
  EXPECT_EQ(last["robots"][0]["name"], "a");
  EXPECT_EQ(last["robots"][0]["pose"][0].get<double>(),
            result.samples.back().robots[0].position.x());
  EXPECT_EQ(last["ball"]["velocity"][0].get<double>(), result.samples.back().ball->velocity.x());
  EXPECT_EQ(json["statistics"]["impacts"], json["impacts"].size());
  EXPECT_EQ(json["statistics"]["cpu_seconds"], 0.5);
}

struct Mistake {
  const char* pointer;  // where it is made
  const char* value;
  const char* named;  // the pointer and the start of the reason that must be named
};

class SceneMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(SceneMistakes, AreNamedWithFilePointerAndReason) {
  ordered_json json = good();
  json[ordered_json::json_pointer(GetParam().pointer)] = ordered_json::parse(GetParam().value);
  const auto scene = parse_scene(json.dump(), "s.json");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, Errc::input);
  EXPECT_EQ(scene.error().what.find(std::string("s.json: ") + GetParam().named), 0u)
      << scene.error().what;
}

INSTANTIATE_TEST_SUITE_P(
    All, SceneMistakes,
    testing::Values(
        Mistake{"/schema", "\"mirocup/scene/2\"", "/schema: \"mirocup/scene/1\""},
        Mistake{"/surprise", "1", "/surprise: there is no such key"},
        Mistake{"/league", "\"huge\"", "/league: one of small, middle, large"},
        Mistake{"/walls", "1", "/walls: true or false"},
        Mistake{"/duration", "-1", "/duration: -1 is not at least 0"},
        Mistake{"/duration", "1e9", "/duration: 1e+09 is not at most 3600"},
        Mistake{"/ball/velocity", "[1e18, 0]", "/ball/velocity/0: 1e+18 is not at most 50"},
        Mistake{"/parameters/grip", "\"none\"", "/parameters/grip: a number or \"infinite\""},
        Mistake{"/parameters/robot_mass", "0", "/parameters/robot_mass: 0 is not at least 1e-09"},
        Mistake{"/parameters/rolling_resistance", "11", "/parameters/rolling_resistance: 11 is"},
        Mistake{"/parameters/robot_side", "2.1", "/parameters/robot_side: 2.1 is not at most 2"},
        Mistake{"/parameters/ball_radius", "1", "/parameters/ball_radius: 1 is not at most 0.2"},
        Mistake{"/parameters/shape", "[[1e-8,1e-8],[-1e-8,1e-8],[-1e-8,-1e-8],[1e-8,-1e-8]]",
                "/parameters/shape: an edge is nearer to the centre of mass"},
        Mistake{"/parameters/wheel_radius", "20",
                "/robots/0/wheels: they drive the robot beyond 50 m/s or turn it beyond 300 rad/s"},
        Mistake{"/robots/0/twist/2", "301", "/robots/0/twist/2: 301 is not at most 300"},
        Mistake{"/robots/0/pose/0", "1001", "/robots/0/pose/0: 1001 is not at most 1000"},
        Mistake{"/parameters/restitution/ball_wall", "1.1",
                "/parameters/restitution/ball_wall: 1.1"},
        Mistake{"/parameters/rolling_friction", "\"no\"", "/parameters/rolling_friction: one of"},
        Mistake{"/parameters/shape", "[[0,0],[1,0],[0,1]]", "/parameters/shape: the centre"},
        Mistake{"/parameters/shape", "[[1,-1],[0,0.1],[-1,-1],[0,1]]",
                "/parameters/shape: the corners"},
        Mistake{"/ball/position", "[5, 0]", "/ball/position: ball lies outside"},
        Mistake{"/ball/position", "[0.02, 0]", "/ball/position: ball and a overlap"},
        Mistake{"/robots/0/pose", "[0, 0]", "/robots/0/pose: 3 values"},
        Mistake{"/robots/0/pose/2", "[1, 2e-6]",
                "/robots/0/pose/2: a heading [cos, sin] must be of length 1 within 1e-12"},
        Mistake{"/robots/0/wheels/0", "[0, 1]", "/robots/0/wheels/0: 3 values"},
        Mistake{"/robots/0/wheels/1/0", "-0.1", "/robots/0/wheels/1/0: -0.1"},
        Mistake{"/robots/1/name", "\"a\"", "/robots/1/name: \"a\" is taken"},
        Mistake{"/sample_at/0", "0.6", "/sample_at/0: 0.6 is not at most 0.5"}));

TEST(SceneJson, NamesMissingKeysAndTextThatIsNotJson) {
  ordered_json json = good();
  json["robots"][0].erase("pose");
  EXPECT_EQ(parse_scene(json.dump(), "s").error().what, "s: /robots/0/pose: missing");
  EXPECT_NE(parse_scene("{\"a\":", "s").error().what.find("s: /: not JSON: "), std::string::npos);
  EXPECT_NE(parse_scene("{\"a\": 1e999}", "s").error().what.find("too large"), std::string::npos);
  EXPECT_FALSE(parse_scene("[]", "s"));
}

// The ends of the ranges of scene.md, of some accuracy levels.
struct Ends {
  std::vector<simulator::Accuracy> levels;
  double speed, turn;  // m/s, rad/s
  std::array<double, 2> radius, side;
};

// Free robots and the ball at these ends: a row that the fastest body hits, or bodies that fly and
// turn as fast as they may.
ordered_json extreme(const Ends& ends, double radius, double side, bool is_row,
                     double restitution) {
  ordered_json json = {
      {"schema", "mirocup/scene/1"}, {"duration", 0.5}, {"walls", side < 0.1 && radius < 0.1}};
  ordered_json& p = json["parameters"];
  p = {{"robot_side", side}, {"ball_radius", radius}};
  for (const char* pair : {"ball_wall", "ball_robot", "robot_wall", "robot_robot"})
    p["restitution"][pair] = restitution;
  json["ball"] = {{"position", {0.0, -1.2 * side - 2.0 * radius}},
                  {"velocity", {ends.speed, ends.speed}}};
  for (int i = 0; i < 6; ++i) {
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    const ordered_json row = {{"pose", {(1.0 + 1e-8) * side * (i - 3) - (i == 0 ? side : 0), 0, 0}},
                              {"twist", {i == 0 ? ends.speed : 0, 0, 0}},
                              {"wheels", nullptr}};
    const ordered_json apart = {{"pose", {1.6 * side * (i - 3), 0, i}},
                                {"twist", {ends.speed * sign, 4 - i, ends.turn * sign}},
                                {"wheels", nullptr}};
    json["robots"].push_back(is_row ? row : apart);
  }
  for (int i = 1; i < 20; ++i) json["sample_at"].push_back(0.025 * i);
  return json;
}

double energy(const simulator::Scene& scene, const simulator::Sample& s) {
  const simulator::Parameters& p = scene.parameters;
  double sum = 0.5 * p.effective_ball_mass() * s.ball->velocity.squaredNorm();
  for (const simulator::BodyState& r : s.robots)
    sum += 0.5 * p.robot_mass * r.velocity().squaredNorm() +
           0.5 * p.robot_inertia() * r.twist.omega * r.twist.omega;
  return sum;
}

void expect_to_hold(const simulator::Scene& scene, simulator::Accuracy level) {
  const bool is_coarse = level == simulator::Accuracy::coarse;
  const auto result = simulator::run_scene(scene, simulator::tolerances_of(level));
  EXPECT_FALSE(result.stopped_at);
  EXPECT_LE(result.statistics.deepest_overlap, is_coarse ? 1e-6 : 1e-9);
  const auto field = field::make_field(scene.league);
  double last = energy(scene, result.samples.front()) * (1.0 + 1e-9);
  for (const simulator::Sample& s : result.samples) {
    EXPECT_LE(energy(scene, s), last);
    if (!is_coarse) last = energy(scene, s) * (1.0 + 1e-9);
    for (const simulator::BodyState& r : s.robots)
      EXPECT_TRUE(!scene.has_walls || field.clearance(r.position) > 0.0);
  }
}

// Catches ranges in which bodies pass through each other or the walls, or gain energy. In a wider
// range they do: with the ball ten times as large as a robot at `coarse`, in crowds at 200 m/s at
// `standard`.
TEST(SceneJson, RangesHoldAtBothEnds) {
  using simulator::Accuracy;
  const Ends coarse{{Accuracy::coarse}, 5.0, 100.0, {0.01, 0.022}, {0.07, 2.0}};
  const Ends exact{
      {Accuracy::standard, Accuracy::reference}, 50.0, 300.0, {0.002, 0.2}, {0.05, 2.0}};
  for (const Ends& ends : {coarse, exact}) {
    for (int draw = 0; draw < 24; ++draw) {
      const double radius = ends.radius[draw % 2], side = ends.side[draw / 2 % 2];
      const bool is_row = draw / 4 % 2 == 0;
      const double restitution = 0.5 * (draw / 8);
      const auto scene =
          parse_scene(extreme(ends, radius, side, is_row, restitution).dump(), "s.json");
      ASSERT_TRUE(test_support::is_ok(scene));
      for (const Accuracy level : ends.levels) {
        SCOPED_TRACE(testing::Message() << radius << " " << side << " " << is_row << " "
                                        << restitution << " " << to_string(level));
        expect_to_hold(*scene, level);
      }
    }
  }
}

// Catches a result that takes all memory.
TEST(SceneJson, BoundsTheStatesOfAllSamples) {
  ordered_json json = good();
  json["sample_at"] = ordered_json::array();
  for (int i = 0; i < 90'000; ++i) json["sample_at"].push_back(0.25);
  const auto scene = parse_scene(json.dump(), "s.json");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().what, "s.json: /sample_at: 0 to 83333 values are expected, not 90000");
}

}  // namespace
}  // namespace mirocup::record
