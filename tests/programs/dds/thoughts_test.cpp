// SPDX-License-Identifier: MIT
//
// What teams on the network draw, with real processes and packets.
#include "record/thoughts_file.hpp"
#include "tests/programs/dds/network.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace mirocup {
namespace {

using namespace test_support;

std::vector<std::string> drawn_match(const std::string& id, const std::string& blue,
                                     const std::string& record,
                                     const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{program("mirocup"), "match", "--blue",  blue, "--yellow", "keeper",
                                 "--half",           "5",     "--match", id,   "--record", record};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Returns the JSON lines of what blue drew; "" if there is no file.
std::string lines_of(const std::string& folder) {
  const std::string path = folder + "/leg.blue.thoughts.zst";
  return record::unpacked_thoughts(read_file(path), path).value_or("");
}

// Returns what the team draws as a library, and the state hash of that leg.
std::string lines_of_library(std::string& hash) {
  const TemporaryFolder folder;
  const Outcome played =
      run(drawn_match("none", program("teams/draws.so"), folder / "leg.json", {"--thoughts"}));
  EXPECT_EQ(played.exit_code, 0) << played.err;
  hash = read_json(folder / "leg.json")["state_hash"].get<std::string>();
  const std::string lines = lines_of(folder / "");
  EXPECT_GT(lines.size(), 100'000U);
  return lines;
}

// Catches a shape that is lost on the way, is drawn for another tick or otherwise than a library's;
// and a leg that thoughts change.
TEST(DdsThoughts, AreThoseOfTheSameTeamAsALibrary) {
  std::string hash;
  const std::string expected = lines_of_library(hash);
  for (const bool is_kept : {true, false}) {
    const TemporaryFolder folder;
    const std::string id = match_id(is_kept ? "thoughts" : "no-thoughts");
    Running leg(
        drawn_match(id, "dds:remote", folder / "leg.json",
                    is_kept ? std::vector<std::string>{"--thoughts"} : std::vector<std::string>{}));
    Running remote(join(id, "blue", "remote", program("teams/draws.so")));
    const Outcome played = leg.wait();
    ASSERT_EQ(played.exit_code, 0) << played.err;
    EXPECT_EQ(remote.wait().exit_code, 0);
    EXPECT_EQ(read_json(folder / "leg.json")["state_hash"], hash);
    EXPECT_EQ(played.err.find("were dropped"), std::string::npos) << played.err;
    EXPECT_EQ(std::filesystem::exists(folder / "leg.blue.thoughts.zst"), is_kept);
    if (is_kept) {
      EXPECT_TRUE(lines_of(folder / "") == expected) << played.err;
    }
    EXPECT_EQ(run({program("mirocup"), "verify", folder / "leg.json"}).exit_code, 0);
  }
}

// A process that is not the team draws in its name, with its nonce. Catches a shape of it in the
// team's file, and a flood that changes the leg or that the match waits for.
TEST(DdsThoughts, OfAnotherProcessAreDroppedAndCounted) {
  std::string hash;
  lines_of_library(hash);
  const TemporaryFolder folder;
  const std::string id = match_id("foreign-thoughts");
  Running leg(drawn_match(id, "dds:remote", folder / "leg.json", {"--thoughts"}));
  Running intruder({program("dds/intruder"), "think", id, "remote"});
  ASSERT_TRUE(has_said(intruder, "there")) << intruder.err();
  Running remote(join(id, "blue", "remote", program("teams/draws.so")));
  const Outcome played = leg.wait();
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time") << record["result"];
  EXPECT_EQ(record["state_hash"], hash);
  const std::string lines = lines_of(folder / "");
  EXPECT_NE(lines.find("\"plan\""), std::string::npos);
  EXPECT_EQ(lines.find("intruder"), std::string::npos);
  EXPECT_NE(played.err.find("thoughts were dropped: 0 too late, "), std::string::npos)
      << played.err;
  EXPECT_EQ(played.err.find(", 0 of other processes"), std::string::npos) << played.err;
}

// The team's own process sends what it should not. Catches a sample that is read beyond its end, a
// tick that has the same shapes twice, and one before the one that was drawn last.
TEST(DdsThoughts, ThatMakeNoSenseAreDroppedAndCounted) {
  const TemporaryFolder folder;
  const std::string id = match_id("ramble");
  Running leg(drawn_match(id, "dds:remote", folder / "leg.json", {"--thoughts"}));
  Running remote({program("dds/intruder"), "ramble", id, "remote"});
  const Outcome played = leg.wait();
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time") << record["result"];
  const std::size_t ticks = record["ticks"].get<std::size_t>();
  std::string expected;
  for (std::size_t tick = 0; tick < ticks; ++tick) {
    expected += "{\"tick\":" + std::to_string(tick) +
                ",\"layer\":\"own\",\"colour\":\"#000000ff\",\"line\":[0,0,0.25,0.5]}\n";
  }
  EXPECT_TRUE(lines_of(folder / "") == expected);
  EXPECT_NE(played.err.find("thoughts were dropped: " + std::to_string(2 * ticks - 1) +
                            " too late, 0 of other processes, " + std::to_string(5 * ticks) +
                            " malformed"),
            std::string::npos)
      << played.err << ticks << " ticks";
}

// Catches a tick that holds more over the network than a library may draw.
TEST(DdsThoughts, HaveTheSameBoundInEachTick) {
  const TemporaryFolder folder;
  const std::string id = match_id("many-thoughts");
  Running leg(drawn_match(id, "dds:remote", folder / "leg.json", {"--thoughts"}));
  auto words = join(id, "blue", "remote", program("teams/draws.so"));
  words.insert(words.end(), {"--param", "shapes=500"});
  Running remote(words);
  const Outcome played = leg.wait();
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const std::string lines = lines_of(folder / "");
  std::size_t first_tick = 0;
  for (std::size_t at = 0; lines.compare(at, 10, "{\"tick\":0,") == 0; ++first_tick) {
    at = lines.find('\n', at) + 1;
  }
  EXPECT_EQ(first_tick, match::max_thoughts);
  EXPECT_NE(played.err.find("shapes of the blue team's thoughts were left out"), std::string::npos)
      << played.err;
}

}  // namespace
}  // namespace mirocup
