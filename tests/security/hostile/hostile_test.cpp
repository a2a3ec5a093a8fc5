// SPDX-License-Identifier: MIT
//
// A team that misbehaves hurts only itself, whatever its colour. The other team and the server go
// on, nothing outside changes, no process remains, and the record names the fault.
#include "tests/security/hostile/kinds.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mirocup {
namespace {

using namespace test_support;
using Json = nlohmann::ordered_json;

std::string hostile(const std::string& name) {
  return program("hostile/" + name + ".so");
}

// The folder that strategies attack. Every user may read and write there; a strategy must not.
const std::string target = MIROCUP_TARGET;
const std::string secret = "the secret of the server";
const std::string untouched = "as it was";

void prepare_target() {
  std::filesystem::create_directories(target);
  chmod(target.c_str(), 0777);
  if (read_file(target + "/secret") == secret) return;
  write_file(target + "/secret", secret);
  write_file(target + "/record", untouched);
  chmod((target + "/record").c_str(), 0666);
}

void expect_target_is_untouched() {
  EXPECT_EQ(read_file(target + "/record"), untouched);
  EXPECT_FALSE(std::filesystem::exists(target + "/dropped"));
  EXPECT_FALSE(std::filesystem::exists(target + "/record.old"));
}

// The user as which the server runs: the caller of the test, or the system's user `nobody`.
enum class User { caller, nobody };

struct SetUp {
  std::string isolation;
  User user;
  std::string colour;  // of the hostile team
};

// Returns set-ups with both tiers and both colours; if the test runs as root, also with a server
// that does not.
std::vector<SetUp> set_ups() {
  std::vector<SetUp> all{{"T2", User::caller, "blue"}, {"T1", User::caller, "yellow"}};
  if (geteuid() == 0) {
    all.push_back({"T2", User::nobody, "yellow"});
    all.push_back({"T1", User::nobody, "blue"});
  }
  return all;
}

std::string other_than(const std::string& colour) {
  return colour == "blue" ? "yellow" : "blue";
}

struct Leg {
  Outcome outcome;
  Json record;
  std::string log;  // of the hostile team
};

// A leg that is being played.
class Playing {
 public:
  // `kind`: the name of the hostile team.
  Playing(const SetUp& set_up, const std::string& kind) : colour_(set_up.colour) {
    std::vector<std::string> words{program("mirocup")};
    std::string library = hostile(kind);
    if (set_up.user == User::nobody) {
      chmod((folder_ / "").c_str(), 0777);
      words = mirocup_of_nobody();
      library = program_for_all("hostile/" + kind + ".so");
    }
    words.insert(words.end(),
                 {"match", "--" + colour_, library, "--" + other_than(colour_), "chaser", "--half",
                  "2", "--isolation", set_up.isolation, "--record", folder_ / "leg.json"});
    program_.emplace(words);
  }

  Leg end() {
    Leg leg;
    leg.outcome = program_->wait();
    EXPECT_EQ(leg.outcome.exit_code, 0) << leg.outcome.err;
    if (leg.outcome.exit_code != 0) return leg;
    leg.record = read_json(folder_ / "leg.json");
    leg.log = read_file(folder_ / ("leg.json." + colour_ + ".log"));
    EXPECT_EQ(run_mirocup({"verify", folder_ / "leg.json"}).exit_code, 0);
    return leg;
  }

 private:
  std::string colour_;  // of the hostile team
  TemporaryFolder folder_{place_for_all};
  std::optional<Running> program_;
};

Leg play(const SetUp& set_up, const std::string& kind) {
  return Playing(set_up, kind).end();
}

// "code: text", "code" or "plays"; alternatives are separated by '|'.
bool is_outcome(const Json& result, const std::string& expected) {
  const auto bar = expected.find('|');
  if (bar != std::string::npos) {
    return is_outcome(result, expected.substr(0, bar)) ||
           is_outcome(result, expected.substr(bar + 1));
  }
  if (expected == "plays") return result["end"] == "full_time" && result["fault"].is_null();
  if (result["end"] != "forfeit") return false;
  const std::string code = expected.substr(0, expected.find(": "));
  const std::string text = code == expected ? "" : expected.substr(code.size() + 2);
  return result["fault"]["code"] == code &&
         result["fault"]["text"].get<std::string>().find(text) != std::string::npos;
}

// A process that a match leaves behind becomes a child of this process.
void expect_nothing_is_left() {
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

// The one line that a kind must have written, so that its attempt is known to have been made.
const std::vector<std::pair<std::string, std::string>> signs{
    {"ctor_ready", "plays from its constructor"}};

class Hostile : public testing::TestWithParam<Kind> {
 protected:
  void SetUp() override {
    prepare_target();
    if (GetParam().outcome == burns_start) setenv("MIROCUP_START_LIMIT", start_limit, 1);
    setenv("MIROCUP_TEST_SECRET", secret.c_str(), 1);
    prctl(PR_SET_CHILD_SUBREAPER, 1);
  }
};
INSTANTIATE_TEST_SUITE_P(Teams, Hostile, testing::ValuesIn(kinds),
                         [](const auto& c) { return c.param.name; });

TEST_P(Hostile, HurtsOnlyItself) {
  auto all = set_ups();
  if (!why_no_t2().empty()) {
    std::erase_if(all, [](const auto& set_up) { return set_up.isolation == "T2"; });
  }
  // All at the same time, because some of them take long without doing anything.
  std::vector<std::unique_ptr<Playing>> playing;
  for (const auto& set_up : all) {
    playing.push_back(std::make_unique<Playing>(set_up, GetParam().name));
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& set_up = all[i];
    SCOPED_TRACE(set_up.isolation + (set_up.user == User::nobody ? ", nobody" : ""));
    const Leg leg = playing[i]->end();
    if (leg.record.is_null()) continue;
    const bool is_in_t1 = set_up.isolation == "T1" && !GetParam().in_t1.empty();
    const std::string expected = is_in_t1 ? GetParam().in_t1 : GetParam().outcome;
    const Json& result = leg.record["result"];
    EXPECT_TRUE(is_outcome(result, expected)) << "not " << expected << " but " << result.dump();
    EXPECT_EQ(leg.record["isolation"], set_up.isolation);
    if (!result["fault"].is_null()) {
      EXPECT_EQ(result["fault"]["team"], set_up.colour);
      EXPECT_EQ(result["winner"], other_than(set_up.colour));
    }
    EXPECT_EQ(leg.record["budget"][other_than(set_up.colour)]["bad_commands"], 0);
    EXPECT_FALSE(contains(leg.log, "GOT THROUGH"));
    EXPECT_FALSE(contains(leg.log, secret));
    for (const auto& [name, sign] : signs) {
      if (name != GetParam().name) continue;
      EXPECT_TRUE(contains(leg.log, sign));
    }
    expect_target_is_untouched();
  }
  expect_nothing_is_left();
  if (!why_no_t2().empty()) GTEST_SKIP() << why_no_t2();
}

// Catches a source without a line in the table: no test would play it.
TEST(HostileTable, HasEveryKind) {
  std::size_t sources = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(MIROCUP_SOURCE_FOLDER "/tests/security/hostile/kinds")) {
    ++sources;
    const std::string name = file.path().stem();
    EXPECT_TRUE(std::any_of(kinds.begin(), kinds.end(), [&](const Kind& kind) {
      return kind.name == name;
    })) << name;
  }
  EXPECT_EQ(sources, kinds.size());
}

TEST(HostileTeam, NonsenseAnswersAreCountedAsBadCommands) {
  const Leg leg = play({"T1", User::caller, "blue"}, "out_nan");
  EXPECT_GT(leg.record["budget"]["blue"]["bad_commands"], 50);
}

TEST(HostileTeam, NonsensePlacementsAreFixed) {
  const Leg leg = play({"T1", User::caller, "blue"}, "place_nonsense");
  const auto fixes = std::count_if(
      leg.record["decisions"].begin(), leg.record["decisions"].end(), [](const Json& decision) {
        return decision["decision"] == "PLACEMENT_FIXED" && decision["team"] == "blue";
      });
  EXPECT_GE(fixes, 2) << "the kick-offs of both halves";
}

TEST(HostileTeam, OnBothSidesLosesForBoth) {
  const TemporaryFolder folder;
  run_mirocup({"match", "--blue", hostile("crash_segv"), "--yellow", hostile("crash_segv"),
               "--half", "2", "--record", folder / "leg.json"});
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["end"], "double_forfeit");
  EXPECT_TRUE(record["result"]["winner"].is_null());
}

TEST(HostileTeam, LogIsKeptUpToALimit) {
  const Leg leg = play({"T1", User::caller, "blue"}, "log_flood");
  EXPECT_EQ(leg.log.rfind("tick 25: a line that nobody asked for, 0\n", 0), 0u);
  EXPECT_TRUE(contains(leg.log, "bytes are left out here"));
  EXPECT_LE(leg.log.size(), 131072u) << "64 KiB and the ticks of its lines";
}

TEST(HostileTeam, LogHasNoControlCharacters) {
  const Leg leg = play({"T1", User::caller, "blue"}, "log_escape");
  EXPECT_EQ(
      leg.log.rfind(
          "tick 25: \\x1b[2J\\x1b]0;title\\x07\\xc2\\x9b1m\\xff\\xe2\\x80\\xae<script>\\x0d\n", 0),
      0u)
      << leg.log.substr(0, 200);
}

// In real time the match does not wait for a team: its robots drive on, then stand, and finally it
// loses. These tests count ticks, not time, so a busy machine does not change the results: a team
// that never answers is late in every tick.
class RealTime : public testing::Test {
 protected:
  Json play(const std::string& name, const std::string& half, const std::string& speed) const {
    run_mirocup({"match", "--blue", hostile(name), "--yellow", "idle", "--speed", speed, "--half",
                 half, "--record", folder_ / "leg.json"});
    return read_json(folder_ / "leg.json");
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(RealTime, GoesOnWithoutATeamThatNeverAnswers) {
  const Json record = play("sleep_forever", "0.5", "1");
  EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
  constexpr int last_answered = 25;  // hostile_tick: the first one without an answer
  EXPECT_GT(record["ticks"], last_answered);
  EXPECT_GE(record["budget"]["blue"]["late_ticks"], record["ticks"].get<int>() - last_answered);
}

TEST_F(RealTime, EndsTheLegWhenATeamIsLateTooOftenInARow) {
  const Json record = play("sleep_forever", "60", "10");
  EXPECT_EQ(record["result"]["fault"]["code"], "hang") << record["result"].dump();
  EXPECT_EQ(record["result"]["fault"]["text"], "the team was late 91 times in a row");
  EXPECT_GE(record["budget"]["blue"]["late_ticks"], 90);
}

// 50 ms of processor time for each tick of 33 ms: the team answers, but not in time.
TEST_F(RealTime, TakesATeamBackThatAnswersLate) {
  const Json record = play("slow_bank", "0.5", "1");
  EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
}

TEST(HostileTeam, ExceptionInTheServersOwnProcessIsACrash) {
  const TemporaryFolder folder;
  expect_exit(0, run_mirocup({"match", "--trusted", "--blue", hostile("throw_std"), "--yellow",
                              "idle", "--half", "2", "--record", folder / "leg.json"}));
  const auto record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["fault"]["code"], "crash");
  EXPECT_EQ(record["isolation"], "none");
}

}  // namespace
}  // namespace mirocup
