// SPDX-License-Identifier: MIT
//
// What is on the network: versions that cannot play together and say so, what spectators are told,
// and DDS domains.
#include "system/descriptor.hpp"
#include "tests/programs/dds/network.hpp"
#include "tests/programs/dds/own_host.hpp"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <sys/socket.h>

namespace mirocup {
namespace {

using namespace test_support;

std::vector<std::string> match(const std::string& id, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{program("mirocup"), "match", "--blue", "dds:ours",
                                     "--yellow",         "idle",  "--half", "2",
                                     "--match",          id};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

Outcome intruder(const std::string& kind, const std::string& id) {
  return run({program("dds/intruder"), kind, id, "ours"});
}

// Catches a server at which programs of an earlier layout wait in vain, and one that takes them for
// its own.
TEST(Protocol, OtherLayoutsAreToldSoAndDoNotDisturbTheLeg) {
  const std::string id = match_id("versions");
  Running server(match(id));
  const Outcome layout = intruder("layout", id);
  EXPECT_EQ(layout.out.rfind("2 the team cannot be understood: its topics have layout ", 0), 0U)
      << layout.out << layout.err;
  EXPECT_EQ(run(join(id, "blue", "ours", "idle")).exit_code, 0);
  EXPECT_EQ(server.wait().exit_code, 0);
}

// Catches a team of another implementation, whose samples have another form, that is told to have
// been silent.
TEST(Protocol, ASampleThatCannotBeReadIsNoSilence) {
  const std::string id = match_id("unreadable");
  Running server(match(id, {"--join-within", "4"}));
  Running other({program("dds/intruder"), "unreadable", id, "ours"});
  const Outcome played = server.wait();
  EXPECT_TRUE(contains(played.out, "the team joined but did not answer"));
  EXPECT_TRUE(contains(played.out, "a sample of TeamCommand came that could not be read"))
      << played.err;
}

// Catches a team that looks for a firewall because its program is newer than the server.
TEST(Protocol, ATeamNamesTheVersionOfItsServer) {
  const std::string id = match_id("former-server");
  Running server({program("dds/intruder"), "other", id, "ours"});
  const std::string reason = "its server sends mirocup::v2::WorldState";
  const Outcome told = run_until_said(reason, [&](const std::string& limit) {
    return run(join(id, "blue", "ours", "idle", {"--join-within", limit}));
  });
  expect_exit(3, told, reason);
}

// Catches facts that only the teams are told.
TEST(Protocol, SpectatorsAreToldLeagueNamesPeriodAndSpeed) {
  const std::string id = match_id("watched");
  Running server(match(id, {"--league", "middle", "--speed", "4"}));
  const std::string info =
      "ours - idle, league 1, 5 robots, period 0.033, speed 4, field 1.1, same leg 1\n";
  const Outcome spectator = intruder("watch", id);
  EXPECT_EQ(spectator.out, info) << spectator.err;
  // With the configuration that the page gives.
  const Outcome configured = run(
      {"/usr/bin/env", "CYCLONEDDS_URI=file://" MIROCUP_SOURCE_FOLDER "/server/dds/participant.xml",
       program("dds/intruder"), "configured", id, "ours"});
  EXPECT_EQ(configured.out, info) << configured.err;
  // Both have seen the state before the first tick, which is there until the team comes.
  EXPECT_EQ(run(join(id, "blue", "ours", "idle")).exit_code, 0);
  EXPECT_EQ(server.wait().exit_code, 0);
}

// Catches a domain that only one of the two sides uses, or that leaves the ports where they were.
TEST(Protocol, AMatchMayHaveADomainOfItsOwn) {
  const std::string id = match_id("domain");
  Running server(match(id, {"--dds-domain", "7"}));
  ASSERT_TRUE(is_there(server));
  expect_exit(3, run(join(id, "blue", "ours", "idle", {"--join-within", "1"})),
              "no match server answered");
  EXPECT_EQ(run(join(id, "blue", "ours", "idle", {"--dds-domain", "7"})).exit_code, 0);
  EXPECT_EQ(server.wait().exit_code, 0);
  EXPECT_EQ(run(match(id, {"--dds-domain", "231"})).exit_code, 2);
}

// Takes the ports that match servers have in domain 0, as processes of ROS 2 do. Returns none if
// something else has one of them.
std::vector<system::Descriptor> take_ports() {
  std::vector<system::Descriptor> sockets;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  for (std::uint16_t port = 7410; port < 7430; ++port) {
    sockets.emplace_back(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    address.sin_port = htons(port);
    if (bind(sockets.back().get(), reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
      return {};
  }
  return sockets;
}

// Catches a league whose legs stay in domain 0, or of which only the servers move.
TEST(Protocol, ALeagueCanBePlayedBesideRos) {
  if (!is_on_own_host()) GTEST_SKIP() << "other tests need the ports of this computer";
  const auto taken = take_ports();
  if (taken.empty()) GTEST_SKIP() << "something else has these ports";
  expect_exit(3, run(match(match_id("no-port"))), "in DDS domain 0");

  const TemporaryFolder temporary;
  const std::string folder = temporary / "league";
  const std::string config = temporary / "league.json";
  write_file(config, R"({"schema": "mirocup/league/1", "title": "Test", "seed": 5,
      "rules": {"half_s": 2}, "teams": [{"name": "near", "entry": "house:idle"},
      {"name": "far", "entry": "house:keeper", "dds": true}]})");
  ASSERT_EQ(run_mirocup({"league", "init", folder, "--config", config}).exit_code, 0);
  expect_exit(0, run_mirocup({"league", "start", folder, "--dds-domain", "9"}));
  const Outcome status = run_mirocup({"league", "status", folder, "--json"});
  EXPECT_EQ(nlohmann::json::parse(status.out)["played"], 2) << status.out;
}

}  // namespace
}  // namespace mirocup
