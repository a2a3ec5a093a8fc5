// SPDX-License-Identifier: MIT
#include "labs/tune/tuning.hpp"

#include "core/base/random.hpp"
#include "labs/tune/cma_es.hpp"
#include "labs/tune/tuning_file.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/unreadable.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mirocup::league {
namespace {

// A fixture of two legs against a team of the same strength plus `strength` goals: the noise of a
// match, drawn from the seed of the fixture and from the values of the parameters.
Mark noisy_fixture(double strength, std::uint64_t seed, double first_value) {
  Random random(mix_seed(seed) ^ static_cast<std::uint64_t>(first_value * 1e9));
  Mark mark;
  for (int leg = 0; leg < 2; ++leg) {
    double goals = strength;
    for (int i = 0; i < 6; ++i) goals += random.uniform(-1.5, 1.5);
    goals = std::round(goals);
    mark.goals += goals / 2.0;
    mark.points += (goals > 0.0 ? 1.0 : goals < 0.0 ? 0.0 : 0.5) / 2.0;
  }
  return mark;
}

// `strength` gives the goals of a team with these values; nothing: as it is without parameters.
PlayFixtures player(std::function<double(const std::vector<double>&)> strength,
                    const std::vector<double>& own_values) {
  return [strength = std::move(strength), own_values](
             const std::optional<std::vector<double>>& values, std::uint64_t seed,
             int fixtures) -> Result<std::vector<Mark>> {
    const std::vector<double>& used = values ? *values : own_values;
    std::vector<Mark> marks;
    for (int i = 0; i < fixtures; ++i) {
      marks.push_back(noisy_fixture(strength(used), mix_seed(seed) + static_cast<std::uint64_t>(i),
                                    used.front()));
    }
    return marks;
  };
}

const TellGeneration nothing = [](const std::vector<Generation>&) { return Result<void>(); };

TuningOptions two_parameters(std::uint64_t seed) {
  TuningOptions options;
  options.parameters = {{"wait", 0.0, 1.0}, {"side", -2.0, 2.0}};
  options.seed = seed;
  return options;
}

double hill(const std::vector<double>& values) {
  const double wait = (values[0] - 0.8) / 0.4;
  const double side = (values[1] + 1.0) / 1.5;
  return 1.5 - wait * wait - side * side;
}

// Catches a search that climbs the wrong way, or does not find a hill that is there.
TEST(Tuning, FindsTheTopOfAHillInNoise) {
  int gained = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto result = tune(two_parameters(seed), player(hill, {0.3, 1.0}), nothing);
    ASSERT_TRUE(test_support::is_ok(result));
    EXPECT_GT(hill(result->values), 0.9) << seed;
    EXPECT_NEAR(result->goals.value, hill(result->values) - hill({0.3, 1.0}), 0.9);
    gained += result->has_gained() ? 1 : 0;
    EXPECT_EQ(result->course.size(), 12U);
  }
  EXPECT_GE(gained, 9);
}

// Catches claims that are luck: the best of many noisy candidates is no better.
TEST(Tuning, ClaimsNothingWithoutAnEffect) {
  int claims = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto flat = [](const std::vector<double>&) { return 0.3; };
    const auto result = tune(two_parameters(seed), player(flat, {0.5, 0.0}), nothing);
    ASSERT_TRUE(result);
    claims += result->has_gained() ? 1 : 0;
  }
  EXPECT_LE(claims, 2);
  // A parameter for which no team asks: the same legs with every value.
  const PlayFixtures same = [](const auto&, std::uint64_t seed, int fixtures) {
    std::vector<Mark> marks;
    for (int i = 0; i < fixtures; ++i) {
      marks.push_back(noisy_fixture(0.5, seed + static_cast<std::uint64_t>(i), 0.0));
    }
    return Result<std::vector<Mark>>(marks);
  };
  const auto result = tune(two_parameters(1), same, nothing);
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->has_gained());
  EXPECT_EQ(result->points.high, 0.0);
}

// Catches a search that plays as many fixtures with little noise as with much.
TEST(Tuning, PlaysMoreWhereThereIsMoreNoise) {
  const auto clear = [](const std::vector<double>& values) { return 40.0 * values[0]; };
  const auto flat = [](const std::vector<double>&) { return 0.0; };
  const auto much = tune(two_parameters(1), player(flat, {0.5, 0.0}), nothing);
  const auto little = tune(two_parameters(1), player(clear, {0.5, 0.0}), nothing);
  ASSERT_TRUE(much && little);
  EXPECT_GT(much->course.back().played, 2 * little->course.back().played);
}

// Catches a search that ends elsewhere after it was stopped and started again, or that plays again
// what it has played; and a folder of another search that is taken.
TEST(Tuning, GoesOnToTheSameEnd) {
  const TuningOptions options = two_parameters(3);
  const PlayFixtures play = player(hill, {0.3, 1.0});
  const auto whole = tune(options, play, nothing);
  ASSERT_TRUE(whole);
  const test_support::TemporaryFolder folder;
  system::Disk disk;
  int played = 0;
  std::optional<TuningResult> end;
  for (int start = 0; start < 20 && !end; ++start) {
    auto file = TuningFile::open(disk, folder / "tune", {{"teams", "one"}});
    ASSERT_TRUE(test_support::is_ok(file));
    int left = 9;  // candidates until it is stopped
    const auto result = tune(
        options,
        [&](const auto& values, std::uint64_t seed, int fixtures) -> Result<std::vector<Mark>> {
          std::string key = std::to_string(seed) + " " + std::to_string(fixtures);
          for (const double value : values.value_or(std::vector<double>())) {
            key += " " + std::to_string(value);
          }
          if (const auto* known = file->find(key)) return *known;
          if (left-- == 0) return fail(Errc::interrupted, "stopped");
          ++played;
          auto marks = play(values, seed, fixtures);
          if (auto kept = file->keep(key, *marks); !kept) return tl::unexpected(kept.error());
          return marks;
        },
        nothing);
    if (result) end = *result;
  }
  ASSERT_TRUE(end);
  EXPECT_EQ(end->values, whole->values);
  EXPECT_EQ(end->points.low, whole->points.low);
  EXPECT_EQ(end->goals.value, whole->goals.value);
  EXPECT_EQ(played, 12 * 6 + 2) << "each candidate once, and the test";
  const auto other = TuningFile::open(disk, folder / "tune", {{"teams", "another"}});
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().what.find("another search"), std::string::npos) << other.error().what;
}

// Catches a search that begins anew because the file of what it has played cannot be read.
TEST(Tuning, IsNotBegunAnewIfItsFileCannotBeRead) {
  const test_support::TemporaryFolder folder;
  system::Disk disk;
  const auto open = [&] { return TuningFile::open(disk, folder / "tune", {{"teams", "one"}}); };
  for (const auto way : test_support::ways_to_be_unreadable) {
    test_support::make_unreadable(folder / "tune/tune.json", way);
    const auto file = open();
    ASSERT_FALSE(file) << static_cast<int>(way);
    EXPECT_NE(file.error().what.find("tune/tune.json"), std::string::npos) << file.error().what;
    EXPECT_GE(exit_code(file.error().code), 3) << file.error().what;
  }
  std::filesystem::remove_all(folder / "tune/tune.json");
  EXPECT_TRUE(test_support::is_ok(open())) << "it is not there";
}

// Catches an interval that is too narrow: the t of few numbers is not that of many.
TEST(Tuning, TheIntervalIsStudents) {
  // R: t.test(c(1, 2, 4, 7, 11))
  const Gain gain = mean_with_interval({1, 2, 4, 7, 11});
  EXPECT_DOUBLE_EQ(gain.value, 5.0);
  EXPECT_NEAR(gain.low, -0.043, 0.02);
  EXPECT_NEAR(gain.high, 10.043, 0.02);
  const Gain same = mean_with_interval({0.5, 0.5, 0.5});
  EXPECT_EQ(same.low, 0.0) << "three times the same says nothing about chance";
}

// Catches a picture that leaves out a parameter or draws beside its axes.
TEST(Tuning, DrawsItsCourse) {
  const TuningOptions options = two_parameters(1);
  const auto result = tune(options, player(hill, {0.3, 1.0}), nothing);
  ASSERT_TRUE(result);
  const std::string svg = course_svg(options, result->course);
  EXPECT_NE(svg.find("wait"), std::string::npos);
  EXPECT_NE(svg.find("side"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  int lines = 0;
  for (std::size_t at = 0; (at = svg.find("<polyline", at)) != std::string::npos; ++at) ++lines;
  EXPECT_EQ(lines, 3) << "the goals and both parameters";
}

}  // namespace
}  // namespace mirocup::league
