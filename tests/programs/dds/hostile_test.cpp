// SPDX-License-Identifier: MIT
//
// Packets that no honest program sends. A long run:
// MIROCUP_STORM=100000 build/dds_tests --gtest_filter='*Storm*'
#include "tests/programs/dds/network.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

namespace mirocup {
namespace {

using namespace test_support;

// Returns the peak of the memory of a running process, MB.
[[maybe_unused]] double peak_memory(int pid) {
  std::istringstream status(read_file("/proc/" + std::to_string(pid) + "/status"));
  std::string line;
  while (std::getline(status, line)) {
    if (line.rfind("VmHWM:", 0) == 0) return std::stod(line.substr(6)) / 1024.0;
  }
  return 0.0;
}

// A stranger sends changed packets of every kind before the team joins. Catches topics that
// describe their types on the network: after one announcement with a changed description no process
// matches WorldState any more.
TEST(DdsHostile, PlaysTheSameLegAfterAStormOfChangedPackets) {
  const char* asked = std::getenv("MIROCUP_STORM");
  const std::string packets = asked != nullptr ? asked : "2000";
  const TemporaryFolder folder;
  const std::string id = match_id("storm");
  Running leg(under_garbage(
      {program("mirocup"), "match", "--blue", "dds:remote", "--yellow", "keeper", "--half", "5",
       "--match", id, "--record", folder / "leg.json", "--join-within", "60"},
      folder / "leaks.txt"));
  Running storm(on_bad_network({program("dds/intruder"), "imitate", id, "remote"},
                               {"BAD_NETWORK_GARBAGE=20", "BAD_NETWORK_LIMIT=" + packets}));
  ASSERT_TRUE(has_said(storm, packets + " changed packets were sent")) << storm.err();
  Running remote(join(id, "blue", "remote", "striker"));
  ASSERT_TRUE(has_said(remote, "remote plays blue")) << remote.err() << leg.err();
  const double peak = peak_memory(leg.pid());
  EXPECT_LT(peak, 64.0) << "MB";
  RecordProperty("peak_mb", std::to_string(peak));
  const Outcome played = expect_exit(0, leg.wait());
  EXPECT_LT(played.err.size(), 2000U);  // hostile packets cannot make the log long
  run_mirocup({"match", "--blue", "striker", "--yellow", "keeper", "--half", "5", "--record",
               folder / "so.json"});
  EXPECT_EQ(read_json(folder / "leg.json")["state_hash"],
            read_json(folder / "so.json")["state_hash"]);
}

// In open mode one forged packet can make the server drop all later packets of a team. The team
// notices that the server does not count its commands, and joins again as a new participant.
TEST(DdsHostile, PlaysOnAfterAForgedPacketHasMadeTheServerDeaf) {
  const TemporaryFolder folder;
  const std::string id = match_id("jump");
  Running leg({program("mirocup"), "match", "--blue", "dds:remote", "--yellow", "keeper", "--half",
               "5", "--match", id, "--record", folder / "leg.json"});
  Running remote(on_bad_network(join(id, "blue", "remote", "striker"), {"BAD_NETWORK_JUMP=100"}));
  const Outcome played = expect_exit(0, leg.wait());
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump() << played.err;
  EXPECT_EQ(record["network"]["blue"]["processes"], 1);
  EXPECT_TRUE(contains(played.err, "the team's process has joined the network anew"));
  EXPECT_EQ(run_mirocup({"verify", folder / "leg.json"}).exit_code, 0);
}

// Commands that are not finite are driven as zero and counted.
TEST(DdsHostile, DrivesNonFiniteNumbersAsZero) {
  const TemporaryFolder folder;
  const std::string id = match_id("nan");
  Running remote(join(id, "blue", "remote", program("teams/nonsense.so")));
  expect_exit(0, run_mirocup({"match", "--blue", "dds:remote", "--yellow", "keeper", "--half", "2",
                              "--match", id, "--record", folder / "leg.json"}));
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time");
  EXPECT_EQ(record["budget"]["blue"]["bad_commands"], record["ticks"]);
  EXPECT_EQ(run_mirocup({"verify", folder / "leg.json"}).exit_code, 0);
}

// Packets to another address of the host are dropped, although Cyclone binds to all addresses.
TEST(DdsHostile, HearsOnlyItsInterface) {
  Running leg({program("mirocup"), "match", "--blue", "dds:nobody", "--yellow", "idle", "--match",
               match_id("interface")});
  ASSERT_TRUE(is_there(leg));
  EXPECT_TRUE(wait_until([&leg] {
    run({"/bin/bash", "-c", "for p in {7410..7429}; do echo x >/dev/udp/127.0.0.2/$p; done"});
    return sockets_of(leg.pid()).dropped >= 20;
  }));
}

}  // namespace
}  // namespace mirocup
