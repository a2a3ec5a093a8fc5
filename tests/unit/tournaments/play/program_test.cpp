// SPDX-License-Identifier: MIT
//
// Catches a league that goes on with a program that plays otherwise without being told to, and a
// record that names a folder in which no program was kept.
#include "tournaments/play/program.hpp"

#include "system/child_process.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/memory_files.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tournaments/league/kept_program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <unistd.h>

namespace mirocup::league {
namespace {

class Program : public testing::Test {
 protected:
  Program() {
    setenv("XDG_STATE_HOME", (state_ / "").c_str(), 1);
    std::filesystem::create_directories(folder_.path);  // for its lock
    LeagueFile file;
    for (const char* name : {"a", "b"})
      file.teams.push_back({.name = name, .source = "house:idle", .over_dds = false});
    EXPECT_TRUE(files_.write(folder_.config(), print_league_file(file)));
  }
  ~Program() override {
    unsetenv("XDG_STATE_HOME");
    std::filesystem::remove_all(folder_.path);
  }

  LeagueStore started_by(const std::string& version, const std::string& game) {
    auto store = LeagueStore::open(files_, folder_);
    EXPECT_TRUE(test_support::is_ok(store));
    Started event;
    event.config_sha256 = system::sha256(*files_.read(folder_.config()));
    event.version = version;
    event.game = game;
    EXPECT_TRUE(store->write(event));
    return std::move(*store);
  }

  void play_leg(LeagueStore& store, const std::string& game) {
    LegPlayed leg;
    leg.fixture = "r1-f1";
    const Fixture& fixture = store.state().fixtures[0].fixture;
    leg.home = leg.blue = store.state().name(fixture.home);
    leg.away = store.state().name(fixture.away);
    leg.record = "records/r1-f1-1-1.json";
    EXPECT_TRUE(files_.write(folder_.path + "/" + leg.record,
                             R"({"software": {"version": "0", "game": ")" + game + R"("}})"));
    const auto written = store.write(leg);
    EXPECT_TRUE(test_support::is_ok(written));
  }

  // The error, or "".
  std::string refusal(LeagueStore& store, bool accepts_other = false) {
    const auto same = expect_program(files_, store, now_, accepts_other);
    return same ? "" : same.error().what;
  }

  const test_support::TemporaryFolder state_;
  test_support::MemoryFiles files_;
  const Folder folder_{testing::TempDir() + "program_test-" + std::to_string(getpid())};
  const record::Software now_{.version = "0", .build = "g++", .behaviour_hash = "beef"};
};

TEST_F(Program, OfTheJournalGoesOn) {
  LeagueStore store = started_by("0", "beef");
  EXPECT_EQ(refusal(store), "");
}

TEST_F(Program, ThatPlaysOtherwiseIsRefusedUntilItIsAccepted) {
  LeagueStore store = started_by("0", "f00d");
  EXPECT_NE(refusal(store).find("--other-program"), std::string::npos);
  EXPECT_EQ(refusal(store, true), "");
  EXPECT_EQ(refusal(store), "") << "the journal names it now";
}

TEST_F(Program, IsThatOfTheLastRecordIfTheJournalNamesNone) {
  LeagueStore store = started_by("0", "");
  EXPECT_EQ(refusal(store), "") << "no leg was played";
  play_leg(store, "f00d");
  EXPECT_NE(refusal(store).find("game f00d"), std::string::npos) << refusal(store);
  EXPECT_EQ(refusal(store, true), "");
  EXPECT_EQ(refusal(store), "");
}

TEST_F(Program, IsKeptUnderItsHashOnly) {
  ASSERT_TRUE(files_.write(kept_program(folder_, "f00d"), "a program"));
  ASSERT_TRUE(files_.write(folder_.programs() + "/../mirocup", "another one"));
  ASSERT_TRUE(trust_program("a program"));
  MatchServers servers(files_, folder_);
  EXPECT_EQ(servers.of_game("f00d").path, kept_program(folder_, "f00d"));
  for (const char* game : {"", "..", "beefbeef", "f00d/../f00d"})
    EXPECT_EQ(servers.of_game(game).words, servers.own().words) << game;
  const std::string own = record::this_software().behaviour_hash;
  ASSERT_TRUE(files_.write(kept_program(folder_, own), "a copy of this one"));
  ASSERT_TRUE(trust_program("a copy of this one"));
  EXPECT_EQ(servers.of_game(own).words, servers.own().words);
}

// Catches a kept program that is run without being on this host's list, one whose bytes are not
// those of the list, and a list of another user that counts.
TEST_F(Program, IsRunIfThisHostTrustsIt) {
  ASSERT_TRUE(files_.write(kept_program(folder_, "f00d"), "#!/bin/sh\necho first\n"));
  const auto server = [this] { return MatchServers(files_, folder_).of_game("f00d"); };
  EXPECT_NE(server().why_not_kept.find("--trust-programs"), std::string::npos);
  EXPECT_EQ(server().words.size(), 1u);
  ASSERT_TRUE(trust_program("#!/bin/sh\necho first\n"));
  EXPECT_EQ(server().why_not_kept, "");
  MatchServers servers(files_, folder_);
  std::vector<std::string> words = servers.of_game("f00d").words;
  ASSERT_TRUE(files_.write(kept_program(folder_, "f00d"), "#!/bin/sh\necho second\n"));
  const std::string said = folder_.path + "/said";
  EXPECT_EQ(*system::run_child({.arguments = words, .log = said}), 0);
  system::Disk disk;
  EXPECT_EQ(*disk.read(said, {.max_size = 100}), "first\n") << "what was looked at is run";
  EXPECT_NE(server().why_not_kept.find("--trust-programs"), std::string::npos) << "other bytes";

  ASSERT_TRUE(files_.write(kept_program(folder_, "f00d"), "#!/bin/sh\necho first\n"));
  EXPECT_EQ(server().why_not_kept, "");
  std::filesystem::permissions(state_ / "mirocup/programs", std::filesystem::perms::all);
  EXPECT_NE(server().why_not_kept.find("may be written by others"), std::string::npos)
      << server().why_not_kept;
}

}  // namespace
}  // namespace mirocup::league
