// SPDX-License-Identifier: MIT
//
// Teams over real Cyclone DDS on the loopback interface.
#include "tests/programs/dds/network.hpp"

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <iostream>

namespace mirocup {
namespace {

using namespace test_support;

TEST(DdsTeam, PlaysTheSameLegAsItsLibrary) {
  const TemporaryFolder folder;
  const std::string id = match_id("same");
  Running remote(join(id, "blue", "remote", "striker"));
  expect_exit(0, run_mirocup({"match", "--blue", "dds:remote", "--yellow", "chaser", "--half", "30",
                              "--match", id, "--record", folder / "dds.json"}));
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

// A team at home, whose router drops what is no reply. Catches packets to the address that the team
// lists, packets from another port than that to which the team sends, and a team that does not come
// back after its router has taken another address, or after its wire was cut.
TEST(DdsTeam, PlaysFromBehindARouterThatTranslatesAddresses) {
  const TemporaryFolder folder;
  const auto play = [](std::vector<std::string> more) {
    more.insert(more.begin(), {"match", "--yellow", "chaser", "--half", "10"});
    return run_mirocup(more);
  };
  ASSERT_EQ(play({"--blue", "striker", "--record", folder / "so.json"}).exit_code, 0);
  const std::vector<std::vector<std::string>> wires{
      {"BAD_NETWORK_NAT=0"}, {"BAD_NETWORK_NAT=400"}, {"BAD_NETWORK_NAT=0", "BAD_NETWORK_CUT=400"}};
  for (std::size_t i = 0; i < wires.size(); ++i) {
    const std::string id = match_id("nat") + std::to_string(i);
    Running remote(on_bad_network(join(id, "blue", "remote", "striker"), wires[i]));
    expect_exit(0, play({"--nat", "--open", "--blue", "dds:remote", "--match", id, "--away-limit",
                         "60", "--record", folder / "dds.json"}));
    EXPECT_EQ(remote.wait().exit_code, 0);
    const auto record = read_json(folder / "dds.json");
    EXPECT_EQ(record["state_hash"], read_json(folder / "so.json")["state_hash"]) << i;
    EXPECT_EQ(record["network"]["blue"]["absences"].empty(), i == 0) << record["network"];
  }
  EXPECT_EQ(play({"--blue", "dds:x", "--nat"}).exit_code, 2) << "neither credentials nor --open";
  const std::string id = match_id("listed");
  Running remote(on_bad_network(join(id, "blue", "remote", "striker"), {"BAD_NETWORK_NAT=0"}));
  const Outcome without = play({"--blue", "dds:remote", "--match", id, "--join-within", "6"});
  EXPECT_TRUE(contains(without.out, "a participant was seen, but no connection to it came about"))
      << without.err;
  EXPECT_TRUE(has_said(remote, "behind a router the match needs --nat")) << remote.err();
}

// Two teams behind one router play over wires with delay and loss. Catches states and answers that
// are lost and not sent again, or driven twice; late answers that are thrown away, or not told. In
// real time no more is expected, because a busy machine is late, too. MIROCUP_HALF=15
// build/dds_tests --gtest_filter='*LongWires*' prints the shares of server/dds/README.md.
void expect_long_wires_play(bool is_secure) {
  const char* asked = std::getenv("MIROCUP_HALF");
  const TemporaryFolder folder;
  run_mirocup({"league", "credentials", folder / "league", "--team", "one", "--team", "two"});
  const auto credentials = [&](const std::string& whose) -> std::vector<std::string> {
    if (is_secure) return {"--credentials", folder / "league/credentials/" + whose};
    return {};
  };
  const auto play = [&](const std::string& blue, const std::string& yellow, const char* record) {
    return std::vector<std::string>{
        program("mirocup"),  "match",    "--blue",       blue, "--yellow", yellow, "--half",
        asked ? asked : "1", "--record", folder / record};
  };
  run(play("striker", "striker", "so.json"));
  using Row = std::array<std::string, 3>;  // ms one way, share of lost packets, speed
  for (const auto& [ms, loss, speed] :
       {Row{"0", "0", "1"}, Row{"5", "0", "1"}, Row{"5", "0.01", "1"}, Row{"5", "0.05", "1"},
        Row{"10", "0", "1"}, Row{"10", "0.01", "1"}, Row{"10", "0.05", "1"}, Row{"20", "0.01", "1"},
        Row{"20", "0.05", "max"}, Row{"0", "0.2", "max"}}) {
    const std::string id = match_id("wire") + ms + loss + speed;
    std::vector<std::string> wire{"BAD_NETWORK_DELAY=" + ms, "BAD_NETWORK_LOSS=" + loss};
    auto server = play("dds:one", "dds:two", "dds.json");
    for (const auto& more : {std::vector<std::string>{"--match", id, "--speed", speed, "--nat",
                                                      "--open", "--away-limit", "60"},
                             credentials("server")}) {
      server.insert(server.end(), more.begin(), more.end());
    }
    Running leg(on_bad_network(server, wire));
    wire.emplace_back("BAD_NETWORK_NAT=0");
    const auto team = [&](const char* colour, const std::string& name) {
      return on_bad_network(join(id, colour, name, "striker", credentials("teams/" + name)), wire);
    };
    Running blue(team("blue", "one"));
    Running yellow(team("yellow", "two"));
    const Outcome played = expect_exit(0, leg.wait());
    const auto record = read_json(folder / "dds.json");
    EXPECT_EQ(record["result"]["end"], "full_time") << record["result"];
    std::cout << ms << " ms, loss " << loss << ", speed " << speed << ": " << record["ticks"]
              << " ticks";
    for (const char* colour : {"blue", "yellow"}) {
      const auto& network = record["network"][colour];
      std::cout << "; in step " << network["in_step"] << ", late driven " << network["late_driven"]
                << ", median " << network["answers"]["p50"];
      if (ms != "20" || speed == "max") continue;
      EXPECT_GT(network["late_driven"], 0) << network;
      EXPECT_LE(network["late_driven"], record["budget"][colour]["late_ticks"]);
      EXPECT_TRUE(contains(played.err, "too late; the robots drive the last command that came"));
    }
    std::cout << '\n';
    if (speed != "max") continue;
    EXPECT_EQ(record["state_hash"], read_json(folder / "so.json")["state_hash"]);
  }
}

TEST(DdsTeam, PlaysOverLongWires) {
  expect_long_wires_play(false);
}

TEST(DdsTeam, PlaysOverLongWiresWithCredentials) {
  expect_long_wires_play(true);
}

// Catches a program on the network that loads its library without the parameters.
TEST(DdsTeam, GetsItsParametersFromItsOwnCommandLine) {
  const std::string id = match_id("tuned");
  Running remote(join(id, "yellow", "far", program("teams/tuned.so"),
                      {"--param", "speed=8.5", "--param", "spede=1"}));
  expect_exit(0, run_mirocup({"match", "--blue", "idle", "--yellow", "dds:far", "--half", "2",
                              "--match", id}));
  const Outcome far = expect_exit(0, remote.wait(), "team 1 turns at 8.5");
  EXPECT_TRUE(contains(far.err, "did not ask for the parameter spede"));
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
  expect_exit(0, run_mirocup({"match", "--blue", "dds:remote", "--yellow", "keeper", "--from",
                              folder / "leg.json", "--tick", "50", "--match", id, "--record",
                              folder / "on.json"}));
  EXPECT_EQ(remote.wait().exit_code, 0);
  EXPECT_EQ(read_json(folder / "on.json")["result"]["end"], "full_time");
  EXPECT_EQ(run_mirocup({"verify", folder / "on.json"}).exit_code, 0);
}

// Catches a forfeit that does not tell the network's owner where to look, and a match that waits
// for two absent teams one after the other: the first would lose alone.
TEST(DdsTeam, LosesWhenItDoesNotCome) {
  const TemporaryFolder folder;
  for (const std::string interface : {"lo", "127.0.0.1"}) {
    const Outcome played = expect_exit(
        0, run_mirocup({"match", "--blue", "dds:nobody", "--yellow", "dds:noone", "--half", "5",
                        "--match", match_id("empty"), "--interface", interface, "--join-within",
                        "1", "--record", folder / "leg.json"}));
    const auto result = read_json(folder / "leg.json")["result"];
    EXPECT_EQ(result["end"], "double_forfeit");
    const bool is_lo = interface == "lo";
    const std::string told =
        is_lo ? "with --interface lo, the team must run on this computer"
              : "this host's firewalls must let in UDP to ports 7410-7429 of 127.0.0.1";
    for (const auto& fault : result["faults"]) {
      EXPECT_EQ(fault["code"], "start_timeout");
      EXPECT_TRUE(contains(fault["text"].get<std::string>(), told)) << fault;
    }
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

TEST(DdsTeam, IsToldThatItsNameIsNotExpected) {
  const std::string id = match_id("name");
  Running match({program("mirocup"), "match", "--blue", "dds:expected", "--yellow", "idle",
                 "--half", "5", "--match", id, "--join-within", "60"});
  const std::string reason = "does not expect a team called \"stranger\"";
  const Outcome told = run_until_said(reason, [&id](const std::string& limit) {
    return run(join(id, "blue", "stranger", "idle", {"--join-within", limit}));
  });
  expect_exit(3, told, reason);
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
