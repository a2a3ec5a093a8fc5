// SPDX-License-Identifier: MIT
//
// Catches a league that goes on with a program that plays otherwise.
#include "tournaments/play/program.hpp"

#include "tests/support/is_ok.hpp"
#include "tests/support/memory_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <unistd.h>

namespace mirocup::league {
namespace {

class Program : public testing::Test {
 protected:
  Program() {
    std::filesystem::create_directories(folder_.path);  // for its lock
    LeagueFile file;
    for (const char* name : {"a", "b"})
      file.teams.push_back({.name = name, .source = "house:idle", .over_dds = false});
    EXPECT_TRUE(files_.write(folder_.config(), print_league_file(file)));
  }
  ~Program() override { std::filesystem::remove_all(folder_.path); }

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

  // The error, or "".
  std::string refusal(const LeagueStore& store) {
    const auto same = expect_program(store, now_);
    return same ? "" : same.error().what;
  }

  test_support::MemoryFiles files_;
  const Folder folder_{testing::TempDir() + "program_test-" + std::to_string(getpid())};
  const record::Software now_{.version = "0", .build = "g++", .behaviour_hash = "beef"};
};

TEST_F(Program, OfTheJournalGoesOn) {
  EXPECT_EQ(refusal(started_by("0", "beef")), "");
}

TEST_F(Program, ThatPlaysOtherwiseIsRefused) {
  const std::string other_game = refusal(started_by("0", "f00d"));
  EXPECT_NE(other_game.find("is played with mirocup 0 (game f00d); this program is mirocup 0 (game "
                            "beef)"),
            std::string::npos)
      << other_game;
}

TEST_F(Program, OfAnotherVersionIsRefused) {
  const std::string other_version = refusal(started_by("0.0.7", "beef"));
  EXPECT_NE(other_version.find("Continue with mirocup 0.0.7"), std::string::npos) << other_version;
}

}  // namespace
}  // namespace mirocup::league
