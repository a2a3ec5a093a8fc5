// SPDX-License-Identifier: MIT
//
// Secure mode: a process without a certificate of the league, or with another one than the seat's,
// has no effect. The tests use real processes and real certificates.
#include "tests/programs/dds/network.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace mirocup {
namespace {

using namespace test_support;

class Credentials : public testing::Test {
 protected:
  void SetUp() override {
    expect_exit(0, run_mirocup({"league", "credentials", folder_ / "league", "--team", "remote",
                                "--team", "other"}));
  }

  std::string of(const std::string& whose) const {
    return folder_ / ("league/credentials/" + whose);
  }

  std::vector<std::string> match(const std::string& id, const std::string& limit = "60",
                                 const std::string& league = "league") const {
    return {program("mirocup"), "match",
            "--blue",           "dds:remote",
            "--yellow",         "keeper",
            "--match",          id,
            "--credentials",    folder_ / (league + "/credentials/server"),
            "--half",           "5",
            "--join-within",    limit,
            "--record",         folder_ / "leg.json"};
  }

  static std::vector<std::string> join(const std::string& id, const std::string& credentials) {
    return test_support::join(id, "blue", "remote", "striker",
                              {"--join-within", "60", "--credentials", credentials});
  }

  std::string state_hash(const std::string& record) const {
    return read_json(folder_ / record)["state_hash"].get<std::string>();
  }

  TemporaryFolder folder_;
};

// Several intruders attack the leg in turn while the team plays.
TEST_F(Credentials, LetTheTeamPlayAndNobodyElse) {
  const std::string id = match_id("secure");
  Running leg(match(id));
  // The DDS library of an intruder itself refuses another team's or a spectator's certificate.
  for (const std::string whose : {"teams/other", "spectator"}) {
    const Outcome refused = run({program("dds/intruder"), "imitate", id, "remote", of(whose)});
    EXPECT_EQ(refused.exit_code, 1) << whose;
    EXPECT_TRUE(contains(refused.err, "the credentials do not allow"));
  }
  // Another team with permissions that it has signed itself (CVE-2023-24011).
  const std::string forged = folder_ / "forged";
  std::filesystem::copy(of("teams/other"), forged);
  ASSERT_EQ(run({"/bin/sh", "-c",
                 "cd '" + forged +
                     "' && openssl smime -verify -noverify -in permissions.p7s 2>/dev/null |"
                     " sed '1,/^\\r*$/d; s:match-\\*/other:match-*/remote:' >forged.xml &&"
                     " openssl smime -sign -in forged.xml -text -out permissions.p7s"
                     " -signer certificate.pem -inkey key.pem"})
                .exit_code,
            0);
  expect_exit(1, run({program("dds/intruder"), "imitate", id, "remote", forged}));
  // An intruder without credentials, and a forger with a certificate authority of its own.
  Running plain({program("dds/intruder"), "imitate", id, "remote"});
  std::filesystem::copy_file(forged + "/certificate.pem", forged + "/permissions_ca.pem",
                             std::filesystem::copy_options::overwrite_existing);
  Running own_authority({program("dds/intruder"), "imitate", id, "remote", forged});

  Running remote(join(id, of("teams/remote")));
  ASSERT_EQ(leg.wait().exit_code, 0);
  EXPECT_EQ(remote.wait().exit_code, 0);
  run_mirocup({"match", "--blue", "striker", "--yellow", "keeper", "--half", "5", "--record",
               folder_ / "so.json"});
  EXPECT_EQ(state_hash("leg.json"), state_hash("so.json"));
  EXPECT_EQ(read_json(folder_ / "leg.json")["network"]["blue"]["foreign"], 0);
}

// Changed copies of the team's own packets come from its own address. Only their signatures
// distinguish them from its commands.
TEST_F(Credentials, DetectForgedPackets) {
  const std::string id = match_id("forged");
  Running leg(under_garbage(match(id), folder_ / "leaks.txt"));
  Running remote(on_bad_network(join(id, of("teams/remote")), {"BAD_NETWORK_GARBAGE=1"}));
  const Outcome played = leg.wait();
  ASSERT_EQ(played.exit_code, 0) << played.err << remote.err();
  run_mirocup({"match", "--blue", "striker", "--yellow", "keeper", "--half", "5", "--record",
               folder_ / "so.json"});
  EXPECT_EQ(state_hash("leg.json"), state_hash("so.json"));
}

TEST_F(Credentials, RevokedOnesAreRefused) {
  std::filesystem::copy(of("teams/remote"), folder_ / "kept");  // the team keeps its copy
  expect_exit(0, run_mirocup({"league", "credentials", folder_ / "league", "--revoke", "remote"}));
  const std::string id = match_id("revoked");
  Running remote(join(id, folder_ / "kept"));
  run_until_said("revoked", [&](const std::string& limit) { return run(match(id, limit)); });
  const auto fault = read_json(folder_ / "leg.json")["result"]["fault"];
  EXPECT_EQ(fault["code"], "start_timeout");
  EXPECT_TRUE(contains(fault["text"].get<std::string>(), "revoked")) << fault;
}

// The team's own side refuses expired credentials by its clock. If the team turns its clock back,
// the server still refuses them.
TEST_F(Credentials, ExpiredOnesAreRefused) {
  constexpr int then = 100;  // hours ago
  const std::string league = folder_ / "old";
  for (const auto& more : {std::vector<std::string>{"--team", "other"},
                           std::vector<std::string>{"--team", "remote", "--days", "1"}}) {
    std::vector<std::string> make{program("mirocup"), "league", "credentials", league};
    make.insert(make.end(), more.begin(), more.end());
    expect_exit(0, run(behind(then, make)));
  }
  const std::string own = league + "/credentials/teams/remote";
  expect_exit(3, run(join("x", own)), "expired");

  const std::string id = match_id("expired");
  Running turned_back(behind(then - 1, join(id, own)));
  expect_exit(0, run_until_said("expired", [&](const std::string& limit) {
                return run(match(id, limit, "old"));
              }));
  const auto fault = read_json(folder_ / "leg.json")["result"]["fault"];
  EXPECT_EQ(fault["code"], "start_timeout");
  EXPECT_TRUE(contains(fault["text"].get<std::string>(), "expired")) << fault;
}

// New credentials are valid at once on a computer whose clock is behind.
TEST_F(Credentials, AreValidOnAComputerWhoseClockIsBehind) {
  const std::string id = match_id("behind");
  Running remote(behind(1, join(id, of("teams/remote"))));
  expect_exit(0, run(match(id)));
  const auto record = read_json(folder_ / "leg.json");
  EXPECT_EQ(record["result"]["end"], "full_time") << record["result"];
}

// The leg may last longer than the certificate. Catches a team that vanishes in the middle of it,
// of which nobody learns why.
TEST_F(Credentials, ThatExpireBeforeTheLatestEndAreRefused) {
  expect_exit(0, run(behind(22, {program("mirocup"), "league", "credentials", folder_ / "league",
                                 "--team", "remote2", "--days", "1"})));
  const std::vector<std::string> own{"--credentials", of("teams/remote2")};
  for (const std::string colour : {"blue", "yellow"}) {
    const std::string other = colour == "blue" ? "yellow" : "blue";
    const std::string id = match_id("expiring-" + colour);
    Running leg({program("mirocup"), "match", "--" + colour, "dds:remote2", "--" + other, "keeper",
                 "--match", id, "--credentials", of("server"), "--half", "30000"});
    const Outcome joined =
        expect_exit(3, run(test_support::join(id, colour, "remote2", "striker", own)),
                    "warning: the credentials in");
    EXPECT_TRUE(
        contains(joined.err, "refuses the team: the team's credentials are valid until 20"));
    EXPECT_TRUE(has_said(leg, "credentials are valid until 20")) << leg.err();
  }
  // A leg that is over in time is played.
  const std::string id = match_id("in-time");
  Running leg({program("mirocup"), "match", "--blue", "dds:remote2", "--yellow", "keeper",
               "--match", id, "--credentials", of("server"), "--half", "5"});
  EXPECT_EQ(run(test_support::join(id, "blue", "remote2", "striker", own)).exit_code, 0);
  EXPECT_EQ(leg.wait().exit_code, 0);
}

// Catches --revoke '' that deletes the folder of all teams, and keys beside the authority.
TEST_F(Credentials, AreMadeForProperNamesOnly) {
  const auto call = [this](std::vector<std::string> more) {
    more.insert(more.begin(), {program("mirocup"), "league", "credentials", folder_ / "league"});
    return run(more);
  };
  for (const std::string name : {"", ".", "..", "a\nb", "\x7f"}) {
    EXPECT_EQ(call({"--team", name}).exit_code, 2) << name;
    EXPECT_EQ(call({"--revoke", name}).exit_code, 2) << name;
    EXPECT_EQ(call({"--team", "late", "--team", name}).exit_code, 2) << name;
  }
  EXPECT_EQ(call({"--team", std::string(65, 'x')}).exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(of("teams/key.pem")));
  EXPECT_FALSE(std::filesystem::exists(of("key.pem")));
  EXPECT_FALSE(std::filesystem::exists(of("teams/late")));
  EXPECT_TRUE(std::filesystem::exists(of("teams/remote/key.pem")));
}

TEST_F(Credentials, OfAnotherTeamAreRefused) {
  for (const std::string whose : {"teams/other", "spectator", "server"}) {
    const Outcome other = run(join("x", of(whose)));
    EXPECT_EQ(other.exit_code, 2) << whose;
    EXPECT_TRUE(contains(other.err, "somebody else's"));
  }
  expect_exit(2, run(join("x", folder_ / "nothing")), "identity_ca.pem is not there");
}

}  // namespace
}  // namespace mirocup
