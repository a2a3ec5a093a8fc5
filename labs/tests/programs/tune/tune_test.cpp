// SPDX-License-Identifier: MIT
//
// `mirocup tune` as a person runs it. Catches a search that plays again what it has played, that
// comes to another end after it was killed, and a slip that is taken silently.
#include "tests/programs/league/league_command.hpp"
#include "tests/support/temporary_folder.hpp"

#include <csignal>

namespace mirocup::test_support {
namespace {

// Legs of two seconds, and few of them.
std::vector<std::string> tune_words(const std::vector<std::string>& more) {
  std::vector<std::string> words{
      program("mirocup"), "tune", "striker",    "--half", "1",      "--against", "idle",
      "--generations",    "2",    "--fixtures", "2",      "--test", "10",        "--json"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Tune, ComesToTheSameEndAfterItWasKilled) {
  const TemporaryFolder folder;
  const std::string whole = folder / "whole";
  const std::string killed = folder / "killed";
  const std::vector<std::string> parameter{"--param", "nothing=0.1:0.9"};
  const auto into = [&](const std::string& output) {
    std::vector<std::string> words = tune_words(parameter);
    words.insert(words.end(), {"-o", output});
    return words;
  };
  const Outcome end = run(into(whole));
  EXPECT_EQ(end.exit_code, 1) << "a parameter that no team asks for gains nothing: " << end.err;
  const auto json = nlohmann::json::parse(end.out);
  EXPECT_EQ(json["gained"], false);
  EXPECT_EQ(json["points"]["high"], 0.0);
  EXPECT_GE(json["parameters"]["nothing"], 0.1);
  EXPECT_LE(json["parameters"]["nothing"], 0.9);
  EXPECT_NE(end.err.find("no team asked for the parameter nothing"), std::string::npos) << end.err;
  EXPECT_NE(read_file(whole + "/course.svg").find("</svg>"), std::string::npos);
  {
    Running first(into(killed));
    EXPECT_TRUE(wait_until([&] { return std::filesystem::exists(killed + "/tune.json"); }));
    first.signal(SIGKILL);
    first.wait();
  }
  EXPECT_EQ(run(into(killed)).out, end.out);
  EXPECT_EQ(read_file(killed + "/tune.json"), read_file(whole + "/tune.json"));
  const Outcome again = run(into(whole));
  EXPECT_EQ(again.out, end.out);
  EXPECT_NE(again.err.find("known already"), std::string::npos) << again.err;
}

TEST(Tune, RefusesWhatItDoesNotUnderstand) {
  const TemporaryFolder folder;
  for (const std::string slip : {"wait", "wait=1", "wait=2:1", "=0:1", "wait=0:1x"}) {
    const Outcome refused = run(tune_words({"--param", slip, "-o", folder / "tune"}));
    EXPECT_EQ(refused.exit_code, 2) << slip;
    EXPECT_NE(refused.err.find("KEY=LOW:HIGH"), std::string::npos) << refused.err;
  }
  const Outcome twice =
      run(tune_words({"--param", "a=0:1", "--param", "a=0:2", "-o", folder / "tune"}));
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_NE(twice.err.find("twice"), std::string::npos) << twice.err;
}

}  // namespace
}  // namespace mirocup::test_support
