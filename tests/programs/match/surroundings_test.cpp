// SPDX-License-Identifier: MIT
//
// Computers that lack something: what cannot be done is said in a sentence, and nothing aborts.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

namespace mirocup {
namespace {

using namespace test_support;
using Words = std::vector<std::string>;

Words operator+(Words before, const Words& after) {
  before.insert(before.end(), after.begin(), after.end());
  return before;
}

// A command of the shell, of root with mounts of its own, and then a program.
Words in_own_mounts(const std::string& change) {
  return {"/usr/bin/unshare", "--mount", "/bin/sh", "-c", change + " && exec \"$0\" \"$@\""};
}

bool may_mount() {
  return run(in_own_mounts("true") + Words{"/bin/true"}).exit_code == 0;
}

// Catches an exception that nobody catches.
TEST(Surroundings, WithoutProcArePutIntoASentence) {
  if (!may_mount()) GTEST_SKIP() << "no mounts are allowed here";
  for (const Words& asked : {Words{program("mirocup"), "match", "--blue", "idle"},
                             Words{program("mirocup-league"), "status", "nowhere"}}) {
    const Outcome told = expect_exit(3, run(in_own_mounts("umount -l /proc") + asked));
    EXPECT_EQ(told.err, "mirocup: /proc is not mounted here: mirocup cannot run without it\n");
  }
}

// Catches a league whose zone is called wrong where all zones are missing.
TEST(Surroundings, WithoutTimeZonesNameThePackage) {
  if (!may_mount()) GTEST_SKIP() << "no mounts are allowed here";
  const TemporaryFolder folder;
  write_file(folder / "league.json",
             R"({"schema": "mirocup/league/1", "format": {"kind": "nightly"},
                 "freeze": "2027-02-01T12:00:00", "zone": "Europe/Berlin",
                 "teams": [{"name": "a", "entry": "house:idle"}]})");
  expect_exit(3,
              run(in_own_mounts("mount --bind /proc /usr/share && ls / >/dev/null") +
                  Words{program("mirocup-league"), "init", folder / "league", "--config",
                        folder / "league.json"}),
              "Debian's package is tzdata");
}

// Catches SIGXFSZ: a program that dies without a word.
TEST(Surroundings, WithASmallFileLimitSayWhichFileIsTooLarge) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_mirocup({"match", "--blue", "idle", "--yellow", "idle", "--half", "1", "--record",
                         folder / "leg.json"})
                .exit_code,
            0);
  expect_exit(3,
              run({"/bin/bash", "-c", "ulimit -f 16; exec \"$0\" \"$@\"", program("mirocup"),
                   "replay", folder / "leg.json", "-o", folder / "page.html"}),
              "page.html cannot be written: File too large");
}

// Catches a root that plays nothing, because it may not become another user; and a weaker tier of
// which only the record tells.
TEST(Surroundings, OfARootWithoutRightsPlayInT1AndSaySo) {
  if (geteuid() != 0) GTEST_SKIP() << "this is not root";
  const TemporaryFolder folder;
  const Words without_rights{"/usr/bin/setpriv", "--bounding-set=-all", "--inh-caps=-all"};
  const Words leg{program("mirocup"), "match", "--blue",   "chaser",           "--yellow", "idle",
                  "--half",           "1",     "--record", folder / "leg.json"};
  const Outcome played = expect_exit(0, run(without_rights + leg));
  EXPECT_EQ(read_json(folder / "leg.json")["isolation"], "T1");
  EXPECT_TRUE(contains(played.err, "teams play in tier T1, not T2: "));
  expect_exit(3, run(without_rights + leg + Words{"--isolation", "T2"}),
              "this system allows T1 only: ");
}

}  // namespace
}  // namespace mirocup
