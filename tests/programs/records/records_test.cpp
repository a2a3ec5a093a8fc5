// SPDX-License-Identifier: MIT
//
// Record files of every ending, a sample, and records of other physics. Catches a record that its
// schema does not describe, a reader that no longer reads the sample, and a record that is reported
// as wrong only because physics or laws have changed since.
#include "core/replay/verification.hpp"
#include "record/kept_module.hpp"
#include "record/match_record.hpp"
#include "system/locations.hpp"
#include "tests/build/compilers/flat_recording.hpp"
#include "tests/programs/records/endings.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace mirocup {
namespace {

using namespace test_support;

const std::string source = MIROCUP_SOURCE_FOLDER;

// Returns a record with every key that the schema knows.
record::MatchRecord record_of(replay::Recording recording) {
  record::MatchRecord record;
  record.software = record::this_software();
  record.teams = {record::TeamInfo{"hunters", record::TeamKind::plugin, std::string(64, 'a')},
                  record::TeamInfo{"others <b>", record::TeamKind::dds, std::nullopt}};
  record.isolation = "network";
  record::NetworkReport network;
  network.absences = {{.tick = 1, .noticed = 2, .back = std::nullopt, .has_left = true},
                      {.tick = 5, .noticed = 6, .back = 7U, .has_left = false}};
  network.answers.add(0.004);
  record.network[1] = network;
  record.pace = record::PaceReport{0.033, {}};
  record.pace->lateness.add(0.0002);
  record.recording = std::move(recording);
  return record;
}

Outcome verify(const std::string& path) {
  return run_mirocup({"verify", path});
}

// Expects the schema to be valid, and the records to fit it.
void expect_valid(const std::vector<std::string>& records) {
  std::vector<std::string> words{source + "/tests/programs/records/schema.py",
                                 source + "/record/record.schema.json"};
  words.insert(words.end(), records.begin(), records.end());
  expect_exit(0, run(words));
}

TEST(Records, FitTheSchemaAndVerifyForEveryEnding) {
  const TemporaryFolder folder;
  system::Disk disk;
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < enum_names<match::OutcomeKind>.size(); ++i) {
    const auto end = static_cast<match::OutcomeKind>(i);
    paths.push_back(folder / (std::string(to_string(end)) + ".json"));
    const record::MatchRecord record = record_of(leg_that_ends(end));
    ASSERT_EQ(record.recording.outcome.kind, end) << to_string(end);
    ASSERT_TRUE(record::save(disk, paths.back(), record));
    const Outcome verified = verify(paths.back());
    EXPECT_EQ(verified.exit_code, 0) << paths.back() << verified.out << verified.err;
  }
  expect_valid(paths);
}

// Catches an example that an editor calls wrong, and a key that only files.schema.json or only its
// reader has.
TEST(Records, FilesThatPeopleWriteFitTheirSchema) {
  std::vector<std::string> words{source + "/tests/programs/records/schema.py"};
  for (const char* file :
       {"record/files.schema.json", "tournaments/format/league_file.cpp", "record/drills/drill.cpp",
        "record/drills/sheet.cpp", "record/pitch_json.cpp", "record/parameters_json.cpp",
        "record/situation_json.cpp", "docs/hosting-file.md", "docs/drills.md", "docs/exercises.md",
        "docs/pitches.md"})
    words.push_back(source + "/" + file);
  for (const char* folder : {"/plugins/drills", "/examples/course", "/tournaments/examples"}) {
    for (const auto& file : std::filesystem::recursive_directory_iterator(source + folder))
      if (file.path().extension() == ".json") words.push_back(file.path());
  }
  const Outcome outcome = expect_exit(0, run(words));
  EXPECT_GE(std::atoi(outcome.out.c_str()), 34) << outcome.out;
}

// Catches a key that schema.md or record.schema.json does not describe, one that they describe but
// no record has.
TEST(Records, HaveTheKeysThatTheirDocumentationDescribes) {
  const TemporaryFolder folder;
  system::Disk disk;
  std::vector<std::string> words{source + "/tests/programs/records/documented.py",
                                 source + "/record/record.schema.json",
                                 source + "/record/schema.md", source + "/docs/laws.md"};
  for (const auto end : {match::OutcomeKind::shoot_out, match::OutcomeKind::forfeit}) {
    words.push_back(folder / (std::string(to_string(end)) + ".json"));
    record::MatchRecord record = record_of(leg_that_ends(end));
    // Teams on the network and goals have keys of their own.
    record.network[0].emplace().datagrams.emplace();
    record.recording.decisions.front().credit = {.scorer = match::Touch{Team::blue, 1},
                                                 .assist = match::Touch{Team::blue, 2}};
    record.recording.decisions.front().score = match::ByTeam<int>{1, 0};
    match::Start& start = record.recording.setup.start.emplace();
    start.ball = simulator::BallState{.position = {0.3, 0.2}, .velocity = {0.0, 0.0}};
    start.robots[0][1] = {
        .state = simulator::BodyState({0.1, 0.2}, {}, {}), .wheels = {}, .is_broken = true};
    start.restart.emplace();
    record.from = record::PlayedOnFrom{.tick = 1, .state_hash = 2, .teams = {"a", "b"}};
    ASSERT_TRUE(record::save(disk, words.back(), record));
  }
  expect_exit(0, run(words));
}

// The flat form is the one that core-only builds of other compilers read.
TEST(Records, LoseNothingWhenTheyAreMadeFlat) {
  for (const auto end : {match::OutcomeKind::shoot_out, match::OutcomeKind::double_forfeit}) {
    const std::string flat = test_support::flat(leg_that_ends(end));
    auto recording = recording_from(flat);
    ASSERT_TRUE(recording);
    EXPECT_FALSE(replay::verify(*recording));
    // Bytes between members may differ.
    EXPECT_EQ(test_support::flat(*recording).size(), flat.size());
    recording->decisions.back().decision.reason += "!";
    EXPECT_TRUE(replay::verify(*recording));
    EXPECT_FALSE(recording_from(flat.substr(0, flat.size() - 1)));
  }
}

// Catches a key or a byte that reader and writer changed together.
TEST(Records, AreReadAsTheSampleHasThem) {
  system::Disk disk;
  const std::string behaviour_hash = record::this_software().behaviour_hash;
  const std::string path = source + "/tests/programs/records/samples/leg.json";
  const auto loaded = record::load(disk, path);
  ASSERT_TRUE(test_support::is_ok(loaded));
  expect_valid({path});
  const Outcome verified = verify(path);
  if (verified.exit_code == 0) return;
  EXPECT_NE(loaded->software.behaviour_hash, behaviour_hash) << verified.out << verified.err;
  EXPECT_EQ(verified.exit_code, 4) << path;
  EXPECT_TRUE(contains(verified.err, "another version of the game"));
}

// Catches a record of another version that no module verifies, a module that is used although this
// host has not listed it or others may write to the list, a verdict that is not the module's, and
// JavaScript of the folder that is run.
TEST(Records, OfAnotherVersionAreVerifiedByItsModule) {
  const std::string own = system::browser_folder() + "/mirocup.wasm";
  if (!std::filesystem::exists(own)) GTEST_SKIP() << "the module was not built";
  const TemporaryFolder folder;
  setenv("XDG_STATE_HOME", (folder / "state").c_str(), 1);
  const std::string league = folder / "league";
  const std::string path = league + "/records/leg.json";
  const std::string game = "0123456789abcdef";
  const std::string home = league + "/programs/" + game;
  std::filesystem::create_directories(league + "/records");
  std::filesystem::create_directories(home + "/node_modules/fzstd");
  record::MatchRecord played = record_of(leg_that_ends(match::OutcomeKind::forfeit));
  played.software.behaviour_hash = game;
  system::Disk disk;
  ASSERT_TRUE(record::save(disk, path, played));
  const auto refusal = [&] {
    const auto found = record::verify_by_module(disk, path, played);
    return found ? "" : found.error().what;
  };
  EXPECT_TRUE(contains(refusal(), "does not exist"));

  // The module of that version is this one with another name.
  std::string module = read_file(own);
  const std::string own_game = record::this_software().behaviour_hash;
  for (auto at = module.find(own_game); at != std::string::npos; at = module.find(own_game, at))
    module.replace(at, game.size(), game);
  write_file(home + "/mirocup.wasm", module);
  const std::string script = "require('fs').writeFileSync('" + (folder / "ran") + "', '');\n";
  for (const char* name : {"/mirocup.js", "/verify.mjs", "/node_modules/fzstd/index.js"})
    write_file(home + name, script);
  EXPECT_TRUE(contains(refusal(), "--trust-programs"));
  EXPECT_EQ(record::trust_modules(disk, league)->size(), 1u);
  EXPECT_EQ(refusal(), "");
  EXPECT_FALSE(*record::verify_by_module(disk, path, played)) << "it is reproduced";

  played.recording.ticks[3].hash ^= 1;
  ASSERT_TRUE(record::save(disk, path, played));
  const Outcome differs = expect_exit(1, verify(path));
  EXPECT_TRUE(contains(differs.out, "differs from tick 3 on"));
  EXPECT_TRUE(contains(differs.err, "whose module verifies it"));
  EXPECT_FALSE(std::filesystem::exists(folder / "ran"));

  std::filesystem::permissions(folder / "state/mirocup/programs", std::filesystem::perms::all);
  const Outcome open = expect_exit(4, verify(path), "may be written by others");
  EXPECT_TRUE(contains(open.err, "use the program that played it"));
  std::filesystem::remove_all(folder / "state");
  write_file(home + "/mirocup.wasm", "no module");
  EXPECT_TRUE(record::trust_modules(disk, league));
  EXPECT_TRUE(contains(refusal(), "does not verify it"));

  // A module of a stranger in the place of this program's one does not stay.
  const std::string of_own = league + "/programs/" + own_game;
  std::filesystem::create_directories(of_own);
  write_file(of_own + "/mirocup.wasm", "of a stranger");
  EXPECT_TRUE(record::keep_module(disk, league));
  EXPECT_EQ(read_file(of_own + "/mirocup.wasm"), read_file(own));
  unsetenv("XDG_STATE_HOME");
}

// Catches a command that plays a leg again and shows, counts or judges it under a result that
// somebody has written into the record.
TEST(Records, AreCalledForgedByEachCommandThatPlaysThemAgain) {
  const TemporaryFolder folder;
  const std::string path = folder / "leg.json";
  const std::string page = folder / "leg.html";
  ASSERT_EQ(run_mirocup({"match", "--blue", "striker", "--yellow", "chaser", "--half", "2",
                         "--record", path})
                .exit_code,
            0);
  system::Disk disk;
  const auto whole = record::load(disk, path);
  ASSERT_TRUE(is_ok(whole));
  record::MatchRecord score = *whole;
  score.recording.outcome.score = score.recording.outcome.played = {9, 0};
  score.recording.outcome.winner = Team::blue;
  record::MatchRecord call = *whole;
  call.recording.decisions.pop_back();
  const std::vector<std::vector<std::string>> commands{{"replay", path, "-o", page},
                                                       {"stats", path},
                                                       {"rerun", path},
                                                       {"referee", "--record", path},
                                                       {"verify", path}};
  const auto expect_all = [&](const record::MatchRecord& record, int exit_code) {
    ASSERT_TRUE(record::save(disk, path, record));
    for (const auto& command : commands) {
      std::vector<std::string> words{program("mirocup")};
      words.insert(words.end(), command.begin(), command.end());
      const Outcome outcome = run(words);
      EXPECT_EQ(outcome.exit_code, exit_code) << command[0] << outcome.out << outcome.err;
      EXPECT_EQ((outcome.out + outcome.err).find("differs") != std::string::npos, exit_code != 0)
          << command[0] << outcome.out << outcome.err;
    }
  };
  expect_all(score, 1);
  expect_all(call, 1);
  EXPECT_FALSE(std::filesystem::exists(page));
  expect_all(*whole, 0);
  score.software.behaviour_hash = "0123456789abcdef";
  expect_all(score, 4);
}

TEST(Records, AreNotCalledWrongIfTheBehaviourHasChanged) {
  const TemporaryFolder folder;
  const std::string path = folder / "leg.json";
  system::Disk disk;
  record::MatchRecord record = record_of(leg_that_ends(match::OutcomeKind::full_time));
  record.recording.ticks[30].hash ^= 1;
  ASSERT_TRUE(record::save(disk, path, record));
  EXPECT_EQ(verify(path).exit_code, 1) << "this game's";

  record.software.behaviour_hash = "0123456789abcdef";
  record.software.version = "0.0.9";
  ASSERT_TRUE(record::save(disk, path, record));
  const Outcome verified = expect_exit(4, verify(path));
  for (const char* part : {"leg.json", "0123456789abcdef", "mirocup 0.0.9", "from tick 30 on"}) {
    EXPECT_TRUE(contains(verified.err, part));
  }
  expect_exit(4, run_mirocup({"replay", path, "-o", folder / "leg.html"}));
  EXPECT_FALSE(std::filesystem::exists(folder / "leg.html"));

  // A leg that both versions play identically is reproduced.
  record.recording.ticks[30].hash ^= 1;
  ASSERT_TRUE(record::save(disk, path, record));
  EXPECT_EQ(verify(path).exit_code, 0);
}

}  // namespace
}  // namespace mirocup
