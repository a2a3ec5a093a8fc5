// SPDX-License-Identifier: MIT
//
// `mirocup compile`: a source and a project become libraries that are accepted, and what the
// compiler says is told. Catches a library that no team can hand in, and words of a compiler that
// are lost. compile_kinds_test.cpp has the sources that attack.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace mirocup {
namespace {

namespace fs = std::filesystem;
using namespace test_support;

class Compile : public testing::Test {
 protected:
  void SetUp() override {
    if (!why_no_t2().empty()) GTEST_SKIP() << why_no_t2();
  }

  Outcome compile(const std::string& source, const std::string& name = "team.cpp") {
    write_file(temporary_ / name, source);
    fs::remove(library_);
    return run_mirocup({"compile", temporary_ / name, "-o", library_});
  }

  TemporaryFolder temporary_;
  std::string library_ = temporary_ / "team.so";
};

TEST_F(Compile, MakesALibraryThatIsAccepted) {
  const std::string template_source = temporary_ / "new";
  ASSERT_EQ(run_mirocup({"new", template_source}).exit_code, 0);
  expect_exit(0, compile(read_file(template_source + "/team.cpp")));
  expect_exit(0, run_mirocup({"check", library_, "--half", "20"}));
}

TEST_F(Compile, SaysWhatTheCompilerSays) {
  const Outcome wrong = expect_exit(1, compile("int main() { return \x1b[31mundeclared; }"));
  EXPECT_TRUE(contains(wrong.out, "error:"));
  EXPECT_EQ(wrong.out.find('\x1b'), std::string::npos) << "text of a stranger is escaped";
  EXPECT_TRUE(contains(wrong.out, "does not compile"));
  EXPECT_EQ(compile("int x;\n", "-o.c").exit_code, 0) << "a name is no option";
  for (const auto& [source, told] : std::initializer_list<std::pair<const char*, const char*>>{
           {"#include <Eigen/Dense>\n", "an archive's files"},
           {"int a = attack_ball();\n", "an include is missing"},
           {"#include <vector>\nimport mine;\n", "write headers"},
           {"\nusing namespace mirocup::strategy;\n",
            "at line 2; the log has the compiler's words: w"},
           {"int\xc2\xa0x;\n", "only looks like a blank"}}) {
    const Outcome outcome = compile(source);
    EXPECT_TRUE(contains(outcome.out, told));
  }
}

// Catches an archive whose files, headers or folders are not found, and names that are options.
TEST_F(Compile, MakesALibraryOfTheProjectOfANewTeam) {
  const std::string folder = temporary_ / "new";
  ASSERT_EQ(run_mirocup({"new", folder}).exit_code, 0);
  fs::create_directories(folder + "/src");
  fs::create_directories(folder + "/build/CMakeFiles");
  write_file(folder + "/src/more.c", "#include \"more.h\"\nint more(void) { return MORE; }\n");
  write_file(folder + "/more.h", "#define MORE 1\n");
  write_file(folder + "/build/CMakeFiles/wrong.cpp", "this is no C++\n");
  ASSERT_EQ(run({"/usr/bin/tar", "-czf", temporary_ / "-o.tar.gz", "-C", temporary_ / ".", "new"})
                .exit_code,
            0);
  expect_exit(0, run_mirocup({"compile", temporary_ / "-o.tar.gz", "-o", library_}));
  expect_exit(0, run_mirocup({"check", library_, "--half", "2"}));
  write_file(folder + "/src/more.c", "int more(void) { return undeclared; }\n");
  ASSERT_EQ(
      run({"/usr/bin/tar", "-cf", temporary_ / "bad.tar", "-C", temporary_ / ".", "new"}).exit_code,
      0);
  const Outcome wrong =
      expect_exit(1, run_mirocup({"compile", temporary_ / "bad.tar", "-o", library_}));
  EXPECT_TRUE(contains(wrong.out, "src/more.c:1:"));
}

// Catches a source that chooses its processor itself, of which nobody hears, and a warning of a
// function with such a name.
TEST_F(Compile, WarnsOfTargets) {
  const std::string plain =
      "struct Point { double x; };\nstatic double target(const char* name) { return *name; }\n"
      "// __attribute__((target(\"avx2\")))\ndouble all() { return target(\"avx2\"); }\n";
  const Outcome none = expect_exit(0, compile(plain));
  EXPECT_FALSE(contains(none.out, "warning"));
  for (const char* line :
       {"#pragma GCC target(\"avx512f\")", "#pragma GCC target \"avx2\"",
        "_Pragma(\"GCC target(\\\"avx2\\\")\")",
        "__attribute__((noinline, target(\"avx512f\"))) void f() {}",
        "__attribute__((__target__ (\"avx2\"))) void f() {}",
        "[[gnu::target(\"avx2\")]] void f() {}", "#define FAST __attribute__((target(\"avx2\")))",
        "__attribute__((target_clones(\"avx512f\", \"default\"))) int f() { return 1; }"}) {
    const Outcome warned = compile(plain + line + "\n");
    EXPECT_EQ(warned.exit_code, 0) << line << '\n' << warned.out;
    EXPECT_TRUE(contains(warned.out, "warning: a pragma or an attribute")) << line;
  }
  fs::create_directories(temporary_ / "new");
  write_file(temporary_ / "new/fast.h", "#pragma GCC target(\"avx2\")\n");
  write_file(temporary_ / "new/team.cpp",
             "#include \"fast.h\"\nvoid twice(double* x) { *x *= 2; *x += 1; }\n");
  ASSERT_EQ(
      run({"/usr/bin/tar", "-cf", temporary_ / "new.tar", "-C", temporary_ / ".", "new"}).exit_code,
      0);
  const Outcome project =
      expect_exit(0, run_mirocup({"compile", temporary_ / "new.tar", "-o", library_}));
  EXPECT_TRUE(contains(project.out, "x86-64-v3, which end the team"));
}

}  // namespace
}  // namespace mirocup
