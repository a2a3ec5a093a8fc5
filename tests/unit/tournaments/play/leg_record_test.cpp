// SPDX-License-Identifier: MIT
//
// Catches a record that cannot be read and is taken for one that is not there: its leg, which may
// have been decided, would be played again.
#include "tournaments/play/leg_record.hpp"

#include "core/match/leg.hpp"
#include "record/json_reader.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/unreadable.hpp"
#include "tests/unit/tournaments/small_league.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace mirocup::league {
namespace {

class RecordOfALeg : public testing::Test {
 protected:
  RecordOfALeg() {
    leg_ = {state_.fixtures[0].fixture, 1};
    path_ = folder_.record(leg_.fixture, leg_.leg, leg_.version);
    EXPECT_TRUE(disk_.make_folder(folder_.path + "/records"));
  }

  // A record with what a league reads.
  Json record(const std::string& end = "full_time") const {
    const auto [blue, yellow] = leg_.fixture.colours(leg_.leg);
    const auto seat = [this](int team) {
      return Json{{"name", state_.name(team)},
                  {"sha256", state_.teams[team].sha256},
                  {"parameters", Json::object()}};
    };
    return {{"seed", leg_seed(state_, leg_)},
            {"teams", {{"blue", seat(blue)}, {"yellow", seat(yellow)}}},
            {"result",
             {{"score", {{"blue", 2}, {"yellow", 1}}},
              {"winner", "blue"},
              {"end", end},
              {"fault", Json()}}},
            {"decisions", Json::array()},
            {"state_hash", "0"}};
  }

  Result<std::optional<LegPlayed>> found() { return find_played_leg(disk_, folder_, state_, leg_); }

  Result<std::optional<LegPlayed>> found_in(const std::string& text) {
    EXPECT_TRUE(disk_.write(path_, text));
    return found();
  }

  const test_support::TemporaryFolder temporary_;
  system::Disk disk_;
  const Folder folder_{temporary_ / "league"};
  LeagueState state_ = league_with_entries(league_file_of({"a", "b"}));
  LegId leg_;
  std::string path_;
};

TEST_F(RecordOfALeg, IsFoundAndNothingElseIs) {
  ASSERT_TRUE(found());
  EXPECT_FALSE(*found());
  const auto played = found_in(record::json_text(record()));
  ASSERT_TRUE(test_support::is_ok(played));
  ASSERT_TRUE(*played);
  EXPECT_EQ((*played)->score.home + (*played)->score.away, 3);
  Json other = record();
  other["seed"] = 1;
  ASSERT_TRUE(found_in(record::json_text(other)));
  EXPECT_FALSE(*found());
  const auto of_void = found_in(record::json_text(record("void")));
  ASSERT_TRUE(test_support::is_ok(of_void));
  EXPECT_FALSE(*of_void) << "the host failed, and the leg is played again";
}

TEST_F(RecordOfALeg, IsNotTakenForAbsentIfItCannotBeRead) {
  for (const auto way : test_support::ways_to_be_unreadable) {
    test_support::make_unreadable(path_, way);
    const auto read = found();
    ASSERT_FALSE(read) << static_cast<int>(way);
    EXPECT_NE(read.error().what.find(path_), std::string::npos) << read.error().what;
    EXPECT_GE(exit_code(read.error().code), 3) << read.error().what;
  }
  std::filesystem::remove(path_);
  const std::string whole = record::json_text(record());
  for (const std::string& text :
       {std::string(), whole.substr(0, whole.size() / 2), std::string("{}")}) {
    const auto read = found_in(text);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().code, Errc::damaged) << read.error().what;
  }
}

TEST_F(RecordOfALeg, IsNotTakenForAbsentWhileItsDiskIsAway) {
  EXPECT_TRUE(disk_.remove(folder_.path + "/records"));
  test_support::make_unreadable(folder_.path + "/records",
                                test_support::Unreadable::leads_to_nothing);
  EXPECT_FALSE(found());
}

}  // namespace
}  // namespace mirocup::league
