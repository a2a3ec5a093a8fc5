// SPDX-License-Identifier: MIT
//
// Teams in Python, as their users run them. Catches a sandbox that lets Python open a file, a leg
// that is another one in the sandbox than with --trusted, and an advice that is for C++.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace mirocup {
namespace {

using namespace test_support;
using PythonJson = nlohmann::ordered_json;

constexpr const char* import = "from mirocup.team import *\n";

// A class whose decide() has this body.
std::string team_that(const std::string& body, const std::string& before = "") {
  return import + before + "class A(Team):\n    def decide(self, now):\n        " + body + "\n";
}

class PythonTeams : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(program("mirocup-python-host"))) GTEST_SKIP() << "not built";
  }

  std::string file(const std::string& text) {
    const std::string path = folder_ / "team.py";
    write_file(path, text);
    return path;
  }
  PythonJson check(const std::string& text, int exit_code) {
    const Outcome outcome = run_mirocup({"check", file(text), "--half", "4", "--json"});
    EXPECT_EQ(outcome.exit_code, exit_code) << text << outcome.out << outcome.err;
    return PythonJson::parse(outcome.out, nullptr, false);
  }

  TemporaryFolder folder_;
};

TEST_F(PythonTeams, PlayTheSameLegInEachSandboxAndWithoutOne) {
  // A helper that mixes up two numbers would end the leg.
  const std::string path = file(
      team_that("assert ball(now) == (now.ball_x, now.ball_y)\n        "
                "assert ball_velocity(now) == (now.ball_vx, now.ball_vy)\n        "
                "assert moving_ball(now) == (ball(now), ball_velocity(now))\n        "
                "return [drive_to(self.setup, r, (now.ball_x, now.ball_y + random.random() / 50)) "
                "for r in now.own]",
                "import random\nfrom mirocup.team import ball, ball_velocity, moving_ball\n"));
  std::string first;
  for (const std::vector<std::string>& how :
       {std::vector<std::string>{}, {"--isolation", "T1"}, {"--trusted"}}) {
    std::vector<std::string> words{program("mirocup"), "match",  "--blue", path,    "--yellow",
                                   "chaser",           "--half", "10",     "--hash"};
    words.insert(words.end(), how.begin(), how.end());
    const Outcome outcome = expect_exit(0, run(words));
    EXPECT_TRUE(contains(outcome.out, "full_time"));
    if (first.empty()) first = outcome.out;
    EXPECT_EQ(outcome.out, first);
  }
}

// An editor of Windows writes a mark before the first line.
TEST_F(PythonTeams, PlayAsWindowsWritesThem) {
  std::string text = team_that("return [(1, 1)] * 3");
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
    text.insert(at, "\r");
  const Outcome outcome = run_mirocup(
      {"match", "--blue", file("\xef\xbb\xbf" + text), "--yellow", "idle", "--half", "1"});
  EXPECT_TRUE(contains(outcome.out, "full_time")) << outcome.err;
}

TEST_F(PythonTeams, AreToldWhatTheFileLacks) {
  expect_exit(2, run_mirocup({"match", "--blue", file("x = 1\n"), "--yellow", "idle"}),
              "\"from mirocup.team import Team\"");
}

TEST_F(PythonTeams, AreAcceptedWithTheirParametersAndPlaces) {
  const PythonJson report = check(
      import + std::string("class A(Team):\n"
                           "    def __init__(self, setup):\n"
                           "        super().__init__(setup)\n"
                           "        print('speed', self.parameter('speed', 4.5), setup.robots)\n"
                           "    def decide(self, now):\n"
                           "        return [(5, 5), None]\n"
                           "    def place(self, now, placement):\n"
                           "        placement.robots[2] = (-0.3, 0.2, 0.0)\n"),
      0);
  EXPECT_EQ(report["log"], "speed 4.5 3\n");
  EXPECT_TRUE(report["reason"].is_null());
}

// Each mistake is another one. Catches a sentence that leaves out the line, or does not say what to
// do.
TEST_F(PythonTeams, AreRefusedWithTheLineAndAnAdvice) {
  const struct {
    std::string text;
    const char* check;
    std::vector<const char*> said;
  } mistakes[] = {
      {import + std::string("class A(Team)\n"), "loads", {"line 2: SyntaxError", "mend"}},
      {import + std::string("x = 1\n"), "loads", {"defines no class"}},
      {team_that("return []", "import nothing_like_it\n"), "loads", {"No module", "installed"}},
      {team_that("return []", "open('/etc/passwd')\n"), "loads", {"line 2", "opens no file"}},
      {team_that("return open('/etc/passwd')"), "ticks", {"line 4", "opens no file"}},
      {team_that("return 3.0"), "ticks", {"decide() returned 3.0", "(left, right)"}},
      {team_that("sys.exit(0)", "import sys\n"), "ticks", {"SystemExit", "calling exit()"}},
      {team_that("return self.decide(now)"), "ticks", {"without end"}},
      {team_that("return []\n    def place(self, now, placement):\n"
                 "        placement.robots[1] = (0.1, 0.2)"),
       "ticks",
       {"robots[1]", "Pose(x, y, heading)"}},
      {team_that("return self.speed if now.tick > 90 else []"),
       "ticks",
       {"line 4", "AttributeError", "tick 91", "breakpoint()", "set it in __init__()"}},
      {team_that("return [1, 1, 1, 1, 1, 1]"), "ticks", {"6 numbers; 3 pairs"}},
      {team_that("pass"), "ticks", {"returned None", "each way through decide()"}},
      {team_that("return []", "import helper\n"), "loads", {"one file"}},
      {import + std::string("x = '\xe9'\n"), "loads", {"save the file as UTF-8"}},
      {team_that("now.ball_x = 1"), "ticks", {"line 4", "_replace"}},
      {team_that("return []", "TABLE = [0.0] * 300000000\n"), "loads", {"line 2", "1 GiB"}},
      {"print('hello')\n# no team\n", "complete", {}},
  };
  for (const auto& mistake : mistakes) {
    const PythonJson report = check(mistake.text, 1);
    const std::string reason = report.value("reason", "");
    EXPECT_EQ(reason.substr(0, reason.find(':')), mistake.check) << mistake.text << reason;
    for (const char* part : mistake.said) EXPECT_TRUE(contains(reason, part));
    EXPECT_FALSE(contains(reason, "gdb"));
  }
}

// Allowed, and hardly meant.
TEST_F(PythonTeams, AreWarned) {
  const PythonJson report =
      check(import + std::string("import random\n"
                                 "chance = random.random()\n"
                                 "class A(Team):\n"
                                 "    def decide(self, now):\n"
                                 "        self.parameter('wait time', 1.0)\n"
                                 "        for i in range(300):\n"
                                 "            self.draw_line('plan', 255, (0, 0), (1, 1))\n"
                                 "        for i in range(40):\n"
                                 "            self.parameter(f'p{i}', 1.0)\n"
                                 "        wheels = [(chance, 0.5), (0.4, 0.5)]\n"
                                 "        keep_laws(self.setup, now, wheels)\n"
                                 "        return wheels if now.own[-1].x < 9 else []\n"
                                 "    def place(self, now, placement):\n"
                                 "        placement.robots[1] = (-0.3, 0.2, 90)\n"
                                 "        return [(0.0, 0.0, 0.0)]\n"
                                 "    name = 5\n"),
            0);
  const std::string notes = report["notes"].dump();
  for (const char* part :
       {"which is no name", "more than 32 parameters", "more than 200 shapes",
        "change placement.robots", "robot 2 hardly ever got a command", "rad/s",
        "wheels = keep_laws(", "the index -1 of a robot counts from the last one",
        "robot 1 the heading 90", "the name of the team is 5"})
    EXPECT_TRUE(contains(notes, part));
}

// Catches a league that keeps or starts a team in Python as a library.
TEST_F(PythonTeams, PlayInALeague) {
  const std::string league = folder_ / "league";
  const std::string path = file(team_that("return [(5, 5)] * now.robots"));
  const auto mirocup = [](std::vector<std::string> words) {
    words.insert(words.begin(), {program("mirocup"), "league"});
    const Outcome outcome = expect_exit(0, run(words));
    return outcome.out;
  };
  mirocup({"init", league, "--team", "snake=" + path, "--team", "rock=house:idle", "--half", "2"});
  mirocup({"start", league});
  EXPECT_TRUE(contains(mirocup({"status", league}), "snake"));
}

// Catches a template that does not pass its own test, or whose scripts cannot be run.
TEST_F(PythonTeams, BeginFromATemplateThatPassesItsTest) {
  const std::string made = folder_ / "mein Team";
  EXPECT_EQ(run_mirocup({"new", made, "--language", "python"}).exit_code, 0);
  // The script itself, with fewer tries and shorter legs.
  expect_exit(0, run({"/bin/sh", "-ec",
                      "cd \"$0\"; [ -x test ] && [ -x watch ] && [ -x debug ]; "
                      "sed -i 's/--tries 20 --at-least 15/--tries 1/; s/check team.py/& --half 4/' "
                      "test; ./test",
                      made}));
}

}  // namespace
}  // namespace mirocup
