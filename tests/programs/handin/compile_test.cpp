// SPDX-License-Identifier: MIT
//
// Sources that attack the compiler's host, and one that is good. Catches a source that reads a file
// of the host, that fills its disk, takes its memory or its time without end, that chooses options
// or programs, and a compiler that lives longer than its source.
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace mirocup {
namespace {

namespace fs = std::filesystem;
using test_support::Outcome;
using test_support::program;
using test_support::read_file;
using test_support::run;
using test_support::TemporaryFolder;
using test_support::write_file;

class Compile : public testing::Test {
 protected:
  Compile() {
    write_file(secret_, "int the_secret_of_the_host = 1;\n");
    fs::permissions(secret_, fs::perms::all);
  }

  Outcome compile(const std::string& source, const std::string& name = "team.cpp") {
    write_file(temporary_ / name, source);
    fs::remove(library_);
    return run({program("mirocup"), "compile", temporary_ / name, "-o", library_});
  }

  // Compiled or not, nothing of the host is in what comes out.
  void expect_harmless(const std::string& what, const std::string& source) {
    const Outcome outcome = compile(source);
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1)
        << what << ": " << outcome.exit_code << outcome.err;
    EXPECT_EQ(outcome.out.find("the_secret_of_the_host"), std::string::npos) << what;
    if (!fs::exists(library_)) return;
    const std::string bytes = read_file(library_);
    EXPECT_EQ(bytes.find("the_secret_of_the_host"), std::string::npos) << what;
    EXPECT_EQ(bytes.find("root:x:0:0"), std::string::npos) << what;
    EXPECT_LE(bytes.size(), 32u << 20) << what;
  }

  void expect_refused(const std::string& what, const std::string& source) {
    expect_harmless(what, source);
    EXPECT_FALSE(fs::exists(library_)) << what;
  }

  TemporaryFolder temporary_;
  std::string secret_ = temporary_ / "secret.h";
  std::string library_ = temporary_ / "team.so";
};

TEST_F(Compile, MakesALibraryThatIsAccepted) {
  const std::string template_source = temporary_ / "new";
  ASSERT_EQ(run({program("mirocup"), "new", template_source}).exit_code, 0);
  const Outcome done = compile(read_file(template_source + "/team.cpp"));
  ASSERT_EQ(done.exit_code, 0) << done.out << done.err;
  const Outcome checked = run({program("mirocup"), "check", library_, "--half", "20"});
  EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;
}

TEST_F(Compile, SaysWhatTheCompilerSays) {
  const Outcome wrong = compile("int main() { return \x1b[31mundeclared; }");
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_NE(wrong.out.find("error:"), std::string::npos) << wrong.out;
  EXPECT_EQ(wrong.out.find('\x1b'), std::string::npos) << "text of a stranger is escaped";
  EXPECT_NE(wrong.out.find("does not compile"), std::string::npos);
  EXPECT_EQ(compile("int x;\n", "-o.c").exit_code, 0) << "a name is no option";
}

TEST_F(Compile, ReadsNoFileOfTheHost) {
  for (const std::string& file :
       {secret_, std::string("/etc/passwd"), std::string("/etc/shadow"),
        std::string("/proc/1/environ"), std::string("/proc/self/environ"), std::string("/dev/zero"),
        std::string("/dev/stdin"), std::string("/root/.bashrc"), std::string("/tmp/x"),
        std::string("../../../../etc/passwd"), std::string("/sys/kernel/notes"),
        std::string("/var/log/dpkg.log")}) {
    expect_refused("include " + file, "#include \"" + file + "\"\n");
    expect_refused("incbin " + file, "asm(\".incbin \\\"" + file + "\\\"\");\n");
    expect_refused("assembler include " + file, "asm(\".include \\\"" + file + "\\\"\");\n");
    expect_harmless("has_include " + file,
                    "#if __has_include(\"" + file + "\")\n#error it is there\n#endif\n");
    EXPECT_TRUE(fs::exists(library_)) << file << " can be seen";
  }
}

TEST_F(Compile, ChoosesNoOptionAndNoProgram) {
  expect_harmless("optimize",
                  "#pragma GCC optimize(\"-fplugin=/compile/x.so\")\nint f() { return 1; }");
  expect_harmless("target", "#pragma GCC target(\"avx512f\")\nint f() { return 1; }");
  expect_harmless("response file", "@/etc/passwd\n");
  expect_harmless("dependency", "#pragma GCC dependency \"/etc/passwd\"\nint f();");
  expect_harmless("ident", "#ident \"/etc/passwd\"\nint f();");
  expect_refused("linker script", "asm(\".section .note; .org 0xffffffffffff\");");
  expect_harmless("linker option", "asm(\".section .drectve\\n.ascii \\\"-T/etc/passwd\\\"\");");
}

TEST_F(Compile, EndsWithItsLimits) {
  expect_refused("templates without end",
                 "template<int N> struct A { static const int v = A<N+1>::v + A<N+2>::v; };\n"
                 "int f() { return A<0>::v; }\n");
  expect_refused("constexpr without end",
                 "constexpr int f(int n) { for (;;) ++n; return n; }\nconstexpr int x = f(1);\n");
  expect_refused("an array of 8 GiB", "int x[1ull << 31] = {1};\n");
  expect_refused("a section of 10 GB", "asm(\".fill 10000000000, 1, 1\");\n");
  expect_refused("repetition", "asm(\".rept 1000000000\\n.quad 1\\n.endr\");\n");
  expect_refused("includes itself", "#include __FILE__\n#include __FILE__\n");
  std::string macros = "#define A0 x,x,x,x,x,x,x,x,x,x\n";
  for (int i = 1; i < 12; ++i) {
    macros += "#define A" + std::to_string(i);
    for (int j = 0; j < 10; ++j) macros += (j == 0 ? " A" : ",A") + std::to_string(i - 1);
    macros += "\n";
  }
  expect_refused("macros without end", macros + "int y[] = {A11};\n");
  std::string errors;
  for (int i = 0; i < 20'000; ++i) errors += "error_" + std::to_string(i) + " here;\n";
  const Outcome said = compile(errors);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_LT(said.out.size(), 1u << 20) << "what a compiler says has an end";
  std::string nested(200'000, '(');
  expect_refused("parentheses", "int x = " + nested + ";\n");
}

}  // namespace
}  // namespace mirocup
