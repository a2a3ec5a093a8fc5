// SPDX-License-Identifier: MIT
#include "mirocup/training.h"

#include "core/replay/verification.hpp"
#include "labs/tests/unit/training/batch_of_matches.hpp"
#include "record/match_record.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <set>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace mirocup::training {
namespace {

using nlohmann::json;
using test_support::TemporaryFolder;

json range(double from, double to) {
  return {{"from", from}, {"to", to}};
}

// The ball and a robot of blue lie anywhere on the right half.
json anywhere() {
  const json place = {range(0.1, 0.6), range(-0.5, 0.5)};
  return {{"schema", "mirocup/situation/1"},
          {"ball", {{"position", place}}},
          {"blue", {{{"pose", {place[0], place[1], range(-3.0, 3.0)}}}}}};
}

// Configurations that between them use every part.
const std::map<std::string, json>& kinds() {
  static const std::map<std::string, json> all{
      {"both_teams", {{"yellow", "agent"}, {"autoreset", "same_step"}}},
      {"house_team", {{"yellow", "chaser"}, {"conditions", "camera"}, {"autoreset", "same_step"}}},
      {"robots",
       {{"agents", "robot"},
        {"blue", {{"learners", {0, 2}}, {"mates", "keeper"}}},
        {"yellow", "noise"},
        {"action", "drive"},
        {"ticks_per_step", 3}}},
      {"vss",
       {{"observation", "vss"},
        {"action", "vss"},
        {"blue", {{"learners", {0}}, {"mates", "noise"}}},
        {"yellow", "noise"},
        {"referee", "goals"},
        {"conditions", "exact"},
        {"control_period", 0.025}}},
      {"whole_legs",
       {{"yellow", "striker"},
        {"rules", {{"preset", "mirosot"}, {"half_s", 0.6}}},
        {"episode", {{"seconds", nullptr}, {"ends_at_goal", false}}},
        {"skip_stops", false},
        {"autoreset", "same_step"}}},
      {"starts",
       {{"agents", "robot"},
        {"observation", "relative"},
        {"yellow", "keeper"},
        {"autoreset", "same_step"},
        {"start", {"shoot-open-goal", anywhere(), {{"restart", {{"kind", "FREE_KICK"}}}}}}}},
      {"pitch",
       {{"yellow", "agent"},
        {"autoreset", "same_step"},
        {"pitch", {{"ball_mass", range(0.03, 0.06)}, {"restitution", {{"ball_wall", 0.5}}}}}}},
      {"middle", {{"league", "middle"}, {"yellow", "chaser"}, {"rules", "simurosot"}}}};
  return all;
}

json kind(const std::string& name, int matches, int threads) {
  json configuration = kinds().at(name);
  configuration["matches"] = matches;
  configuration["threads"] = threads;
  if (!configuration.contains("episode")) configuration["episode"] = {{"seconds", 2.0}};
  return configuration;
}

// The fingerprints of each match after each step.
std::vector<std::vector<std::uint64_t>> played(const json& configuration, std::uint64_t first,
                                               int steps) {
  BatchOfMatches batch(configuration);
  EXPECT_EQ(batch.reset(first), 0) << mirocup_training_error(batch.get());
  std::vector<std::vector<std::uint64_t>> all(static_cast<std::size_t>(batch.size.matches));
  for (int step = 0; step < steps; ++step) {
    EXPECT_EQ(batch.step(first, step), 0) << mirocup_training_error(batch.get());
    for (int i = 0; i < batch.size.matches; ++i) {
      all[static_cast<std::size_t>(i)].push_back(batch.hash(i));
    }
  }
  return all;
}

// Catches a result that depends on which thread plays a match, or on what else is in its batch.
TEST(Training, AMatchIsTheSameWithAnyThreadsAndNeighbours) {
  for (const auto& [name, ignored] : kinds()) {
    constexpr int matches = 9, steps = 90;
    const auto one = played(kind(name, matches, 1), 100, steps);
    EXPECT_EQ(one, played(kind(name, matches, 2), 100, steps)) << name;
    EXPECT_EQ(one, played(kind(name, matches, 8), 100, steps)) << name;
    for (const int alone : {0, 5}) {
      const auto seed = 100 + static_cast<std::uint64_t>(alone);
      EXPECT_EQ(one[static_cast<std::size_t>(alone)], played(kind(name, 1, 1), seed, steps)[0])
          << name << ", match " << alone;
    }
  }
}

// Catches episodes whose records claim what was not played: commands that are left out, placements,
// a world that kept something of another match. MIROCUP_TRAINING_EPISODES=100: as many.
TEST(Training, EpisodesWrittenAsRecordsVerify) {
  const char* wanted = std::getenv("MIROCUP_TRAINING_EPISODES");
  const int most = wanted == nullptr ? 20 : std::atoi(wanted);
  const TemporaryFolder folder;
  system::Disk disk;
  int verified = 0;
  std::map<std::string, int> ends;
  for (std::uint64_t seed = 1; verified < most; seed += 10) {
    for (const auto& [name, ignored] : kinds()) {
      BatchOfMatches batch(kind(name, 3, 1));
      ASSERT_EQ(batch.reset(seed), 0);
      for (int step = 0; step < 70; ++step) ASSERT_EQ(batch.step(seed, step), 0);
      const std::string path = folder / (name + ".json");
      for (const auto episode : {MIROCUP_TRAINING_CURRENT_EPISODE, MIROCUP_TRAINING_LAST_EPISODE}) {
        if (verified == most) break;
        if (mirocup_training_record(batch.get(), 1, episode, path.c_str()) != 0) continue;
        const auto record = record::load(disk, path);
        ASSERT_TRUE(test_support::is_ok(record));
        const auto difference = replay::verify(record->recording);
        EXPECT_FALSE(difference) << name << " " << seed << ": " << difference->what;
        EXPECT_GT(record->recording.ticks.size(), 0U);
        ++ends[std::string(to_string(record->recording.outcome.kind))];
        ++verified;
      }
    }
  }
  EXPECT_EQ(verified, most);
  EXPECT_GT(ends["void"], 0) << "episodes that were cut";
  EXPECT_GT(ends.size(), 1U) << "episodes that ended";
}

// Catches starts that are not drawn, that all episodes share, or that do not keep to their ranges.
TEST(Training, EpisodesStartWhereTheyAreTold) {
  json configuration = kind("starts", 50, 1);
  configuration["start"] = anywhere();
  BatchOfMatches batch(configuration);
  ASSERT_EQ(batch.reset(1), 0);
  std::set<double> places;
  for (int match = 0; match < 50; ++match) {
    double bodies[7 * 6];
    ASSERT_EQ(mirocup_training_bodies(batch.get(), match, bodies), 0);
    const double* ball = bodies + std::ptrdiff_t{6 * 6};
    places.insert(ball[0]);
    for (const double* body : {static_cast<const double*>(bodies), ball}) {
      EXPECT_GE(body[0], 0.1);
      EXPECT_LE(body[0], 0.6);
      EXPECT_LE(std::abs(body[1]), 0.5);
    }
  }
  EXPECT_EQ(places.size(), 50U);
  configuration["start"] = "shoot-open-goal";
  BatchOfMatches drill(configuration);
  ASSERT_EQ(drill.reset(1), 0);
  double bodies[7 * 6];
  ASSERT_EQ(mirocup_training_bodies(drill.get(), 7, bodies), 0);
  EXPECT_EQ(bodies[0], -0.7) << "its keeper";
}

// Catches a pitch that the physics does not have, or that all episodes share.
TEST(Training, APitchIsDrawnForEachEpisode) {
  const auto after = [](const json& pitch, int match) {
    json configuration{{"matches", 2}, {"conditions", "exact"}, {"start", anywhere()}};
    configuration["start"]["ball"]["velocity"] = {1.0, 0.3};
    if (!pitch.is_null()) configuration["pitch"] = pitch;
    BatchOfMatches batch(configuration);
    const std::vector<std::uint64_t> seeds{5, 5};
    EXPECT_EQ(mirocup_training_reset(batch.get(), nullptr, seeds.data()), 0);
    for (int step = 0; step < 15; ++step) EXPECT_EQ(mirocup_training_step(batch.get()), 0);
    double bodies[7 * 6];
    EXPECT_EQ(mirocup_training_bodies(batch.get(), match, bodies), 0);
    return bodies[6 * 6];
  };
  const double usual = after(nullptr, 0);
  EXPECT_EQ(usual, after({{"viscous_friction", 0.01}}, 0));
  EXPECT_NE(usual, after({{"viscous_friction", 0.05}}, 0));
  const double drawn = after({{"viscous_friction", range(0.02, 0.06)}}, 0);
  EXPECT_NE(usual, drawn);
  EXPECT_EQ(drawn, after({{"viscous_friction", range(0.02, 0.06)}}, 1)) << "the same seed";
}

// Catches a record that is not on the pitch of its episode: a drawn number that it does not hold,
// or the usual one instead.
TEST(Training, EpisodesOnDrawnPitchesVerify) {
  const json numbers{{"wheel_radius", range(0.02, 0.025)},
                     {"motor_time_constant", range(0.04, 0.15)},
                     {"turn_time_constant", range(0.03, 0.1)},
                     {"brake_time_constant", range(0.01, 0.05)},
                     {"grip", range(0.5, 1.0)},
                     {"ball_mass", range(0.03, 0.06)},
                     {"rolling_resistance", range(0.005, 0.04)},
                     {"restitution", {{"ball_wall", range(0.4, 0.9)}, {"robot_wall", 0.2}}}};
  json configuration = kind("both_teams", 20, 1);
  configuration["pitch"] = numbers;
  BatchOfMatches batch(configuration);
  ASSERT_EQ(batch.reset(1), 0) << mirocup_training_error(batch.get());
  for (int step = 0; step < 60; ++step) ASSERT_EQ(batch.step(1, step), 0);
  const TemporaryFolder folder;
  system::Disk disk;
  const std::string path = folder / "episode.json";
  std::set<double> radii, masses;
  for (int match = 0; match < 20; ++match) {
    ASSERT_EQ(
        mirocup_training_record(batch.get(), match, MIROCUP_TRAINING_CURRENT_EPISODE, path.c_str()),
        0)
        << mirocup_training_error(batch.get());
    const auto record = record::load(disk, path);
    ASSERT_TRUE(test_support::is_ok(record));
    const auto difference = replay::verify(record->recording);
    EXPECT_FALSE(difference) << match << ": " << difference->what;
    EXPECT_EQ(record->recording.setup.pitch_name, "drawn");
    const simulator::Parameters& p = record->recording.setup.parameters;
    radii.insert(p.wheel_radius);
    masses.insert(p.ball_mass);
    EXPECT_GE(p.brake_time_constant, 0.01);
    EXPECT_LE(p.brake_time_constant, 0.05);
    EXPECT_EQ(p.restitution.robot_wall, 0.2);
  }
  EXPECT_EQ(radii.size(), 20U);
  EXPECT_EQ(masses.size(), 20U);
}

// Catches a record of a pitch with a name that is not on it, and one that nothing could read again.
TEST(Training, RecordsNameTheirPitch) {
  const TemporaryFolder folder;
  const std::string path = folder / "episode.json";
  system::Disk disk;
  json configuration = kind("both_teams", 1, 1);
  configuration["pitch"] = "vsss";
  BatchOfMatches named(configuration);
  ASSERT_EQ(named.reset(1), 0);
  for (int step = 0; step < 30; ++step) ASSERT_EQ(named.step(1, step), 0);
  ASSERT_EQ(mirocup_training_record(named.get(), 0, MIROCUP_TRAINING_CURRENT_EPISODE, path.c_str()),
            0);
  const auto record = record::load(disk, path);
  ASSERT_TRUE(test_support::is_ok(record));
  EXPECT_EQ(record->recording.setup.pitch_name, "vsss");
  EXPECT_EQ(record->recording.setup.parameters.robot_mass, 2.4);
  EXPECT_FALSE(replay::verify(record->recording));
  configuration["pitch"] = {{"wheel_distance", 0.3}};
  BatchOfMatches impossible(configuration);
  ASSERT_EQ(impossible.reset(1), 0);
  EXPECT_EQ(
      mirocup_training_record(impossible.get(), 0, MIROCUP_TRAINING_CURRENT_EPISODE, path.c_str()),
      2);
  const std::string why = mirocup_training_error(impossible.get());
  EXPECT_NE(why.find("wheel_distance is 0.3"), std::string::npos) << why;
}

// Catches a state that is not saved, or that saving disturbs.
TEST(Training, SaveAndRestoreChangeNothing) {
  for (const auto& [name, ignored] : kinds()) {
    const json configuration = kind(name, 2, 1);
    const auto undisturbed = played(configuration, 7, 80);
    BatchOfMatches batch(configuration), other(configuration);
    ASSERT_EQ(batch.reset(7), 0);
    ASSERT_EQ(other.reset(1000), 0);
    for (int step = 0; step < 40; ++step) ASSERT_EQ(batch.step(7, step), 0);
    const std::string first = batch.save(0), second = batch.save(1);
    EXPECT_EQ(batch.hash(1), undisturbed[1][39]) << name;
    for (int step = 40; step < 80; ++step) ASSERT_EQ(batch.step(7, step), 0);
    EXPECT_EQ(batch.hash(1), undisturbed[1].back()) << name << ", after it was saved";
    ASSERT_EQ(mirocup_training_restore(batch.get(), 1, second.data(), second.size()), 0);
    ASSERT_EQ(mirocup_training_restore(other.get(), 0, first.data(), first.size()), 0);
    ASSERT_EQ(mirocup_training_restore(other.get(), 1, second.data(), second.size()), 0);
    for (int step = 40; step < 80; ++step) {
      ASSERT_EQ(batch.step(7, step), 0);
      ASSERT_EQ(other.step(7, step), 0);
    }
    EXPECT_EQ(other.hash(0), undisturbed[0].back()) << name << ", in another batch";
    EXPECT_EQ(other.hash(1), undisturbed[1].back()) << name << ", in another batch";
    EXPECT_EQ(batch.hash(1), undisturbed[1].back()) << name << ", restored";
  }
}

// Catches a copy that is taken for that of another configuration, or cut.
TEST(Training, ForeignAndCutCopiesAreRefused) {
  BatchOfMatches batch(kind("both_teams", 1, 1)), other(kind("vss", 1, 1));
  ASSERT_EQ(batch.reset(1), 0);
  ASSERT_EQ(other.reset(1), 0);
  ASSERT_EQ(batch.step(1, 0), 0);
  const std::string copy = batch.save(0);
  EXPECT_EQ(mirocup_training_restore(other.get(), 0, copy.data(), copy.size()), 4);
  EXPECT_EQ(mirocup_training_restore(batch.get(), 0, copy.data(), copy.size() - 1), 4);
  EXPECT_EQ(mirocup_training_restore(batch.get(), 0, copy.data(), 3), 4);
  const std::uint64_t before = batch.hash(0);
  ASSERT_EQ(batch.step(1, 1), 0) << "the match goes on after a refused copy";
  EXPECT_NE(batch.hash(0), before);
}

#if defined(__SSE2__)
// Catches bits that depend on the floating-point mode of the caller: a library that was built with
// -Ofast switches denormal numbers off in the thread that loads it.
TEST(Training, TheCallersFloatingPointModeDoesNotMatter) {
  const json configuration = kind("house_team", 2, 1);
  BatchOfMatches plain(configuration), flushed(configuration);
  ASSERT_EQ(plain.reset(3), 0);
  ASSERT_EQ(flushed.reset(3), 0);
  const unsigned mode = _mm_getcsr();
  bool was_kept = true;
  for (int step = 0; step < 60; ++step) {
    ASSERT_EQ(plain.step(3, step), 0);
    flushed.actions = plain.actions;
    _mm_setcsr((mode & ~0x6000U) | 0xc040U);  // denormals are zero, rounding upwards
    mirocup_training_step(flushed.get());
    was_kept = was_kept && (_mm_getcsr() & 0xe040U) == 0xc040U;
    _mm_setcsr(mode);
    ASSERT_EQ(plain.hash(0), flushed.hash(0)) << step;
    ASSERT_EQ(plain.hash(1), flushed.hash(1)) << step;
  }
  EXPECT_TRUE(was_kept) << "the caller's mode is the caller's";
}
#endif

int column(BatchOfMatches& batch, const std::string& list, const std::string& name) {
  const json spec = json::parse(mirocup_training_spec(batch.get()));
  int i = 0;
  for (const json& entry : spec[list]) {
    if ((entry.is_string() ? entry : entry["name"]) == name) return i;
    ++i;
  }
  throw std::runtime_error("no " + name);
}

// Catches a term that is measured in the wrong frame, for the wrong team, or across a placement.
TEST(Training, TermsSayWhatTheirNamesSay) {
  json configuration = kind("both_teams", 40, 1);
  configuration["autoreset"] = "next_step";
  configuration["episode"] = {{"seconds", 20.0}};
  configuration["yellow"] = "chaser";
  configuration["rewards"] = {{"goal", 2.0}, {"ball_to_goal", 3.0}, {"time", 0.5}};
  BatchOfMatches batch(configuration);
  ASSERT_EQ(batch.reset(1), 0);
  const json spec = json::parse(mirocup_training_spec(batch.get()));
  const int x = column(batch, "observation", "ball_x"), y = x + 1;
  const double metre = spec["observation"][0]["scale"].get<double>();
  const double half_length = spec["field"]["half_length"].get<double>();
  const int goal = column(batch, "rewards", "goal");
  const int ball_to_goal = column(batch, "rewards", "ball_to_goal");
  const int time = column(batch, "rewards", "time");
  const auto at = [&](const std::vector<float>& values, int row, int width, int k) {
    return static_cast<double>(values[static_cast<std::size_t>(row * width + k)]);
  };
  const auto distance = [&](int row) {
    const double bx = metre * at(batch.observations, row, batch.size.observation, x);
    const double by = metre * at(batch.observations, row, batch.size.observation, y);
    return std::hypot(half_length - bx, by);
  };
  int compared = 0, goals = 0;
  std::vector<double> before(40), sums(40);
  std::vector<char> is_new(40, 1);
  for (int step = 0; step < 600; ++step) {
    for (int i = 0; i < 40; ++i) before[static_cast<std::size_t>(i)] = distance(i);
    ASSERT_EQ(batch.step(1, step), 0);
    for (int i = 0; i < 40; ++i) {
      const auto row = static_cast<std::size_t>(i);
      if (std::exchange(is_new[row], batch.terminations[row] | batch.truncations[row])) {
        if (step > 0) {
          EXPECT_EQ(batch.rewards[row], 0.0F) << "the step that starts an episode";
          sums[row] = 0.0;
          continue;
        }
      }
      const double way = at(batch.terms, i, batch.size.terms, ball_to_goal);
      const double scored = at(batch.terms, i, batch.size.terms, goal);
      const double seconds = at(batch.terms, i, batch.size.terms, time);
      EXPECT_NEAR(batch.rewards[row], 2.0 * scored + 3.0 * way + 0.5 * seconds, 1e-5);
      sums[row] += batch.rewards[row];
      if (std::abs(seconds + 0.033) < 1e-6) {  // no restart in this step
        EXPECT_NEAR(way, before[row] - distance(i), 1e-5);
        ++compared;
      }
      if (batch.terminations[row]) {
        EXPECT_EQ(std::abs(scored), 1.0);
        ++goals;
      }
      if (batch.terminations[row] || batch.truncations[row]) {
        const auto count = [&](const std::string& name) {
          return at(batch.statistics, i, batch.size.statistics, column(batch, "statistics", name));
        };
        EXPECT_NEAR(count("return"), sums[row], 1e-3);
        EXPECT_EQ(count("score") - count("opponent_score"), count("goal"));
        EXPECT_GE(count("score"), 0.0);
        EXPECT_LE(count("score") + count("opponent_score"), 1.0);
      }
    }
  }
  EXPECT_GT(compared, 10000);
  EXPECT_GT(goals, 5) << "chaser scores against random robots";
}

// Catches a place behind the ball that is on its wrong side or at another distance than that of a
// robot which touches it, a direction of another body, and a reward for another way.
TEST(Training, TheWayBehindTheBallIsSeenAndRewarded) {
  json configuration = kind("starts", 8, 1);
  configuration["blue"] = {{"learners", {0}}};
  configuration["start"] = anywhere();
  configuration["episode"] = {{"seconds", 30.0}};
  BatchOfMatches batch(configuration);
  ASSERT_EQ(batch.reset(1), 0);
  const json spec = json::parse(mirocup_training_spec(batch.get()));
  const double metre = spec["observation"][0]["scale"].get<double>();
  const double half_length = spec["field"]["half_length"].get<double>();
  const double gap =
      double(spec["bodies"]["robot_side"]) / 2.0 + double(spec["bodies"]["ball_radius"]);
  const int term = column(batch, "rewards", "behind_ball");
  std::map<std::string, int> columns;
  for (const json& quantity : spec["observation"]) {
    columns.emplace(quantity["name"], static_cast<int>(columns.size()));
  }
  const auto seen = [&](int row, const char* name) {
    const int at = row * batch.size.observation + columns.at(name);
    return static_cast<double>(batch.observations[static_cast<std::size_t>(at)]);
  };
  // From the robot, in the frame of the field, m.
  const auto to_behind = [&](int row) {
    const double x = metre * seen(row, "ball_field_x"), y = metre * seen(row, "ball_field_y");
    const double shot = std::hypot(half_length - x, y);
    EXPECT_NEAR(metre * seen(row, "shot_length"), shot, 1e-5);
    return Vec2{x - gap * (half_length - x) / shot - metre * seen(row, "self_field_x"),
                y + gap * y / shot - metre * seen(row, "self_field_y")};
  };
  std::vector<double> before(8);
  for (int step = 0; step < 60; ++step) {
    for (int i = 0; i < 8; ++i) before[static_cast<std::size_t>(i)] = to_behind(i).norm();
    ASSERT_EQ(batch.step(1, step), 0);
    for (int i = 0; i < 8; ++i) {
      if (batch.terminations[static_cast<std::size_t>(i)] != 0) continue;
      const Vec2 way = to_behind(i);
      const double c = seen(i, "self_field_cos"), s = seen(i, "self_field_sin");
      EXPECT_NEAR(seen(i, "behind_direction_cos"), (c * way.x() + s * way.y()) / way.norm(), 1e-3);
      EXPECT_NEAR(seen(i, "behind_direction_sin"), (c * way.y() - s * way.x()) / way.norm(), 1e-3);
      EXPECT_NEAR(seen(i, "behind_near"), 0.1 / (0.1 + way.norm()), 1e-4);
      EXPECT_NEAR(batch.terms[static_cast<std::size_t>(i * batch.size.terms + term)],
                  before[static_cast<std::size_t>(i)] - way.norm(), 1e-5);
    }
  }
}

// Catches ends that are told wrong: a goal that truncates, an end that is told twice, an
// observation of the old episode where the new one is due.
TEST(Training, AutoresetModesAreThoseOfGymnasium) {
  json configuration = kind("both_teams", 1, 1);
  configuration["episode"] = {{"seconds", 0.33}};  // 10 steps
  std::map<std::string, std::vector<float>> first, after_end, final_observation;
  for (const std::string mode : {"next_step", "same_step", "disabled"}) {
    configuration["autoreset"] = mode;
    BatchOfMatches batch(configuration);
    ASSERT_EQ(batch.reset(5), 0);
    first[mode] = batch.observations;
    for (int step = 0; step < 10; ++step) {
      ASSERT_EQ(batch.step(5, step), 0);
      EXPECT_EQ(batch.truncations[0], step == 9) << mode << " " << step;
      EXPECT_EQ(batch.terminations[0], 0);
    }
    after_end[mode] = batch.observations;
    final_observation[mode] = batch.final_observations;
    ASSERT_EQ(batch.step(5, 10), 0);
    if (mode == "next_step") {
      EXPECT_EQ(batch.truncations[0], 0);
      EXPECT_EQ(batch.observations, after_end["next_step"] = batch.observations);
      EXPECT_EQ(batch.rewards, std::vector<float>(2, 0.0F));
      after_end[mode] = batch.observations;  // the first one of the second episode
    } else if (mode == "disabled") {
      EXPECT_EQ(batch.observations, after_end[mode]) << "it stays as it is";
      EXPECT_EQ(batch.truncations[0], 1);
      const std::uint8_t mask = 1;
      ASSERT_EQ(mirocup_training_reset(batch.get(), &mask, nullptr), 0);
      EXPECT_EQ(batch.truncations[0], 0);
      final_observation[mode] = after_end[mode];
      after_end[mode] = batch.observations;
    }
  }
  EXPECT_EQ(first["next_step"], first["same_step"]);
  EXPECT_EQ(after_end["next_step"], after_end["same_step"]) << "the second episode's first";
  EXPECT_EQ(after_end["next_step"], after_end["disabled"]);
  EXPECT_EQ(final_observation["same_step"], final_observation["disabled"]);
  EXPECT_NE(first["next_step"], after_end["next_step"]) << "another seed";
}

// Catches a slip in a configuration that is taken silently, and a crash where a sentence is due.
// Catches a library that reads behind the structure of a program with an older header, and one that
// takes a structure whose size nobody has set.
TEST(Training, BuffersEndWhereTheirSizeSays) {
  const json configuration{{"matches", 1}};
  BatchOfMatches batch(configuration);
  std::vector<float> observations(batch.observations.size(), -1.0F);
  std::vector<float> rewards(batch.rewards.size(), -1.0F);
  mirocup_training_buffers buffers{};
  buffers.size = offsetof(mirocup_training_buffers, rewards);
  buffers.observations = observations.data();
  buffers.rewards = rewards.data();
  ASSERT_EQ(mirocup_training_bind(batch.get(), &buffers), 0);
  ASSERT_EQ(batch.reset(1), 0);
  EXPECT_NE(observations[0], -1.0F);
  EXPECT_EQ(rewards[0], -1.0F);
  buffers.size = 0;
  EXPECT_EQ(mirocup_training_bind(batch.get(), &buffers), 2);
  EXPECT_NE(std::string(mirocup_training_error(batch.get())).find("sizeof"), std::string::npos);
}

TEST(Training, RefusesWhatItDoesNotUnderstand) {
  const std::pair<json, std::string> cases[] = {
      {{{"matchs", 3}}, "/matchs"},
      {{{"matches", 0}}, "/matches"},
      {{{"yellow", "nobody"}}, "/yellow"},
      {{{"blue", "chaser"}}, "no robot learns"},
      {{{"blue", {{"learners", {0, 0}}}}}, "twice"},
      {{{"blue", {{"learners", {3}}}}}, "/blue/learners/0"},
      {{{"rewards", {{"goals", 1.0}}}}, "/rewards/goals"},
      {{{"conditions", "rain"}}, "/conditions"},
      {{{"rules", {{"preset", "mirosot"}, {"half", 1}}}}, "/rules/half"},
      {{{"autoreset", "never"}}, "next_step"},
      {{{"blue", {{"learners", {0}}}}, {"yellow", "agent"}}, "different numbers"},
      {{{"referee", "none"}}, "/referee"},
      {{{"observation", "relative"}}, "relative"},
      {{{"start", "no-such-drill"}}, "/start"},
      {{{"start", {{"bal", 1}}}}, "/bal"},
      {{{"start", {{"schema", "mirocup/drill/1"}, {"league", "small"}, {"situation", 5}}}},
       "no such key"},
      {{{"start", {{"score", {1, 0}}}}}, "level"},
      {{{"start", {{"ball", {{"position", {9, 9}}}}}}}, "outside"},
      {{{"pitch", {{"ball_mas", 1}}}}, "/ball_mas"},
      {{{"pitch", {{"ball_mass", range(-1.0, 1.0)}}}}, "/ball_mass"}};
  for (const auto& [configuration, part] : cases) {
    char error[500] = "";
    EXPECT_EQ(mirocup_training_create(configuration.dump().c_str(), error, sizeof error), nullptr);
    EXPECT_NE(std::string(error).find(part), std::string::npos) << configuration << ": " << error;
  }
  char error[500] = "";
  EXPECT_EQ(mirocup_training_create("{", error, sizeof error), nullptr);
  EXPECT_EQ(mirocup_training_create("{", nullptr, 0), nullptr);
  BatchOfMatches batch(json{{"matches", 2}});
  EXPECT_EQ(mirocup_training_step(batch.get()), 2) << "before the first reset";
  EXPECT_EQ(mirocup_training_record(batch.get(), 9, MIROCUP_TRAINING_LAST_EPISODE, "/tmp/x.json"),
            2);
  ASSERT_EQ(batch.reset(1), 0);
  EXPECT_EQ(mirocup_training_record(batch.get(), 0, MIROCUP_TRAINING_LAST_EPISODE, "/tmp/x.json"),
            2);
  EXPECT_EQ(
      mirocup_training_record(batch.get(), 0, MIROCUP_TRAINING_CURRENT_EPISODE, "/nowhere/x.json"),
      3);
}

// Catches numbers from outside that get into the physics, or into the rewards.
TEST(Training, ActionsMayBeAnything) {
  BatchOfMatches batch(kind("both_teams", 1, 1));
  ASSERT_EQ(batch.reset(1), 0);
  for (const float wild : {std::nanf(""), HUGE_VALF, -HUGE_VALF, 1e30F}) {
    std::fill(batch.actions.begin(), batch.actions.end(), wild);
    for (int i = 0; i < 20; ++i) ASSERT_EQ(mirocup_training_step(batch.get()), 0);
    for (const float o : batch.observations) EXPECT_LE(std::abs(o), 5.0F);
    for (const float r : batch.rewards) EXPECT_TRUE(std::isfinite(r)) << wild;
    for (const float t : batch.terms) EXPECT_TRUE(std::isfinite(t)) << wild;
  }
}

}  // namespace
}  // namespace mirocup::training
