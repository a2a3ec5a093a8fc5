// SPDX-License-Identifier: MIT
//
// Runs mirocup replay as its users do.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

namespace mirocup {
namespace {

using namespace test_support;

Outcome replay(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{program("mirocup"), "replay"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run(words);
}

class ReplayCommand : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_mirocup({"match", "--blue", "striker", "--yellow", "chaser", "--half", "20",
                           "--record", record_})
                  .exit_code,
              0);
  }

  TemporaryFolder folder_;
  std::string record_ = folder_ / "leg.json";
};

TEST_F(ReplayCommand, DrawsAMoment) {
  EXPECT_EQ(replay({record_, "--at", "5", "--svg", "-o", folder_ / "a.svg"}).exit_code, 0);
  EXPECT_EQ(replay({record_, "--at", "5.5", "--svg", "-o", folder_ / "b.svg"}).exit_code, 0);
  // The clock that pages and digests show.
  EXPECT_EQ(
      replay({record_, "--at", "second half 0:01", "--svg", "-o", folder_ / "c.svg"}).exit_code, 0);
  EXPECT_NE(read_file(folder_ / "c.svg"), read_file(folder_ / "b.svg"));
  for (const char* wrong : {"1:12", "second half", "third half 0:10", "first half 0:60", "nan"})
    EXPECT_EQ(replay({record_, "--at", wrong, "--svg"}).exit_code, 2) << wrong;
  const std::string picture = read_file(folder_ / "a.svg");
  EXPECT_EQ(picture.rfind("<svg ", 0), 0u);
  EXPECT_NE(picture, read_file(folder_ / "b.svg"));
  EXPECT_EQ(replay({record_, "--at", "1e5", "--svg", "-o", folder_ / "end.svg"}).exit_code, 0)
      << "after the end is the end";
}

TEST_F(ReplayCommand, ReportsWrongUsageAndMissingFiles) {
  EXPECT_EQ(replay({record_, "--svg", "-o", folder_ / "a.svg"}).exit_code, 2);
  EXPECT_EQ(replay({record_, "-o", folder_ / "no/folder/a.html"}).exit_code, 3);
  EXPECT_EQ(replay({folder_ / "nothing.json", "-o", folder_ / "a.html"}).exit_code, 3);
}

}  // namespace
}  // namespace mirocup
