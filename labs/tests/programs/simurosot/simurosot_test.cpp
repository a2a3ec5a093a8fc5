// SPDX-License-Identifier: MIT
//
// Teams that were written for SimuroSot: the samples play, and the adapter shows them the field of
// their platform.
#include "mirocup/strategy.h"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <dlfcn.h>
#include <filesystem>
#include <limits>
#include <sstream>

// Old teams are never ended, as on their platform, so what they hold is no leak.
extern "C" const char* __lsan_default_options() {
  return "detect_leaks=0";
}

namespace mirocup {
namespace {

using namespace test_support;
using Json = nlohmann::ordered_json;

const std::vector<std::string> samples{"classic", "classic_b", "restart", "v5"};

std::string library(const std::string& sample) {
  return program("simurosot/" + sample + ".so");
}

// Catches a team that sees the other side, in other units or in another order: it then drives the
// ball into its own goal, or nowhere.
TEST(Simurosot, SamplesPlayWholeLegsInBothColours) {
  const TemporaryFolder folder;
  for (const std::string& sample : samples) {
    int scored = 0, lost = 0;
    for (const bool is_blue : {true, false}) {
      const Outcome played =
          run({program("mirocup"), "match", "--blue", is_blue ? library(sample) : "idle",
               "--yellow", is_blue ? "idle" : library(sample), "--league", "middle", "--rules",
               "simurosot", "--half", "100", "--record", folder / "leg.json"});
      ASSERT_EQ(played.exit_code, 0) << played.err;
      const Json record = read_json(folder / "leg.json");
      const char* own = is_blue ? "blue" : "yellow";
      const char* other = is_blue ? "yellow" : "blue";
      EXPECT_EQ(record["result"]["end"], "full_time") << sample << record["result"].dump();
      scored += record["result"]["score"][own].get<int>();
      lost += record["result"]["score"][other].get<int>();
      EXPECT_EQ(record["budget"][own]["bad_commands"], 0) << sample;
      EXPECT_EQ(run({program("mirocup"), "verify", folder / "leg.json"}).exit_code, 0);
    }
    EXPECT_GT(scored, lost) << sample;
  }
}

// Catches a sample that crowds its goal area or runs into the other keeper: it once gave away some
// twenty penalties and fifty goal kicks in a leg, and a table of such legs says nothing.
TEST(Simurosot, SamplesKeepTheLaws) {
  const TemporaryFolder folder;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::string& other = samples[(i + 1) % samples.size()];
    const Outcome played = run({program("mirocup"), "match", "--blue", library(samples[i]),
                                "--yellow", library(other), "--league", "middle", "--rules",
                                "simurosot", "--half", "100", "--record", folder / "leg.json"});
    ASSERT_EQ(played.exit_code, 0) << played.err;
    int fouls = 0;
    const Json record = read_json(folder / "leg.json");
    for (const Json& decision : record["decisions"]) {
      const std::string law = decision["law"].get<std::string>();
      if (law == "two_defenders" || law == "four_defenders" || law == "keeper_charge") ++fouls;
    }
    EXPECT_LE(fouls, 4) << samples[i] << " against " << other;
  }
}

// Catches a library that is unloaded while the old team still has files open and functions
// registered for the end of the program, which then run in memory that is gone.
TEST(Simurosot, MayBeLoadedIntoTheMatchItself) {
  for (const std::string& sample : samples) {
    const Outcome played =
        run({program("mirocup"), "match", "--blue", library(sample), "--yellow", "idle", "--league",
             "middle", "--rules", "simurosot", "--half", "2", "--trusted"});
    EXPECT_EQ(played.exit_code, 0) << sample << played.err;
  }
}

// A sample in this process, without a match around it.
class Loaded {
 public:
  Loaded(const std::string& sample, mirocup_colour colour) {
    handle_ = dlopen(library(sample).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ == nullptr) throw std::runtime_error(dlerror());
    using Entry = const mirocup_strategy* (*)();
    entry_ = reinterpret_cast<Entry>(dlsym(handle_, "mirocup_entry"))();
    setup_.size = sizeof setup_;
    setup_.team = colour;
    setup_.robots = 5;
    setup_.control_period = 1.0 / 60.0;
    setup_.half_length = 1.1;
    setup_.half_width = 0.9;
    setup_.wheel_distance = 0.068;
    setup_.wheel_radius = 0.0225;
    setup_.wheel_speed_limit = 80.0;
    setup_.motor_time_constant = 0.05;
    team_ = entry_->create(&setup_);
  }
  // The library stays: old teams have registered what runs when the program ends.

  mirocup_command decide(const mirocup_observation& now) const {
    mirocup_command command{};
    entry_->decide(team_, &now, &command);
    return command;
  }
  mirocup_placement place(const mirocup_observation& now) const {
    mirocup_placement placement{};
    placement.ball_x = now.ball_x;
    placement.ball_y = now.ball_y;
    for (int i = 0; i < now.robots; ++i) {
      placement.robots[i] = {now.own[i].x, now.own[i].y, now.own[i].heading};
    }
    entry_->place(team_, &now, &placement);
    return placement;
  }
  const mirocup_strategy& entry() const { return *entry_; }

 private:
  void* handle_ = nullptr;
  const mirocup_strategy* entry_ = nullptr;
  mirocup_setup setup_{};
  void* team_ = nullptr;
};

// Both teams in their own halves, the ball in the middle.
mirocup_observation kick_off() {
  mirocup_observation now{};
  now.size = sizeof now;
  now.state = MIROCUP_READY;
  now.restart = MIROCUP_KICK_OFF;
  now.own_restart = 1;
  now.robots = 5;
  const double x[5] = {-1.05, -0.2, -0.6, -0.6, -0.8};
  const double y[5] = {0.0, 0.0, 0.4, -0.4, 0.0};
  for (int i = 0; i < 5; ++i) {
    now.own[i] = {x[i], y[i], 0.0, 0.0, 0.0, 0.0};
    now.opponent[i] = {-x[i], -y[i], 3.14, 0.0, 0.0, 0.0};
  }
  return now;
}

// Catches a side that is turned for one colour only: seen from the team, both colours are alike.
TEST(Simurosot, BothColoursDriveAlike) {
  for (const std::string& sample : samples) {
    mirocup_command commands[2];
    for (const mirocup_colour colour : {MIROCUP_BLUE, MIROCUP_YELLOW}) {
      const Loaded team(sample, colour);
      mirocup_observation now = kick_off();
      team.decide(now);
      now.state = MIROCUP_PLAY;
      now.tick = 1;
      commands[colour] = team.decide(now);
    }
    double most = 0.0;
    for (int i = 0; i < 5; ++i) {
      // A team that is not symmetric by itself may differ a little in which way it waits.
      if (sample == "classic" || sample == "restart") continue;
      EXPECT_NEAR(commands[0].wheels[i].left, commands[1].wheels[i].left, 1e-3) << sample << i;
      EXPECT_NEAR(commands[0].wheels[i].right, commands[1].wheels[i].right, 1e-3) << sample << i;
    }
    // Robot 1 is nearest, behind the ball and looks at it: both of its wheels drive forwards.
    for (const mirocup_command& command : commands) {
      most = std::max(most, command.wheels[1].left);
      EXPECT_GT(command.wheels[1].left + command.wheels[1].right, 1.0) << sample;
      for (const mirocup_wheels& wheels : command.wheels) {
        EXPECT_LE(std::abs(wheels.left), 80.0);
        EXPECT_LE(std::abs(wheels.right), 80.0);
      }
    }
    EXPECT_GT(most, 5.0) << sample;
  }
}

// Catches centimetres taken for inches, another origin, a heading in radians, and places that are
// asked for in the other turn.
TEST(Simurosot, PlacesWhereTheTeamsCodeSays) {
  for (const mirocup_colour colour : {MIROCUP_BLUE, MIROCUP_YELLOW}) {
    const Loaded restart("restart", colour);
    mirocup_placement placement = restart.place(kick_off());
    EXPECT_NEAR(placement.robots[1].x, -0.10, 1e-9);  // (100, 90) of 220 by 180
    EXPECT_NEAR(placement.robots[1].y, 0.0, 1e-9);
    EXPECT_NEAR(std::remainder(placement.robots[1].heading, 2 * M_PI), 0.0, 1e-9);
    EXPECT_NEAR(placement.robots[2].y, 0.40, 1e-9);

    mirocup_observation second = kick_off();
    second.own_restart = 0;
    placement = restart.place(second);
    EXPECT_NEAR(placement.robots[1].x, -0.35, 1e-9);

    mirocup_observation goal_kick = kick_off();
    goal_kick.restart = MIROCUP_GOAL_KICK;
    goal_kick.ball_x = -1.0;
    placement = restart.place(goal_kick);
    EXPECT_NEAR(placement.ball_x, -1.0, 1e-9);
    EXPECT_GE(placement.ball_y, -0.101);
    EXPECT_LE(placement.ball_y, 0.101);

    // It says nothing about a free ball: all stay where they are, to the last bit.
    mirocup_observation free_ball = kick_off();
    free_ball.restart = MIROCUP_FREE_BALL;
    free_ball.ball_x = 0.55;
    free_ball.ball_y = 0.6;
    placement = restart.place(free_ball);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(placement.robots[i].x, free_ball.own[i].x);

    const Loaded v5("v5", colour);
    v5.decide(second);  // the restart is told before the places are asked for
    placement = v5.place(second);
    EXPECT_NEAR(placement.robots[1].x, -0.35, 1e-6);
    EXPECT_NEAR(std::remainder(placement.robots[1].heading, 2 * M_PI), 0.0, 1e-6);
  }
  EXPECT_EQ(Loaded("classic", MIROCUP_BLUE).entry().place, nullptr);
}

// Catches a folder that is taken for another style, sources that are forgotten, and old files that
// are changed or written over.
TEST(Simurosot, FindsWhatAnOldFolderHolds) {
  const TemporaryFolder folder;
  const std::string old = MIROCUP_SOURCE_FOLDER "/labs/simurosot/samples/";
  const std::vector<std::string> styles{"classic", "classic", "restart", "v5"};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::string made = folder / samples[i];
    const Outcome outcome =
        run({program("mirocup"), "new", made, "--from-simurosot", old + samples[i]});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(read_file(made + "/CMakeLists.txt").find("STYLE " + styles[i]), std::string::npos);
    EXPECT_NE(read_file(made + "/CMakePresets.json").find("CMAKE_PREFIX_PATH"), std::string::npos);
  }
  const std::string cmake = read_file(folder / "classic_b/CMakeLists.txt");
  EXPECT_NE(cmake.find("src/Estrategia.h"), std::string::npos);
  EXPECT_NE(cmake.find("src/Movimiento.cpp"), std::string::npos);
  EXPECT_EQ(read_file(folder / "classic_b/src/Movimiento.cpp"),
            read_file(old + "classic_b/Movimiento.cpp"));

  const Outcome none = run({program("mirocup"), "new", folder / "x", "--from-simurosot",
                            MIROCUP_SOURCE_FOLDER "/plugins/house"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("no header here defines"), std::string::npos) << none.err;
  const Outcome many = run(
      {program("mirocup"), "new", folder / "x", "--from-simurosot", old.substr(0, old.size() - 1)});
  EXPECT_EQ(many.exit_code, 2) << many.out;
}

const std::string kit = MIROCUP_SOURCE_FOLDER "/labs/simurosot";

// Makes the files that lead to the headers of the team below `root`, where the compiler looks in
// `folders`.
Outcome forwarded(const std::string& forward, const std::string& root,
                  const std::vector<std::string>& folders) {
  std::vector<std::string> words{kit + "/forward.sh", forward, kit + "/stand_in", root + "/build",
                                 root};
  words.insert(words.end(), folders.begin(), folders.end());
  return run(words);
}

// Compiles a source as mirocup_simurosot_team does.
Outcome compiled(const std::string& path, const std::vector<std::string>& options) {
  std::vector<std::string> words{kit + "/compile.sh",   "g++",          "-include",
                                 kit + "/prefix.h",     "-w",           "-fpermissive",
                                 "-fno-operator-names", "-fsyntax-only"};
  words.insert(words.end(), options.begin(), options.end());
  words.insert(words.end(), {"-I", kit + "/stand_in", path});
  return run(words);
}

// Catches a folder that only a file system blind to case, where \\ parts folders, could compile,
// and a library's own windows.h that is taken for that of Windows.
TEST(Simurosot, FindsIncludesAsWindowsDoes) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "old/Include");
  std::filesystem::create_directories(folder / "old/src/tools");
  std::filesystem::create_directories(folder / "forward/of/the/team");
  write_file(folder / "old/Include/Strategy.h", "int strategy();\r\n// the end");
  write_file(folder / "old/src/tools/move.h", "int move();");
  write_file(folder / "old/src/tools/windows.h", "#error this is not the one of Windows");
  write_file(folder / "old/src/main.cpp",
             "#include \"StdAfx.h\"\r\n#include <Math.h>\r\n#include <vector>\r\n"
             "#include <Windows.h>\r\n#include <windows.h>\r\nDWORD of_windows;\r\n"
             "\t#\tinclude \"..\\Include\\STRATEGY.H\"\r\n#include \"Tools/Move.h\"\r\n"
             "double all() { return strategy() + move() + sqrt(4.0); }");
  const std::string forward = folder / "forward/of/the/team";
  const Outcome made = forwarded(forward, folder / "old", {folder / "old/src"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Outcome outcome = compiled(folder / "old/src/main.cpp", {"-I", forward});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

// Catches an #include that writes outside of the five folders, and one that ends the build.
TEST(Simurosot, ForwardsNoNameThatLeadsOut) {
  const TemporaryFolder folder;
  const std::string forward = folder / "team/for/the/names/of/windows";
  std::filesystem::create_directories(forward);
  std::filesystem::create_directories(folder / "old/src/sub");
  write_file(folder / "old/evil.h", "");
  std::string code;
  for (const char* name :
       {"../../../../../../sub//Evil.h", ".././.././.././.././.././../Evil.h",
        "..//..//..//..//..//..//Evil.h", "a/../../../../../../../Evil.h",
        "../../../../../../../../../../tmp/Evil.h", "../team/../../../../../../Evil.h",
        "../../../../../../Evil.h", "sub/..", "sub/.", "..", "/Evil.h", "../Evil.h",
        "../../../../../Evil.h", "a/../b/../../Evil.h"}) {
    code += "#include \"" + std::string(name) + "\"\n";
  }
  write_file(folder / "old/src/main.cpp", code);
  const Outcome made = forwarded(forward, folder / "old", {folder / "old/src"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  std::vector<std::string> written;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "")) {
    const std::string path = entry.path().lexically_relative(folder / "").string();
    if (path.ends_with("Evil.h")) written.push_back(path);
  }
  std::sort(written.begin(), written.end());
  EXPECT_EQ(written, (std::vector<std::string>{"team/Evil.h", "team/for/the/names/of/Evil.h"}));
}

// Catches a header of the team's own, beside its sources, that the C library's headers take for one
// of theirs.
TEST(Simurosot, LetsATeamHaveHeadersWithNamesOfTheLibrary) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "old/own parts");
  std::filesystem::create_directories(folder / "forward");
  write_file(folder / "old/own parts/string.h", "int own_length(const char* s);\n");
  write_file(folder / "old/own parts/parts.h", "int part();\n");
  write_file(folder / "old/main.cpp",
             "#include <cstring>\n#include \"string.h\"\n#include <parts.h>\n"
             "int all(const char* s) { return own_length(s) + std::strlen(s) + part(); }\n");
  const std::string parts = folder / "old/own parts";
  const std::string forward = folder / "forward";
  const Outcome made = forwarded(forward, folder / "old", {folder / "old", parts});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.out, parts + "\n");
  const Outcome outcome = compiled(folder / "old/main.cpp", {"-I", forward, "-iquote" + parts});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

// The paths of the cases in a folder beside this file.
std::vector<std::string> idioms(const std::string& kind) {
  std::vector<std::string> paths;
  const std::string folder = MIROCUP_SOURCE_FOLDER "/labs/tests/programs/simurosot/idioms/" + kind;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    paths.push_back(file.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

// Compiles a source that is alone in its folder.
Outcome compiled_alone(const std::string& path, const std::string& standard) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "old");
  std::filesystem::create_directories(folder / "forward/of/the/team");
  const std::string old = folder / "old", forward = folder / "forward/of/the/team";
  const std::string name = std::filesystem::path(path).filename().string();
  std::filesystem::copy_file(path, old + "/" + name);
  const Outcome made = forwarded(forward, old, {old});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  return compiled(old + "/" + name, {"-std=" + standard, "-I", forward});
}

// Catches a name of Windows, a habit of Visual C++ or a name of the team's own that g++ stumbles
// over: each was found in an old team or may stand in one.
TEST(Simurosot, TakesWhatVisualCppTook) {
  for (const std::string& path : idioms("taken")) {
    for (const char* standard : {"gnu++98", "gnu++14"}) {
      const Outcome outcome = compiled_alone(path, standard);
      EXPECT_EQ(outcome.exit_code, 0) << path << ", " << standard << ":\n" << outcome.err;
    }
  }
}

// Catches a message of g++ that says nothing to the author of old code: what is not taken is
// named with line and cure. Each case begins with both.
TEST(Simurosot, NamesWhatItDoesNotTake) {
  for (const std::string& path : idioms("cured")) {
    const Outcome outcome = compiled_alone(path, "gnu++98");
    EXPECT_NE(outcome.exit_code, 0) << path;
    std::istringstream lines(read_file(path));
    for (int i = 0; i < 2; ++i) {
      std::string line;
      std::getline(lines, line);
      EXPECT_NE(outcome.err.find(line.substr(3)), std::string::npos) << line << '\n' << outcome.err;
    }
    const std::string once = "is not declared.";
    EXPECT_EQ(outcome.err.find(once), outcome.err.rfind(once)) << outcome.err;
  }
}

const std::string classic = MIROCUP_SOURCE_FOLDER "/labs/simurosot/samples/classic/";

void copy_classic(const std::string& to, std::initializer_list<const char*> files) {
  std::filesystem::create_directories(to);
  for (const char* file : files) write_file(to + "/" + file, read_file(classic + file));
}

std::string in_lines_of_windows(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\n' ? "\r\n" : std::string(1, c);
  return out;
}

std::string in_utf16(const std::string& ascii) {
  std::string out = "\xff\xfe";
  for (const char c : ascii) {
    out.push_back(c);
    out.push_back('\0');
  }
  return out;
}

// Writes a folder as it is found on an old disk: two copies of the header, sources in a folder of
// their own, names in another case, texts in GBK, in UTF-16 and with their end marked, a broken
// file that the project does not compile, a file of parameters that is not there.
void make_old_folder(const std::string& folder) {
  const std::string header = in_lines_of_windows(read_file(classic + "Strategy.h"));
  std::filesystem::create_directories(folder + "/Include");
  std::filesystem::create_directories(folder + "/Tools");
  write_file(folder + "/Strategy.h", header);
  write_file(folder + "/Include/Strategy.h", header + "\r\n");
  write_file(folder + "/StdAfx.h", read_file(classic + "StdAfx.h"));
  write_file(folder + "/TEAM.CPP", in_lines_of_windows("// \xd7\xe9\xb3\xc9\xb5\\\n"
                                                       "#include \"Tools\\Log.h\"\n" +
                                                       read_file(classic + "Strategy.cpp")) +
                                       "\x1a");
  write_file(folder + "/Tools/Log.h", "void note(int value);\r\r\n#include <stdio.h>\r\r\n");
  write_file(
      folder + "/Tools/log.cxx",
      in_utf16("#include \"stdafx.h\"\n#include \"..\\INCLUDE\\strategy.h\"\n"
               "#include \"log.H\"\n"
               "void note(int value) { char b[9]; fprintf(fopen(\"C:\\\\x\", \"r\"), "
               "\"%s\", itoa(value, b, 10)); }\n"
               "#include <winsock2.h>\nstatic SOCKET shown = socket(AF_INET, SOCK_STREAM, 0);\n"
               "static int state = connect(shown, 0, 0) == 0 ? 0 : (exit(1), 1);\n"));
  write_file(folder + "/test.cpp", "this is broken\nvoid main() {}\n");
  write_file(folder + "/Team.dsp",
             "SOURCE=.\\Team.cpp\r\n# End\r\nSOURCE=.\\tools\\Log.cxx\r\nSOURCE=.\\Strategy.h\r\n");
}

// Builds a project that `mirocup new` has made.
void build_project(const std::string& project, const std::string& build) {
  const Outcome configured = run(
      {"/usr/bin/env", "cmake", "-S", project, "-B", build, "-DCMAKE_PREFIX_PATH=" + program("")});
  ASSERT_EQ(configured.exit_code, 0) << configured.err;
  const Outcome built = run({"/usr/bin/env", "cmake", "--build", build});
  ASSERT_EQ(built.exit_code, 0) << built.out << built.err;
}

// Catches a folder of an old disk that has to be tidied up by hand before it builds, and a network
// on which a team ends if it sends its thoughts to a debugging program.
TEST(Simurosot, BuildsAnUntidyFolder) {
  const TemporaryFolder folder;
  make_old_folder(folder / "old");
  const Outcome made =
      run({program("mirocup"), "new", folder / "made", "--from-simurosot", folder / "old"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.out.find("2 sources, gnu++98"), std::string::npos) << made.out;
  EXPECT_NE(made.out.find("src/TEAM.CPP: mirocup new changed its text so that g++ can read it"),
            std::string::npos);
  ASSERT_NO_FATAL_FAILURE(build_project(folder / "made", folder / "build"));
  const Outcome played = run({program("mirocup"), "match", "--blue", folder / "build/team.so",
                              "--yellow", "idle", "--league", "middle", "--rules", "simurosot",
                              "--half", "50", "--record", folder / "leg.json"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const Json result = read_json(folder / "leg.json")["result"];
  EXPECT_EQ(result["end"], "full_time") << result.dump();
  EXPECT_GT(result["score"]["blue"], 0);
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

// Catches structures of the platform in a namespace, as Simuro5v5's own template has them, or with
// their older names, that are not found: it does not build, or its functions are not called.
TEST(Simurosot, TakesThePlatformsStructuresInANamespaceAndByTheirOlderNames) {
  const TemporaryFolder folder;
  const std::string sample = MIROCUP_SOURCE_FOLDER "/labs/simurosot/samples/v5/";
  std::string header = read_file(sample + "platform.h");
  header.insert(header.find("struct Vector2"),
                "using namespace std; namespace Simuro /* 5v5 */\n{ namespace Platform {\n");
  header = with(with(header, "selfRobots", "ourRobots"), "int32_t tick;",
                "int32_t tickTotal, tickRound;");
  std::string source = with(read_file(sample + "strategy.cpp"), "selfRobots", "ourRobots");
  source.insert(source.find("static JudgeType"), "using namespace Simuro::Platform;\n");
  std::filesystem::create_directories(folder / "old");
  write_file(folder / "old/platform.h", header + "} }\n");
  write_file(folder / "old/strategy.cpp", source);
  const Outcome made =
      run({program("mirocup"), "new", folder / "made", "--from-simurosot", folder / "old"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  ASSERT_NO_FATAL_FAILURE(build_project(folder / "made", folder / "build"));
  // A team that was written for yellow sees the field from the other end.
  const std::string list = folder / "made/CMakeLists.txt";
  const std::string own_side = read_file(list);
  write_file(list, with(own_side, "SIDE own", "SIDE yellow"));
  ASSERT_NO_FATAL_FAILURE(build_project(folder / "made", folder / "turned"));
  const std::string turned = folder / "turned/team.so";
  std::string hash;
  for (const std::string& team : {program("simurosot/v5.so"), folder / "build/team.so", turned}) {
    const Outcome played =
        run({program("mirocup"), "match", "--blue", team, "--yellow", "idle", "--league", "middle",
             "--rules", "simurosot", "--half", "20", "--record", folder / "leg.json"});
    ASSERT_EQ(played.exit_code, 0) << played.err;
    const auto record = read_json(folder / "leg.json");
    EXPECT_EQ(record["result"]["end"], "full_time") << record["result"].dump();
    if (hash.empty()) hash = record["state_hash"].get<std::string>();
    EXPECT_EQ(record["state_hash"] == hash, team != turned)
        << (team == turned ? "SIDE has no effect" : "a function of the team was not called");
  }
  // It now plays the wrong way, for which the check names the cure.
  const Outcome checked = run({program("mirocup"), "check", turned, "--league", "middle", "--rules",
                               "simurosot", "--half", "100"});
  EXPECT_NE(checked.out.find("write SIDE blue or SIDE yellow"), std::string::npos) << checked.out;
}

// The platform's last header: the opponents are called "opp", and the lines of the field are gone.
TEST(Simurosot, BuildsWithAHeaderThatLacksMembers) {
  const TemporaryFolder folder;
  copy_classic(folder / "old", {"Strategy.cpp", "StdAfx.h", "StdAfx.cpp"});
  const std::string header = with(read_file(classic + "Strategy.h"), "opponent[", "opp[");
  write_file(folder / "old/Strategy.h", with(header, "  Bounds fieldBounds, goalBounds;\n", ""));
  const Outcome made =
      run({program("mirocup"), "new", folder / "made", "--from-simurosot", folder / "old"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  ASSERT_NO_FATAL_FAILURE(build_project(folder / "made", folder / "build"));
}

// Catches a header that does not compile by itself, of which only the adapter's own lines were
// named, and a prelude that does not reach a source or the adapter.
TEST(Simurosot, SaysThatAHeaderDoesNotCompileAlone) {
  const TemporaryFolder folder;
  copy_classic(folder / "old", {"Strategy.cpp", "StdAfx.h", "StdAfx.cpp"});
  const std::string header = read_file(classic + "Strategy.h");
  const std::size_t at = header.find("typedef struct");
  write_file(folder / "old/Strategy.h",
             header.substr(0, at) + "extern Vector9 wanted;\n" + header.substr(at));
  write_file(folder / "old/vector9.h", "struct Vector9 { double x; };\n");
  const Outcome made =
      run({program("mirocup"), "new", folder / "made", "--from-simurosot", folder / "old"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string project = folder / "made", build = folder / "build";
  const Outcome configured = run(
      {"/usr/bin/env", "cmake", "-S", project, "-B", build, "-DCMAKE_PREFIX_PATH=" + program("")});
  ASSERT_EQ(configured.exit_code, 0) << configured.err;
  const Outcome built = run({"/usr/bin/env", "cmake", "--build", build, "--", "-k"});
  EXPECT_NE(built.exit_code, 0);
  EXPECT_NE(built.err.find("Strategy.h: this header does not compile by itself"), std::string::npos)
      << built.err;
  EXPECT_EQ(built.err.find("adapter.cpp:3"), std::string::npos) << built.err;
  const std::string list = read_file(project + "/CMakeLists.txt");
  write_file(project + "/CMakeLists.txt",
             with(list, "WHEELS linear", "WHEELS linear PRELUDE src/vector9.h"));
  ASSERT_NO_FATAL_FAILURE(build_project(project, build));
}

// Catches sources that only declare what the platform calls, as a referee's do, and are taken for a
// team without a word, and names that nothing defines, of which only the linker spoke.
TEST(Simurosot, SaysThatNoSourceDefinesWhatIsCalled) {
  const TemporaryFolder folder;
  copy_classic(folder / "old", {"Strategy.h", "StdAfx.h", "StdAfx.cpp"});
  write_file(folder / "old/Watch.cpp",
             "#include \"StdAfx.h\"\n#include \"Strategy.h\"\nint judge(int);\n"
             "int watch() { return judge(1) + judge(2); }\n");
  const std::string project = folder / "made", build = folder / "build";
  const Outcome made =
      run({program("mirocup"), "new", project, "--from-simurosot", folder / "old"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.out.find("no source here seems to define Strategy,"), std::string::npos)
      << made.out;
  const Outcome configured = run(
      {"/usr/bin/env", "cmake", "-S", project, "-B", build, "-DCMAKE_PREFIX_PATH=" + program("")});
  ASSERT_EQ(configured.exit_code, 0) << configured.err;
  const Outcome built = run({"/usr/bin/env", "cmake", "--build", build});
  EXPECT_NE(built.exit_code, 0);
  EXPECT_NE(built.err.find("1 name is used that no source in CMakeLists.txt defines, such as "
                           "\"judge(int)\".\n  Cure: give after SOURCES"),
            std::string::npos)
      << built.err;
}

// Catches a backup that is taken for a second team, a project that is left over, of which what it
// does not name is compiled, and macros of the project that are lost.
TEST(Simurosot, CompilesWhatTheProjectNamesThatCounts) {
  const TemporaryFolder folder;
  for (const char* where : {"old", "old/Backup"}) {
    copy_classic(folder / where, {"Strategy.h", "Strategy.cpp", "StdAfx.h", "StdAfx.cpp"});
    write_file(folder / where + "/Team.dsp",
               "/D \"WIN32\" /D \"YELLOW\"\nSOURCE=.\\Strategy.cpp\n# End\nSOURCE=.\\Notes.cpp\n");
  }
  write_file(folder / "old/Notes.cpp", "these are notes");
  write_file(
      folder / "old/Team.vcxproj",
      "<ClCompile Include=\"Strategy.cpp\" /><ClCompile Include=\"StdAfx.cpp\" />"
      "<PreprocessorDefinitions>WIN32;_DEBUG;SLOW;%(PreprocessorDefinitions)"
      "</PreprocessorDefinitions><PreprocessorDefinitions Condition=\"x\">WIN32;NDEBUG;_USRDLL;"
      "TEAM_EXPORTS;SIDE=1;$(x);BLUE</PreprocessorDefinitions>");
  const Outcome made =
      run({program("mirocup"), "new", folder / "made", "--from-simurosot", folder / "old"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.out.find("2 sources, gnu++98, macros SIDE=1 BLUE\n"), std::string::npos)
      << made.out;
  EXPECT_NE(read_file(folder / "made/CMakeLists.txt").find("\n  DEFINITIONS SIDE=1 BLUE\n"),
            std::string::npos);
  std::filesystem::remove(folder / "old/Team.vcxproj");
  const Outcome older =
      run({program("mirocup"), "new", folder / "older", "--from-simurosot", folder / "old"});
  ASSERT_EQ(older.exit_code, 0) << older.err;
  EXPECT_NE(older.out.find("2 sources, gnu++98, macros YELLOW"), std::string::npos) << older.out;
  // A tool with a project of its own lies beside the team's folder.
  std::filesystem::create_directories(folder / "both/tool");
  std::filesystem::rename(folder / "old", folder / "both/game");
  write_file(folder / "both/tool/tool.cpp", "int main() { return 0; }\n");
  write_file(folder / "both/tool/Tool.vcxproj", "<ClCompile Include=\"tool.cpp\" />");
  const Outcome beside =
      run({program("mirocup"), "new", folder / "beside", "--from-simurosot", folder / "both"});
  ASSERT_EQ(beside.exit_code, 0) << beside.err;
  EXPECT_NE(beside.out.find("2 sources"), std::string::npos) << beside.out;
}

// A team's own structure timezone, beside Visual C++'s variable _timezone.
TEST(Simurosot, LeavesNamesOfATeamsOwnAlone) {
  const TemporaryFolder folder;
  copy_classic(folder / "old", {"Strategy.h", "Strategy.cpp", "StdAfx.h", "StdAfx.cpp"});
  write_file(folder / "old/west.cpp",
             "#include <windows.h>\n#include <time.h>\nnamespace Own { struct timezone { int "
             "minutes; }; int west() { return _timezone / 60; } }\n");
  const Outcome made =
      run({program("mirocup"), "new", folder / "made", "--from-simurosot", folder / "old"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  ASSERT_NO_FATAL_FAILURE(build_project(folder / "made", folder / "build"));
}

// Catches a line on which the reader's stack or time has no end, and sources that take all memory.
TEST(Simurosot, BoundsLinesAndFiles) {
  const TemporaryFolder folder;
  const std::string old = folder / "old";
  copy_classic(old, {"Strategy.h", "Strategy.cpp", "StdAfx.h"});
  int count = 0;
  const auto adopted = [&](const std::string& name, const std::string& text) {
    write_file(old + "/" + name, text);
    const Outcome made =
        run({program("mirocup"), "new", folder / std::to_string(++count), "--from-simurosot", old});
    std::filesystem::remove(old + "/" + name);
    return made;
  };
  const std::string many(60'000, 'a');
  std::string nested;
  while (nested.size() < 60'000) nested += "#include <for(auto ](>>=SOURCE=RelativePath=\"x";
  const std::string returns(std::size_t{3} << 20, '\r');
  for (const std::string& text :
       {"SOURCE=" + many, "#include \"" + many + "\"", "void f() { for (" + many + "}",
        "int Strategy(" + many, "x = [](" + many, "RelativePath=" + std::string(60'000, ' '),
        "<ClCompile Include=\"" + many, many + ">>" + many.substr(1) + ";", nested,
        returns + "x"}) {
    for (const char* name : {"Old.vcproj", "more.h"}) {
      const Outcome made = adopted(name, text + "\n");
      EXPECT_EQ(made.exit_code, text.size() > 65'536 && text.front() == 'a' ? 2 : 0)
          << name << ' ' << text.substr(0, 20) << made.err;
    }
  }
  const Outcome line = adopted("more.h", "int a;\n" + many + many + "\n");
  EXPECT_EQ(line.exit_code, 2);
  EXPECT_NE(line.err.find("more.h: a line of more than 64 KiB"), std::string::npos) << line.err;
  std::string large;
  while (large.size() < 3'900'000) large += "int x; // a line\n";
  for (int i = 0; i < 8; ++i) write_file(old + "/" + std::to_string(i) + ".h", large);
  const Outcome all = adopted("Old.dsp", large);
  EXPECT_EQ(all.exit_code, 2);
  EXPECT_NE(all.err.find("old: more than 32 MiB"), std::string::npos) << all.err;
}

// Catches a name that a makefile or a template takes for a word of its own.
TEST(Simurosot, TakesNamesAsTheyAre) {
  const TemporaryFolder folder;
  copy_classic(folder / "old/@STANDARD@", {"Strategy.h", "StdAfx.h"});
  write_file(folder / "old/@STANDARD@/@STYLE@ @SOURCES@.cpp", read_file(classic + "Strategy.cpp"));
  const Outcome made =
      run({program("mirocup"), "new", folder / "made", "--from-simurosot", folder / "old"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  ASSERT_NO_FATAL_FAILURE(build_project(folder / "made", folder / "build"));
  for (const char* bad : {"a|b.cpp", "a\tb.cpp", "d|e/x.h", "a:b.cpp", "d[e]/x.cpp"}) {
    const std::string path = folder / "old/" + bad;
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    write_file(path, "");
    const Outcome refused =
        run({program("mirocup"), "new", folder / "x", "--from-simurosot", folder / "old"});
    EXPECT_EQ(refused.exit_code, 2) << bad;
    EXPECT_NE(refused.err.find("cannot take this name"), std::string::npos) << refused.err;
    std::filesystem::remove(path);
  }
}

// Catches a folder of two teams that is taken for one, a copy of a source that is built in place of
// the source, and a project that names files which are not there.
TEST(Simurosot, SaysWhichOfTwoTeamsItCannotTell) {
  const TemporaryFolder folder;
  for (const char* team : {"blue", "yellow"}) {
    std::filesystem::create_directories(folder / "old/" + team);
    for (const char* file : {"Strategy.h", "Strategy.cpp", "StdAfx.h"}) {
      write_file(folder / "old/" + team + "/" + file,
                 read_file(classic + file) + "// of " + team + "\nint " + team + "_only;\n");
    }
  }
  const Outcome both =
      run({program("mirocup"), "new", folder / "x", "--from-simurosot", folder / "old"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_NE(both.err.find("more than one team"), std::string::npos) << both.err;
  const std::string of_blue = read_file(folder / "old/blue/Strategy.cpp");
  write_file(folder / "old/blue/Strategy.cpp", "#include \"Strategy.h\"\n");
  const Outcome one =
      run({program("mirocup"), "new", folder / "x", "--from-simurosot", folder / "old"});
  EXPECT_NE(one.err.find("such as that of yellow/Strategy.cpp"), std::string::npos) << one.err;
  write_file(folder / "old/blue/Strategy.cpp", of_blue);
  write_file(folder / "old/blue/Copy of Strategy.cpp", read_file(folder / "old/blue/Strategy.cpp"));
  const Outcome copy =
      run({program("mirocup"), "new", folder / "x", "--from-simurosot", folder / "old/blue"});
  EXPECT_EQ(copy.exit_code, 2);
  EXPECT_NE(copy.err.find("Copy of Strategy.cpp and Strategy.cpp both define"), std::string::npos)
      << copy.err;
  std::filesystem::remove(folder / "old/blue/Copy of Strategy.cpp");
  write_file(folder / "old/blue/Old.vcproj", "<File RelativePath=\".\\Lost.cpp\">");
  EXPECT_EQ(run({program("mirocup"), "new", folder / "y", "--from-simurosot", folder / "old/blue"})
                .exit_code,
            0);
}

}  // namespace
}  // namespace mirocup
