// SPDX-License-Identifier: MIT
//
// Catches statistics in files that are not those that were counted, columns without their heads,
// and a page that shows other numbers than the command prints.
#include "record/statistics/report.hpp"

#include "record/json_reader.hpp"
#include "record/statistics/statistics_json.hpp"
#include "system/csv.hpp"
#include "tests/support/controllers.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/memory_files.hpp"
#include "web/page.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace mirocup::statistics {
namespace {

record::MatchRecord played(std::uint64_t seed, double half_s = 20.0) {
  match::Setup setup = test_support::short_setup(seed, half_s);
  setup.rules.mercy_goal_diff = 0;
  match::Leg leg(setup);
  auto blue = test_support::ball_hunter();
  auto yellow = test_support::random_team(seed);
  test_support::play(leg, blue, yellow);
  record::MatchRecord record;
  record.software = record::this_software();
  record.isolation = "none";
  record.teams[0].name = "hunters, \"good\"";
  record.teams[1].name = "random";
  record.recording = replay::record(leg);
  return record;
}

LegReport counted(std::uint64_t seed) {
  auto report = count_leg("leg.json", played(seed));
  EXPECT_TRUE(report);
  return report.value_or(LegReport());
}

LegReport find_eventful() {
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    LegReport report = counted(seed);
    if (!report.statistics.goals.empty() && !report.statistics.fouls.empty()) return report;
  }
  ADD_FAILURE() << "no seed gives a goal and a foul";
  return {};
}

// Some leg with goals and fouls, or the tests would hold little.
LegReport eventful() {
  static const LegReport leg = find_eventful();
  return leg;
}

TEST(StatisticsJson, ReadsBackAsWritten) {
  LegReport leg = eventful();
  leg.leg = "r1-f1 leg 2";
  const auto read = parse_leg_report(leg_report_text(leg), "x.json");
  ASSERT_TRUE(test_support::is_ok(read));
  EXPECT_EQ(to_json(*read), to_json(leg));
  EXPECT_EQ(read->statistics.teams, leg.statistics.teams) << "to the last digit";
  EXPECT_EQ(read->leg, leg.leg);
  EXPECT_EQ(read->state_hash, leg.state_hash);
}

// Catches a file of another version, or a damaged one, that counts as no goals at all.
TEST(StatisticsJson, RefusesWhatItDoesNotKnow) {
  std::string text = leg_report_text(eventful());
  const auto complaint = [](const std::string& changed) {
    const auto read = parse_leg_report(changed, "x.json");
    if (read) return std::string("none");
    EXPECT_EQ(read.error().code, Errc::damaged);
    return read.error().what;
  };
  EXPECT_NE(complaint(text.substr(0, text.size() / 2)), "none");
  std::string other = text;
  other.replace(other.find("mirocup/statistics/1"), 20, "mirocup/statistics/9");
  EXPECT_NE(complaint(other).find("/schema"), std::string::npos);
  other = text;
  other.replace(other.find("\"shots\": "), 9, "\"shots\": -");
  EXPECT_NE(complaint(other).find("/teams/blue/shots"), std::string::npos);
}

TEST(StatisticsReport, SumsAreThoseOfTheLegs) {
  const std::vector<LegReport> legs{counted(1), counted(2)};
  const auto totals = totals_of(legs);
  ASSERT_EQ(totals.size(), 2u);
  EXPECT_EQ(totals[0].legs, 2);
  EXPECT_EQ(totals[0].own.passes,
            legs[0].statistics.teams[0].passes + legs[1].statistics.teams[0].passes);
  EXPECT_EQ(totals[0].against, totals[1].own);
  EXPECT_EQ(totals[0].own.all_goals(), legs[0].played[0] + legs[1].played[0]);
}

// Catches self-play in which both teams share one row.
TEST(StatisticsReport, TwoTeamsOfOneNameAreToldApartByColour) {
  LegReport leg = counted(1);
  leg.names = {"same", "same"};
  const auto totals = totals_of({leg});
  ASSERT_EQ(totals.size(), 2u);
  EXPECT_EQ(totals[0].name, "same (blue)");
  EXPECT_EQ(totals[1].name, "same (yellow)");
}

TEST(StatisticsReport, EveryCellOfACsvHasItsHead) {
  const LegReport leg = eventful();
  const auto rows_of = [](const std::string& text) {
    const auto table = system::read_csv(text);
    EXPECT_TRUE(test_support::is_ok(table));
    for (const system::CsvRow& row : table->rows)
      EXPECT_EQ(row.cells.size(), table->rows[0].cells.size()) << row.line;
    return table->rows.size();
  };
  EXPECT_EQ(rows_of(numbers_csv({leg})), 3u) << "the heads, and a row for each team";
  EXPECT_EQ(rows_of(goals_csv({leg})),
            1 + leg.statistics.goals.size() + leg.statistics.fouls.size());
}

TEST(StatisticsReport, NamesRecordAndTickOfEveryGoal) {
  const LegReport leg = eventful();
  const std::string text = goals_text({leg});
  EXPECT_NE(text.find("leg.json tick " + std::to_string(leg.statistics.goals[0].tick)),
            std::string::npos)
      << text;
}

// Several records at once, in their order; the first that cannot be counted is the error.
TEST(CountRecords, KeepsTheOrderAndNamesTheFirstBadRecord) {
  test_support::MemoryFiles files;
  std::vector<std::string> paths;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    paths.push_back("leg" + std::to_string(seed) + ".json");
    ASSERT_TRUE(record::save(files, paths.back(), played(seed, 4.0)));
  }
  const auto legs = count_records(files, paths);
  ASSERT_TRUE(test_support::is_ok(legs));
  ASSERT_EQ(legs->size(), 4u);
  for (std::size_t i = 0; i < paths.size(); ++i) EXPECT_EQ((*legs)[i].record, paths[i]);

  std::string text = *files.read("leg3.json");
  text[text.size() / 2] ^= 1;
  ASSERT_TRUE(files.write("leg3.json", text));
  const auto bad = count_records(files, paths);
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().code, Errc::damaged);
  EXPECT_NE(bad.error().what.find("leg3.json"), std::string::npos) << bad.error().what;

  // A record that is whole but tells of another leg.
  record::MatchRecord other = played(1, 4.0);
  other.recording.ticks[100].hash ^= 1;
  ASSERT_TRUE(record::save(files, "other.json", other));
  const auto forged = count_record(files, "other.json");
  ASSERT_FALSE(forged);
  EXPECT_EQ(forged.error().code, Errc::damaged);
  EXPECT_NE(forged.error().what.find("tick 100"), std::string::npos) << forged.error().what;
}

}  // namespace
}  // namespace mirocup::statistics
