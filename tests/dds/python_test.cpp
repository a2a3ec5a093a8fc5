// SPDX-License-Identifier: MIT
//
// A team in Python, through libmirocup_team and nothing but the standard library.
#include "tests/dds/network.hpp"

#include <gtest/gtest.h>

namespace mirocup {
namespace {

using namespace test_support;

TEST(PythonTeam, PlaysAFullLeg) {
  const TemporaryFolder folder;
  const std::string id = match_id("python");
#ifdef MIROCUP_SANITIZED
  GTEST_SKIP() << "a program without sanitizers cannot load a library with them";
#endif
  Running team({"/usr/bin/env", "MIROCUP_TEAM_LIBRARY=" + program("libmirocup_team.so"),
                "PYTHONDONTWRITEBYTECODE=1", "python3", "-S",
                MIROCUP_SOURCE_FOLDER "/examples/python/chaser.py", id, "blue", "snake"});
  const Outcome played =
      run({program("mirocup"), "match", "--blue", "dds:snake", "--yellow", "idle", "--half", "8",
           "--match", id, "--record", folder / "leg.json"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const Outcome python = team.wait();
  EXPECT_EQ(python.exit_code, 0) << python.err;
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
  EXPECT_GT(record["result"]["score"]["blue"],
            0);  // it sees what is there, and drives where it says
  EXPECT_EQ(record["network"]["blue"]["in_step"], record["ticks"]);
  EXPECT_EQ(run({program("mirocup"), "verify", folder / "leg.json"}).exit_code, 0);
}

}  // namespace
}  // namespace mirocup
