// SPDX-License-Identifier: MIT
//
// Where in its library a team crashed.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

namespace mirocup {
namespace {

using namespace test_support;

Outcome play(const TemporaryFolder& folder, const std::string& team,
             const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{program("mirocup"), "match",
                                 "--blue",           program("teams/" + team + ".so"),
                                 "--yellow",         "idle",
                                 "--half",           "5",
                                 "--record",         folder / "leg.json"};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome played = expect_exit(0, run(words));
  const auto fault = read_json(folder / "leg.json")["result"]["fault"];
  EXPECT_EQ(fault["code"], "crash") << fault;
  EXPECT_EQ(fault["text"],
            "the team's process died of signal 11 (Segmentation fault) at a null pointer, in "
            "decide() of tick 40 (PLAY)");
  return played;
}

// Returns the offsets of `parts` in `text`, -1 for one that is not behind the one before it.
std::vector<long> in_order(const std::string& text, const std::vector<std::string>& parts) {
  std::vector<long> found;
  std::size_t at = 0;
  for (const std::string& part : parts) {
    at = at == std::string::npos ? at : text.find(part, at);
    found.push_back(at == std::string::npos ? -1 : static_cast<long>(at));
  }
  return found;
}

// Catches a trace that lacks a function, has one of the host, or stands in the wrong order.
TEST(Crash, NamesTheFunctionsOfALibraryWithSymbols) {
  for (const std::string isolation : {"T1", "T2"}) {
    if (isolation == "T2" && !why_no_t2().empty()) GTEST_SKIP() << why_no_t2();
    const TemporaryFolder folder;
    const Outcome played = play(folder, "crashes", {"--isolation", isolation});
    const std::vector<std::string> expected{"mirocup: the blue team crashed in\n  0x", " dig\n  0x",
                                            " Crashes::look_for\n  0x", " Crashes::decide\n",
                                            "addr2line -Cfie FILE 0x"};
    for (const long at : in_order(played.err, expected)) EXPECT_GE(at, 0) << played.err;
    const std::string log = read_file(folder / "leg.json.blue.log");
    EXPECT_TRUE(contains(log, "Crashed in\n  0x"));
    EXPECT_TRUE(contains(log, " Crashes::look_for\n"));
  }
}

// Catches names that are made up, and addresses that no tool can make anything of.
TEST(Crash, NamesTheAddressesOfALibraryWithoutSymbols) {
  const TemporaryFolder folder;
  const Outcome played = play(folder, "crashes_stripped");
  const std::string first = "mirocup: the blue team crashed in\n  0x";
  const std::size_t at = played.err.find(first);
  ASSERT_NE(at, std::string::npos) << played.err;
  const std::size_t end = played.err.find('\n', at + first.size());
  EXPECT_EQ(played.err.substr(end + 1, 4), "  0x") << played.err;
  EXPECT_LT(end - at, first.size() + 6) << "an address in a small file: " << played.err;
  EXPECT_FALSE(contains(played.err, "look_for"));
}

// Catches a match that waits for a process which looks for its calls and never finds an end.
TEST(Crash, EndsTheTeamWhoseTraceNeverEnds) {
  const TemporaryFolder folder;
  const Outcome played = play(folder, "crashes", {"--param", "loops=1"});
  EXPECT_FALSE(contains(played.err, "crashed in"));
}

}  // namespace
}  // namespace mirocup
