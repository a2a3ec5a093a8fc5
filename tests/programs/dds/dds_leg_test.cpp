// SPDX-License-Identifier: MIT
//
// Teams over real Cyclone DDS on the loopback interface.
#include "tests/programs/dds/network.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace mirocup {
namespace {

using namespace test_support;

TEST(DdsTeam, PlaysTheSameLegAsItsLibrary) {
  const TemporaryFolder folder;
  const std::string id = match_id("same");
  Running remote(join(id, "blue", "remote", "striker"));
  const Outcome over_dds =
      run_mirocup({"match", "--blue", "dds:remote", "--yellow", "chaser", "--half", "30", "--match",
                   id, "--record", folder / "dds.json"});
  ASSERT_EQ(over_dds.exit_code, 0) << over_dds.err;
  EXPECT_EQ(remote.wait().exit_code, 0);
  run_mirocup({"match", "--blue", "striker", "--yellow", "chaser", "--half", "30", "--record",
               folder / "so.json"});

  const auto dds = read_json(folder / "dds.json");
  EXPECT_EQ(dds["teams"]["blue"]["kind"], "dds");
  EXPECT_EQ(dds["teams"]["blue"]["name"], "remote");
  EXPECT_TRUE(dds["teams"]["blue"]["sha256"].is_null());
  EXPECT_EQ(dds["result"]["end"], "full_time");
  EXPECT_TRUE(dds["pace"].is_null());
  EXPECT_EQ(dds["state_hash"], read_json(folder / "so.json")["state_hash"]);
  EXPECT_EQ(run_mirocup({"verify", folder / "dds.json"}).exit_code, 0);
}

// Catches a state or an answer that is lost and not sent again, and one that is driven twice.
TEST(DdsTeam, PlaysTheSameLegWhereEveryFifthPacketIsLost) {
  const TemporaryFolder folder;
  const std::string id = match_id("lossy");
  const std::vector<std::string> lossy{"BAD_NETWORK_LOSS=0.2"};
  Running remote(on_bad_network(join(id, "blue", "remote", "striker"), lossy));
  std::vector<std::string> words{program("mirocup"), "match", "--yellow", "chaser", "--half", "5"};
  std::vector<std::string> over_dds = words;
  over_dds.insert(over_dds.end(), {"--blue", "dds:remote", "--match", id, "--join-within", "120",
                                   "--away-limit", "60", "--record", folder / "dds.json"});
  const Outcome played = run(on_bad_network(over_dds, lossy));
  ASSERT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(remote.wait().exit_code, 0);
  words.insert(words.end(), {"--blue", "striker", "--record", folder / "so.json"});
  ASSERT_EQ(run(words).exit_code, 0);
  EXPECT_EQ(read_json(folder / "dds.json")["state_hash"],
            read_json(folder / "so.json")["state_hash"]);
}

// A team at home, whose router drops what is no reply. Catches packets to the address that the team
// lists, packets from another port than that to which the team sends, and a server that forgets a
// team whose router has taken another port.
TEST(DdsTeam, PlaysFromBehindARouterThatTranslatesAddresses) {
  const TemporaryFolder folder;
  for (const char* forgets_after : {"0", "400"}) {
    const std::string id = match_id("nat") + forgets_after;
    Running remote(on_bad_network(join(id, "blue", "remote", "striker"),
                                  {std::string("BAD_NETWORK_NAT=") + forgets_after}));
    const std::vector<std::string> words{"match", "--yellow", "chaser",           "--half",
                                         "10",    "--blue",   "dds:remote",       "--match",
                                         id,      "--record", folder / "dds.json"};
    std::vector<std::string> through = words;
    through.insert(through.end(), {"--nat", "--open"});
    const Outcome played = run_mirocup(through);
    ASSERT_EQ(played.exit_code, 0) << played.err;
    EXPECT_EQ(remote.wait().exit_code, 0);
    ASSERT_EQ(run_mirocup({"match", "--yellow", "chaser", "--half", "10", "--blue", "striker",
                           "--record", folder / "so.json"})
                  .exit_code,
              0);
    EXPECT_EQ(read_json(folder / "dds.json")["state_hash"],
              read_json(folder / "so.json")["state_hash"]);
  }
  EXPECT_EQ(run_mirocup({"match", "--yellow", "chaser", "--blue", "dds:x", "--nat"}).exit_code, 2)
      << "neither credentials nor --open";
  const std::string id = match_id("listed");
  Running remote(on_bad_network(join(id, "blue", "remote", "striker"), {"BAD_NETWORK_NAT=0"}));
  const Outcome without = run_mirocup({"match", "--yellow", "chaser", "--half", "1", "--blue",
                                       "dds:remote", "--match", id, "--join-within", "6"});
  EXPECT_NE(without.out.find("forfeit"), std::string::npos) << without.out;
  EXPECT_TRUE(has_said(remote, "behind a router the match needs --nat")) << remote.err();
}

// Catches a program on the network that loads its library without the parameters.
TEST(DdsTeam, GetsItsParametersFromItsOwnCommandLine) {
  const std::string id = match_id("tuned");
  auto words = join(id, "yellow", "far", program("teams/tuned.so"));
  words.insert(words.end(), {"--param", "speed=8.5", "--param", "spede=1"});
  Running remote(words);
  const Outcome played =
      run_mirocup({"match", "--blue", "idle", "--yellow", "dds:far", "--half", "2", "--match", id});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const Outcome far = remote.wait();
  EXPECT_EQ(far.exit_code, 0);
  EXPECT_NE(far.err.find("team 1 turns at 8.5"), std::string::npos) << far.err;
  EXPECT_NE(far.err.find("did not ask for the parameter spede"), std::string::npos) << far.err;
}

// Plays with each team at either end. Catches poses that get lost on the network, that are
// requested in the wrong tick, or that are turned or rounded by the conversion.
TEST(DdsTeam, StandsWhereItsLibraryWants) {
  const TemporaryFolder folder;
  const std::string id = match_id("places");
  const std::string team = program("honest/places.so");
  const auto play = [&](const std::string& one, const std::string& two, const char* record) {
    return run_mirocup({"match", "--blue", one, "--yellow", two, "--half", "3", "--match", id,
                        "--record", folder / record});
  };
  Running blue(join(id, "blue", "one", team));
  Running yellow(join(id, "yellow", "two", team));
  ASSERT_EQ(play("dds:one", "dds:two", "dds.json").exit_code, 0);
  EXPECT_EQ(blue.wait().exit_code, 0);
  EXPECT_EQ(yellow.wait().exit_code, 0);
  ASSERT_EQ(play(team, team, "so.json").exit_code, 0);
  EXPECT_EQ(read_json(folder / "dds.json")["state_hash"],
            read_json(folder / "so.json")["state_hash"]);
  EXPECT_EQ(run_mirocup({"verify", folder / "dds.json"}).exit_code, 0);
}

// Catches a server that takes the answer to the first tick of a leg that is played on for one to a
// tick that has not begun: both would wait for each other.
TEST(DdsTeam, PlaysOnFromATickOfARecord) {
  const TemporaryFolder folder;
  const std::string id = match_id("on");
  ASSERT_EQ(run_mirocup({"match", "--blue", "idle", "--yellow", "chaser", "--half", "3", "--record",
                         folder / "leg.json"})
                .exit_code,
            0);
  Running remote(join(id, "blue", "remote", "keeper"));
  const Outcome over_dds = run_mirocup({"match", "--blue", "dds:remote", "--yellow", "keeper",
                                        "--from", folder / "leg.json", "--tick", "50", "--match",
                                        id, "--record", folder / "on.json"});
  ASSERT_EQ(over_dds.exit_code, 0) << over_dds.err;
  EXPECT_EQ(remote.wait().exit_code, 0);
  EXPECT_EQ(read_json(folder / "on.json")["result"]["end"], "full_time");
  EXPECT_EQ(run_mirocup({"verify", folder / "on.json"}).exit_code, 0);
}

TEST(DdsTeam, MayMeetAnother) {
  const TemporaryFolder folder;
  const std::string id = match_id("both");
  Running blue(join(id, "blue", "one", "striker"));
  Running yellow(join(id, "yellow", "two", "keeper"));
  const Outcome played = run_mirocup({"match", "--blue", "dds:one", "--yellow", "dds:two", "--half",
                                      "5", "--match", id, "--record", folder / "leg.json"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(blue.wait().exit_code, 0);
  EXPECT_EQ(yellow.wait().exit_code, 0);
  EXPECT_EQ(run_mirocup({"verify", folder / "leg.json"}).exit_code, 0);
}

// Catches a forfeit that does not tell the network's owner where to look.
TEST(DdsTeam, LosesWhenItDoesNotCome) {
  const TemporaryFolder folder;
  for (const std::string interface : {"lo", "127.0.0.1"}) {
    const Outcome played =
        run_mirocup({"match", "--blue", "dds:nobody", "--yellow", "idle", "--half", "5", "--match",
                     match_id("empty"), "--interface", interface, "--join-within", "1", "--record",
                     folder / "leg.json"});
    EXPECT_EQ(played.exit_code, 0) << played.err;
    const auto fault = read_json(folder / "leg.json")["result"]["fault"];
    EXPECT_EQ(fault["code"], "start_timeout");
    const bool is_lo = interface == "lo";
    const std::string told =
        is_lo ? "with --interface lo, the team must run on this computer"
              : "this host's firewalls must let in UDP to ports 7410-7429 of 127.0.0.1";
    EXPECT_NE(fault["text"].get<std::string>().find(told), std::string::npos) << fault;
    EXPECT_EQ(played.err.find("can be joined from this computer only") != std::string::npos, is_lo);
  }
}

// Catches an end that waits for a packet to itself: here none arrives.
TEST(DdsTeam, EndsWhereAllPacketsAreLost) {
  const auto exit_code_of = [](std::vector<std::string> words) {
    words.insert(words.end(), {"--join-within", "1"});
    words = on_bad_network(words, {"BAD_NETWORK_LOSS=1"});
    words.insert(words.begin(), {"/usr/bin/timeout", "--signal=KILL", "100"});
    return run(words).exit_code;
  };
  const std::string id = match_id("lost");
  EXPECT_EQ(exit_code_of(join(id, "blue", "alone", "idle")), 3);
  EXPECT_EQ(exit_code_of({program("mirocup"), "match", "--blue", "dds:nobody", "--yellow", "idle",
                          "--half", "5", "--match", id}),
            0);
}

// The match waits for two absent teams at the same time, not one after the other.
TEST(DdsTeam, IsWaitedForTogetherWithTheOther) {
  const TemporaryFolder folder;
  const Outcome played =
      run_mirocup({"match", "--blue", "dds:nobody", "--yellow", "dds:noone", "--match",
                   match_id("none"), "--join-within", "1", "--record", folder / "leg.json"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "double_forfeit");
  for (const auto& fault : record["result"]["faults"]) EXPECT_EQ(fault["code"], "start_timeout");
}

TEST(DdsTeam, IsToldThatItsNameIsNotExpected) {
  const std::string id = match_id("name");
  Running match({program("mirocup"), "match", "--blue", "dds:expected", "--yellow", "idle",
                 "--half", "5", "--match", id, "--join-within", "60"});
  const std::string reason = "does not expect a team called \"stranger\"";
  const Outcome stranger = run_until_said(reason, [&id](const std::string& patience) {
    auto arguments = join(id, "blue", "stranger", "idle");
    arguments.insert(arguments.end(), {"--patience", patience});
    return run(arguments);
  });
  EXPECT_EQ(stranger.exit_code, 3);
  EXPECT_NE(stranger.err.find(reason), std::string::npos) << stranger.err;
}

// Each side reacts to Ctrl-C while it waits for the other.
TEST(DdsTeam, CanBeInterruptedWhileItIsAwaited) {
  Running server({program("mirocup"), "match", "--blue", "dds:nobody", "--yellow", "idle",
                  "--match", "interrupted-server"});
  Running team({program("mirocup"), "join", "--match", "interrupted-team", "--team", "blue",
                "--name", "lonely", program("house/idle.so")});
  ASSERT_TRUE(is_there(server));
  ASSERT_TRUE(is_there(team));
  server.signal(SIGINT);
  team.signal(SIGTERM);
  EXPECT_EQ(server.wait().exit_code, 130);
  EXPECT_EQ(team.wait().exit_code, 130);
}

}  // namespace
}  // namespace mirocup
