// SPDX-License-Identifier: MIT
//
// Leagues in which programs play that speak FIRASim's protocol, beside libraries and teams over
// DDS.
#include "tests/programs/league/league_command.hpp"

#include <filesystem>

namespace mirocup {
namespace {

using Json = nlohmann::ordered_json;
using namespace test_support;

constexpr const char* examples = MIROCUP_SOURCE_FOLDER "/examples/firasim";

// Below those that a match finds for itself, and those of the other tests here.
std::string instance_of_people() {
  return std::to_string(1 + getpid() % 999);
}

void make_mixed_league(const std::string& folder, const Json& teams) {
  const Json config{{"schema", "mirocup/league/1"},
                    {"rules", {{"half_s", 4}, {"ready_s", 0.33}}},
                    {"seed", 4},
                    {"firasim", {{"instance", std::stoi(instance_of_people())}}},
                    {"teams", teams}};
  write_file(folder + ".json", config.dump());
  expect_exit(0, run(league("init", folder, {"--config", folder + ".json"})));
}

// Returns how many seats of the records played over FIRASim, and verifies each record.
int firasim_seats(const std::string& folder) {
  int seats = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder + "/records")) {
    if (file.path().extension() != ".json") continue;
    const Json record = read_json(file.path());
    EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
    for (const char* colour : {"blue", "yellow"}) {
      if (record["teams"][colour]["kind"] != "firasim") continue;
      ++seats;
      EXPECT_EQ(record["network"][colour]["processes"], 1);
      EXPECT_EQ(record["network"][colour]["in_step"], record["ticks"]);
    }
    expect_exit(0, run_mirocup({"verify", file.path()}));
  }
  return seats;
}

// Catches two legs at once that hear each other, a program that is told the other colour, and one
// that outlives its leg.
TEST(FirasimLeague, StartsProgramsBesideTeamsOfOtherKinds) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "mixed";
  const std::string run_it = "python3 -B chaser.py $MIROCUP_COLOUR --instance $MIROCUP_INSTANCE";
  make_mixed_league(folder, {{{"name", "near"}, {"entry", "house:idle"}},
                             {{"name", "far"}, {"entry", "house:keeper"}, {"dds", true}},
                             {{"name", "one"},
                              {"entry", "firasim:one"},
                              {"folder", examples},
                              {"run", run_it},
                              {"lockstep", true}},
                             {{"name", "two"},
                              {"entry", "firasim:two"},
                              {"folder", examples},
                              {"run", run_it},
                              {"lockstep", true}}});
  expect_exit(0, run(league("start", folder, {"--jobs", "3"})));
  EXPECT_EQ(firasim_seats(folder), 12);
  const std::string journal = read_file(folder + "/journal.jsonl");
  EXPECT_EQ(run(league("start", folder)).exit_code, 0);
  EXPECT_EQ(read_file(folder + "/journal.jsonl"), journal) << "played again";
}

// Catches a league that waits for people without saying for whom, and one that looks for their
// programs elsewhere than league.json says.
TEST(FirasimLeague, WaitsForProgramsThatPeopleStart) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "people";
  make_mixed_league(folder, {{{"name", "near"}, {"entry", "house:idle"}}});
  expect_exit(0, run(league("submit", folder, {"far", "firasim:far", "--lockstep"})));
  Running host(league("start", folder));
  for (int leg = 1; leg <= 2; ++leg) {
    ASSERT_TRUE(wait_until([&] {
      return host.err().find("leg " + std::to_string(leg) + ": far plays ") != std::string::npos;
    })) << host.err();
    const std::string colour =
        host.err().find("leg " + std::to_string(leg) + ": far plays blue") != std::string::npos
            ? "blue"
            : "yellow";
    Running far({"/usr/bin/env", "python3", "-B", std::string(examples) + "/chaser.py", colour,
                 "--instance", instance_of_people()});
    EXPECT_EQ(far.wait().exit_code, 0);
  }
  expect_exit(0, host.wait());
  EXPECT_EQ(firasim_seats(folder), 2);
  const Outcome late = run(league("submit", folder, {"far", "firasim:far"}));
  EXPECT_EQ(late.exit_code, 1) << "a league that has started changes no team";
}

// Catches a host's typing error that costs a team its league, and a program that fails and is
// waited for until the time to join is over.
TEST(FirasimLeague, TellsAProgramThatIsNotThereFromOneThatFails) {
  const TemporaryFolder folder;
  const auto play = [&](const std::string& command) {
    return run_mirocup({"match", "--blue", "firasim:x", "--yellow", "idle", "--firasim-instance",
                        "auto", "--blue-program", command, "--lockstep", "--record",
                        folder / "leg.json"});
  };
  expect_exit(5, play("no-such-program-here"));
  EXPECT_EQ(play("exit 3").exit_code, 0);
  const Json record = read_json(folder / "leg.json");
  EXPECT_EQ(record["result"]["fault"]["code"], "crash");
  EXPECT_TRUE(contains(record["result"]["fault"]["text"].get<std::string>(), "ended with code 3"));
  expect_exit(
      2, run_mirocup({"match", "--blue", "idle", "--yellow", "idle", "--blue-program", "true"}));
}

}  // namespace
}  // namespace mirocup
