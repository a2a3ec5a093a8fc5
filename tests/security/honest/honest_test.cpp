// SPDX-License-Identifier: MIT
//
// Honest teams play unchanged in the sandbox, and play the same leg in every tier and in the
// server's own process. Catches a server that lets a library keep its floating-point mode, and a
// sandbox that forbids a call that a run-time library needs.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace mirocup {
namespace {

using namespace test_support;

struct HonestTeam {
  std::string name;
  std::string says;  // a text that its log must contain
};

class Honest : public testing::TestWithParam<HonestTeam> {};
INSTANTIATE_TEST_SUITE_P(Teams, Honest,
                         testing::Values(HonestTeam{"openmp", "with OpenMP, 1 thread"},
                                         HonestTeam{"threads", "without threads"},
                                         HonestTeam{"fast_math", "with -Ofast"},
                                         HonestTeam{"rounding", "with rounding of its own"},
                                         HonestTeam{"places", "with places of its own"},
                                         HonestTeam{"clocks", "with clocks"},
                                         HonestTeam{"fortran", "in Fortran"}),
                         [](const auto& c) { return c.param.name; });

TEST_P(Honest, PlaysTheSameEverywhere) {
  const std::string library = program("honest/" + GetParam().name + ".so");
  if (!std::filesystem::exists(library)) GTEST_SKIP() << "no compiler for it here";
  std::string hash;
  for (const std::vector<std::string>& how : std::vector<std::vector<std::string>>{
           {"--isolation", "T2"}, {"--isolation", "T1"}, {"--trusted"}}) {
    if (how.back() == "T2" && !why_no_t2().empty()) continue;
    const TemporaryFolder folder;
    std::vector<std::string> words{
        program("mirocup"), "match",  "--blue", library,    "--yellow",
        "chaser",           "--half", "4",      "--record", folder / "leg.json"};
    words.insert(words.end(), how.begin(), how.end());
    expect_exit(0, run(words));
    const auto record = read_json(folder / "leg.json");
    EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
    if (hash.empty()) hash = record["state_hash"].get<std::string>();
    EXPECT_EQ(record["state_hash"], hash) << how.back();
    EXPECT_EQ(run_mirocup({"verify", folder / "leg.json"}).exit_code, 0);
    if (how.front() == "--trusted") continue;
    const std::string log = read_file(folder / "leg.json.blue.log");
    EXPECT_TRUE(contains(log, GetParam().says));
  }
  if (!why_no_t2().empty()) GTEST_SKIP() << why_no_t2();
}

}  // namespace
}  // namespace mirocup
