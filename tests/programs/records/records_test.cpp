// SPDX-License-Identifier: MIT
//
// Record files of every ending, of earlier versions and of other physics. Catches a record that its
// schema does not describe, a reader that no longer reads older records, and a record that is
// reported as wrong only because physics or laws have changed since.
#include "core/replay/verification.hpp"
#include "record/match_record.hpp"
#include "system/descriptor.hpp"
#include "tests/build/compilers/flat_recording.hpp"
#include "tests/programs/records/endings.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <sys/stat.h>

namespace mirocup {
namespace {

using test_support::leg_that_ends;
using test_support::Outcome;
using test_support::program;
using test_support::run;
using test_support::TemporaryFolder;
using test_support::write_file;

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
  return run({program("mirocup"), "verify", path});
}

// Expects the schema to be valid, and the records to fit it.
void expect_valid(const std::vector<std::string>& records) {
  std::vector<std::string> words{source + "/tests/programs/records/schema.py",
                                 source + "/record/record.schema.json"};
  words.insert(words.end(), records.begin(), records.end());
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

std::vector<std::string> samples() {
  std::vector<std::string> paths;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(source + "/tests/programs/records/samples")) {
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  }
  return paths;
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

// Catches a key that schema.md or record.schema.json does not describe, one that they describe but
// no record has, and an example in schema.md that no record looks like.
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
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

// The flat form is the one that core-only builds of other compilers read.
TEST(Records, LoseNothingWhenTheyAreMadeFlat) {
  for (const auto end : {match::OutcomeKind::shoot_out, match::OutcomeKind::double_forfeit}) {
    const std::string flat = test_support::flat(leg_that_ends(end));
    auto recording = test_support::recording_from(flat);
    ASSERT_TRUE(recording);
    EXPECT_FALSE(replay::verify(*recording));
    // Bytes between members may differ.
    EXPECT_EQ(test_support::flat(*recording).size(), flat.size());
    recording->decisions.back().decision.reason += "!";
    EXPECT_TRUE(replay::verify(*recording));
    EXPECT_FALSE(test_support::recording_from(flat.substr(0, flat.size() - 1)));
  }
}

// The software that played the first sample, which plays otherwise than this one.
record::Software software() {
  system::Disk disk;
  return record::load(disk, samples().front())->software;
}

// The line of a script that answers --version.
std::string answers(const std::string& version) {
  return "[ \"$1\" = --version ] && echo " + version + " && exit 0\n";
}

// Returns the folder of a version that verifies everything with that exit code.
std::string add_version(const TemporaryFolder& versions, const std::string& name,
                        const std::string& version, int code) {
  const std::string folder = versions / name;
  const std::string path = folder + "/bin/mirocup";
  std::filesystem::create_directories(folder + "/bin");
  test_support::write_file(path, "#!/bin/sh\n" + answers(version) + "echo " + name + " $1; exit " +
                                     std::to_string(code) + "\n");
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return folder;
}

Outcome verify_with(const std::string& versions, const std::string& record = samples().front()) {
  setenv("MIROCUP_VERSIONS", versions.c_str(), 1);
  Outcome verified = verify(record);
  unsetenv("MIROCUP_VERSIONS");
  return verified;
}

TEST(Records, AreReadIfEarlierVersionsWroteThem) {
  system::Disk disk;
  const std::string behaviour_hash = record::this_software().behaviour_hash;
  ASSERT_FALSE(samples().empty());
  for (const std::string& path : samples()) {
    const auto loaded = record::load(disk, path);
    ASSERT_TRUE(test_support::is_ok(loaded));
    const Outcome verified = verify(path);
    if (verified.exit_code == 0) continue;
    EXPECT_NE(loaded->software.behaviour_hash, behaviour_hash) << verified.out << verified.err;
    EXPECT_EQ(verified.exit_code, 4) << path;
    EXPECT_NE(verified.err.find("another version of the game"), std::string::npos) << verified.err;
  }
  expect_valid(samples());
}

// Catches a verification that does not look for the version that played the record, and one that
// asks a version that does not reproduce it.
TEST(Records, AreVerifiedByTheVersionThatPlayedThem) {
  const TemporaryFolder versions;
  const std::string path = add_version(versions, "unlike", "0.0.7", 0) + ":" +
                           add_version(versions, "other", software().version, 4) + ":" +
                           add_version(versions, "fitting", software().version, 0);
  const Outcome verified = verify_with(path);
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
  EXPECT_EQ(verified.out, "fitting verify\n");
  EXPECT_NE(verified.err.find("played by another version"), std::string::npos) << verified.err;
}

// Catches a version that leaves a process which writes until the disk is full.
TEST(Records, AreVerifiedThoughAVersionLeavesAProcessBehind) {
  const TemporaryFolder versions;
  const std::string held = versions / "held";  // by all processes of the version
  ASSERT_EQ(mkfifo(held.c_str(), 0600), 0);
  const system::Descriptor reader(open(held.c_str(), O_RDONLY | O_NONBLOCK));
  const std::string path = add_version(versions, "fitting", software().version, 0);
  for (const char* left : {"sleep 1000", "yes", "setsid yes"}) {
    write_file(path + "/bin/mirocup", "#!/bin/sh\nexec 9>" + held +
                                          "\n[ \"$1\" = --version ] && echo " + software().version +
                                          " || echo fitting $1\n" + left + " &\n");
    const Outcome verified = verify_with(path);
    EXPECT_EQ(verified.exit_code, 0) << left << verified.err;
    EXPECT_TRUE(verified.out.starts_with("fitting verify\n")) << left;
    constexpr int patience = 60'000;  // ms, of a failure
    pollfd end{.fd = reader.get(), .events = 0, .revents = 0};
    EXPECT_EQ(poll(&end, 1, patience), 1) << left << " is left";
  }
}

// Catches a verification that runs a program of any user beside the prefix, as in /tmp beside /usr.
TEST(Records, AreVerifiedByNoProgramBesideThePrefix) {
  const TemporaryFolder prefixes;
  const std::string own = add_version(prefixes, "own", "", 0) + "/bin/mirocup";
  add_version(prefixes, "other", software().version, 0);
  std::filesystem::remove(own);
  std::filesystem::copy_file(program("mirocup"), own);
  const Outcome verified = run({own, "verify", samples().front()});
  EXPECT_EQ(verified.exit_code, 4) << verified.err;
  EXPECT_EQ(verified.out, "");
}

// Catches a verification that runs a program in a folder that others can write to, another program
// by a link, or any program for a record that was changed.
TEST(Records, AreVerifiedByNoProgramThatOthersCanWrite) {
  namespace fs = std::filesystem;
  const TemporaryFolder versions;
  const std::string version = add_version(versions, "v", software().version, 0);
  EXPECT_EQ(verify_with(version).exit_code, 0);
  for (const std::string& open : {version, version + "/bin", version + "/bin/mirocup"}) {
    fs::permissions(open, fs::perms::group_write, fs::perm_options::add);
    const Outcome verified = verify_with(version);
    EXPECT_EQ(verified.exit_code, 4) << verified.out;
    EXPECT_NE(verified.err.find(open + " may be written by others"), std::string::npos)
        << verified.err;
    fs::permissions(open, fs::perms::group_write, fs::perm_options::remove);
  }
  const std::string record = versions / "leg.json";
  fs::copy_file(samples().front(), record);
  fs::copy_file(record::replay_path_of(samples().front()), record::replay_path_of(record));
  EXPECT_EQ(verify_with(version, record).exit_code, 0);
  test_support::write_file(record, test_support::read_file(record) + " ");
  EXPECT_EQ(verify_with(version, record).exit_code, 4) << "its text was changed";
  fs::remove(version + "/bin/mirocup");
  fs::create_symlink("/usr/bin/true", version + "/bin/mirocup");
  EXPECT_EQ(verify_with(version).exit_code, 4) << "true verifies everything";
}

// Two versions of which neither reproduces the record used to ask each other without end.
TEST(Records, AreNotAskedForInACircle) {
  const test_support::TemporaryFolder versions;
  std::filesystem::create_directories(versions / "other/bin");
  const std::string program = versions / "other/bin/mirocup";
  const std::string calls = versions / "calls";
  test_support::write_file(program, "#!/bin/sh\n" + answers(software().version) + "echo call >> " +
                                        calls + "\n[ $(wc -l < " + calls + ") -lt 4 ] && " +
                                        test_support::program("mirocup") +
                                        " verify \"$2\"\nexit 4\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  setenv("MIROCUP_VERSIONS", (versions / "other").c_str(), 1);
  const auto verified =
      test_support::run({test_support::program("mirocup"), "verify", samples().front()});
  unsetenv("MIROCUP_VERSIONS");
  EXPECT_EQ(verified.exit_code, 4) << verified.err;
  EXPECT_EQ(test_support::read_file(calls), "call\n");
}

// Catches a command that plays a leg again and shows, counts or judges it under a result that
// somebody has written into the record.
TEST(Records, AreCalledForgedByEachCommandThatPlaysThemAgain) {
  const TemporaryFolder folder;
  const std::string path = folder / "leg.json";
  const std::string page = folder / "leg.html";
  ASSERT_EQ(run({program("mirocup"), "match", "--blue", "striker", "--yellow", "chaser", "--half",
                 "2", "--record", path})
                .exit_code,
            0);
  system::Disk disk;
  const auto whole = record::load(disk, path);
  ASSERT_TRUE(test_support::is_ok(whole));
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
  const Outcome verified = verify(path);
  EXPECT_EQ(verified.exit_code, 4);
  for (const char* part : {"leg.json", "0123456789abcdef", "mirocup 0.0.9", "from tick 30 on"}) {
    EXPECT_NE(verified.err.find(part), std::string::npos) << verified.err;
  }
  const Outcome page = run({program("mirocup"), "replay", path, "-o", folder / "leg.html"});
  EXPECT_EQ(page.exit_code, 4);
  EXPECT_FALSE(std::filesystem::exists(folder / "leg.html"));

  // A leg that both versions play identically is reproduced.
  record.recording.ticks[30].hash ^= 1;
  ASSERT_TRUE(record::save(disk, path, record));
  EXPECT_EQ(verify(path).exit_code, 0);
}

}  // namespace
}  // namespace mirocup
