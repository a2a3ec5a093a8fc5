// SPDX-License-Identifier: MIT
#include "system/commands.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace mirocup::system {
namespace {

TEST(Seed, IsAnIntegerOfSixtyFourBits) {
  EXPECT_EQ(problem_with_seed("0"), "");
  EXPECT_EQ(problem_with_seed("18446744073709551615"), "");
  for (const char* bad : {"", "-1", "+1", "1.0", "1e3", "18446744073709551616", "seed"})
    EXPECT_NE(problem_with_seed(bad), "") << bad;
}

struct Numbers {
  double any = 1.0, some = 1.0;
  int whole = 0;
  std::optional<int> maybe;
};

// Returns what an option reads, "" if it is refused.
std::string read_as(std::string option, std::string text) {
  Commands commands("program", "", "1", "");
  static Numbers got;
  got = {};
  const auto [command, o] = commands.add<Numbers>(
      [](const Numbers& read) -> Result<int> {
        got = read;
        return 0;
      },
      "run", "Commands", "", {});
  command.option("--any", o.any);
  command.option("--some", o.some).between(-2.5, 1e6);
  command.option("--whole", o.whole).between(-3, 100);
  command.option("--maybe", o.maybe);
  std::string program = "program", run = "run";
  char* words[] = {program.data(), run.data(), option.data(), text.data()};
  testing::internal::CaptureStderr();
  const auto done = commands.run(4, words, {});
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(done);
  if (*done != 0) {
    EXPECT_EQ(*done, 2);
    EXPECT_EQ(said.find("program run: "), 0u) << said;
    EXPECT_NE(said.find(option), std::string::npos) << said;
    return "";
  }
  return std::to_string(option == "--any"     ? got.any
                        : option == "--some"  ? got.some
                        : option == "--whole" ? got.whole
                                              : got.maybe.value_or(-1));
}

// Catches NaN in a range, and the readings of numbers of the library: "010" as 8, "true" as 1.
TEST(Commands, ReadNumbersAsPeopleWriteThem) {
  for (const char* option : {"--any", "--some", "--whole", "--maybe"}) {
    EXPECT_EQ(read_as(option, "010"), "10.000000") << option;
    for (const char* wrong : {"nan", "-nan", "nan(3)", "inf", "-inf", "1e999", "0x10", "0x1p3",
                              "true", " 5", "5 ", "+5", "", "1e", "ten"})
      EXPECT_EQ(read_as(option, wrong), "") << option << " " << wrong;
  }
  EXPECT_EQ(read_as("--any", "-1e3"), "-1000.000000");
  EXPECT_EQ(read_as("--some", "-2.5"), "-2.500000");
  EXPECT_EQ(read_as("--some", "1000000"), "1000000.000000");
  EXPECT_EQ(read_as("--some", "1000001"), "");
  EXPECT_EQ(read_as("--whole", "-3"), "-3.000000");
  for (const char* wrong : {"-4", "101", "1.5", "99999999999"}) {
    EXPECT_EQ(read_as("--whole", wrong), "") << wrong;
  }
}

}  // namespace
}  // namespace mirocup::system
