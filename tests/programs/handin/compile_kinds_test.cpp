// SPDX-License-Identifier: MIT
//
// Kinds of sources and archives that attack the computer that compiles them, each a test of its
// own, in the real sandbox with small limits of time and memory. Catches a source that reads a file
// of the host, fills its disk, takes memory or time without end or chooses options or programs; an
// archive that writes outside of its folder, or grows without end; a compiler that lives longer
// than its source.
#include "plugins/host/compile.hpp"
#include "tests/programs/handin/hostile_archive.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <zlib.h>

namespace mirocup {
namespace {

namespace fs = std::filesystem;
using plugins::SourceLanguage;
using namespace test_support;

constexpr const char* secret = "the_secret_of_the_host";
const std::string good = "int mirocup_nothing() { return 1; }\n";

enum class Expected {
  harmless,  // compiled or not, nothing of the host is in what comes out
  refused,   // there is no library
};

struct Kind {
  const char* name;
  SourceLanguage language;
  Expected expected;
  std::function<std::string(const std::string& folder)> source;  // `folder` has secret.h
  const char* words = "";  // in the reason or in what the compiler says
};

std::string gzip(const std::string& bytes) {
  z_stream stream{};
  deflateInit2(&stream, 1, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string macros_without_end() {
  std::string text = "#define A0 x,x,x,x,x,x,x,x,x,x\n";
  for (int i = 1; i < 12; ++i) {
    text += "#define A" + std::to_string(i);
    for (int j = 0; j < 10; ++j) text += (j == 0 ? " A" : ",A") + std::to_string(i - 1);
    text += "\n";
  }
  return text + "int y[] = {A11};\n";
}

std::string errors_without_end() {
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += "error_" + std::to_string(i) + " here;\n";
  return text;
}

std::function<std::string(const std::string&)> text(std::string source) {
  return [source = std::move(source)](const std::string&) { return source; };
}

std::function<std::string(const std::string&)> archive(const std::string& entries) {
  return text(tar_of(tar_entry("team.cpp", good) + entries));
}

std::string many_files() {
  std::string entries;
  for (int i = 0; i < 1100; ++i) entries += tar_entry("f" + std::to_string(i), "");
  return entries;
}

const std::vector<Kind>& kinds() {
  using enum Expected;
  using enum SourceLanguage;
  static const std::vector<Kind> all{
      {"IncludesAFileOfTheHost", cpp, refused,
       [](const std::string& f) { return "#include \"" + f + "/secret.h\"\n"; }},
      {"IncludesByAPathUpwards", cpp, refused, text("#include \"../../../../etc/passwd\"\n")},
      {"IncludesItsEnvironment", cpp, refused, text("#include \"/proc/self/environ\"\n")},
      {"IncludesADeviceWithoutEnd", cpp, refused, text("#include \"/dev/zero\"\n")},
      {"IncludesItself", cpp, refused, text("#include __FILE__\n#include __FILE__\n")},
      {"AssemblesAFileOfTheHost", cpp, refused,
       [](const std::string& f) { return "asm(\".incbin \\\"" + f + "/secret.h\\\"\");\n"; }},
      {"AssemblesAnIncludedFile", cpp, refused, text("asm(\".include \\\"/etc/passwd\\\"\");\n")},
      {"AssemblesTheDisk", cpp, refused, text("asm(\".incbin \\\"/dev/sda\\\"\");\n")},
      {"AsksForFiles", cpp, harmless,
       text("#if __has_include(\"/etc/passwd\") || __has_include(\"/root/.bashrc\")\n"
            "#error the_secret_of_the_host\n#endif\n")},
      {"NamesAPluginOfTheCompiler", cpp, harmless,
       text("#pragma GCC optimize(\"-fplugin=/compile/x.so\")\nint f() { return 1; }")},
      {"NamesAnotherProcessor", cpp, harmless,
       text("#pragma GCC target(\"avx512f\")\nint f() { return 1; }")},
      {"IsAResponseFile", cpp, refused, text("@/etc/passwd\n")},
      {"NamesADependency", cpp, refused, text("#pragma GCC dependency \"/etc/passwd\"\nint f();")},
      {"SpeaksToTheLinker", cpp, harmless,
       text("asm(\".section .drectve\\n.ascii \\\"-T/etc/passwd\\\"\");")},
      {"AbortsTheAssembler", cpp, refused, text("asm(\".print \\\"x\\\"\\n.abort\");")},
      {"HasTemplatesWithoutEnd", cpp, refused,
       text("template<int N> struct A { static const int v = A<N+1>::v + A<N+2>::v; };\n"
            "int f() { return A<0>::v; }\n")},
      {"ComputesWithoutEnd", cpp, refused,
       text("constexpr int f(int n) { for (;;) ++n; return n; }\nconstexpr int x = f(1);\n")},
      {"HasAnArrayOf8GiB", cpp, refused, text("int x[1ull << 31] = {1};\n")},
      {"FillsASectionOf10GB", cpp, refused, text("asm(\".fill 10000000000, 1, 1\");\n")},
      {"RepeatsWithoutEnd", cpp, refused, text("asm(\".rept 1000000000\\n.quad 1\\n.endr\");\n")},
      {"HasMacrosWithoutEnd", cpp, refused, text(macros_without_end())},
      {"SaysErrorsWithoutEnd", cpp, refused, text(errors_without_end())},
      {"NestsParentheses", cpp, refused, text("int x = " + std::string(30'000, '(') + ";\n")},
      {"IsNoText", cpp, refused,
       text(std::string("\0\xff\x7f"
                        "ELF",
                        6) +
            std::string(4096, '\1'))},
      {"PacksALinkToTheHost", project, refused, archive(tar_entry("a.hpp", "", '2', "/etc/passwd")),
       "is a link"},
      {"PacksALinkUpwards", project, refused,
       archive(tar_entry("a", "", '2', "../..") + tar_entry("a/x.cpp", good)), "is a link"},
      {"PacksAHardLink", project, refused, archive(tar_entry("a.hpp", "", '1', "/etc/passwd")),
       "is a link"},
      {"PacksADevice", project, refused, archive(tar_entry("a.hpp", "", '3')), "is no file"},
      {"PacksAPipe", project, refused, archive(tar_entry("a.hpp", "", '6')), "is no file"},
      {"PacksAPathFromTheRoot", project, refused, archive(tar_entry("/compile/strategy.so", "x")),
       "path from the root"},
      {"PacksAPathUpwards", project, refused, archive(tar_entry("a/../../x.cpp", good)),
       "leads out"},
      {"PacksAnOptionAsAName", project, refused, archive(tar_entry("-fplugin=x.cpp", good)),
       "starts with '-'"},
      {"PacksAResponseFileAsAName", project, refused, archive(tar_entry("@x.cpp", good)),
       "starts with '-' or '@'"},
      {"PacksANameWithAnEndOfLine", project, refused, archive(tar_entry("a\n.cpp", good)),
       "a character in its name"},
      {"PacksAFileTwice", project, refused, archive(tar_entry("team.cpp", good)), "is there twice"},
      {"PacksAFileAsAFolder", project, refused, archive(tar_entry("team.cpp/x.cpp", good)),
       "is there twice"},
      {"PacksABomb", project, refused,
       [](const std::string&) {
         return gzip(tar_of(tar_entry("a.bin", std::string(64u << 20, '\0'))));
       },
       "too large"},
      {"PacksABombInAFolderThatIsLeftOut", project, refused,
       [](const std::string&) {
         // What gzip has packed may be put together.
         const std::string part = gzip(tar_entry("build/a.bin", std::string(60u << 20, '\0')));
         return part + part + part + part + part + gzip(tar_of(tar_entry("team.cpp", good)));
       },
       "too large"},
      {"PacksTooManyFiles", project, refused, archive(many_files()), "more than"},
      {"PacksFoldersWithoutEnd", project, refused,
       archive(tar_entry("a/a/a/a/a/a/a/a/a/a/a/a/a/x.cpp", good)), "too many folders"},
      {"ClaimsASizeThatItDoesNotHave", project, refused,
       archive(tar_entry("a.hpp", "x", '0', "", 8589934591LL)), ""},
      {"IsCutOff", project, refused,
       text(tar_entry("team.cpp", std::string(2000, ' ')).substr(0, 900)), ""},
      {"IsNoArchive", project, refused, text("PK\3\4 and nothing else"), ""},
      {"IsAnArchiveWithoutASource", project, refused,
       text(tar_of(tar_entry("README.md", "x") + tar_entry("a_test.cpp", good))), "no source"},
      {"IsAnArchiveInAnArchive", project, refused,
       archive(tar_entry("a.tar", tar_of(tar_entry("-x.cpp", good))) +
               tar_entry("x.cpp", "#include \"a.tar\"\n"))},
      {"BringsItsOwnBuild", project, harmless,
       archive(tar_entry("CMakeLists.txt", "execute_process(COMMAND cat /etc/passwd)") +
               tar_entry("Makefile", "all:\n\tcat /etc/passwd\n") +
               tar_entry("specs", "*cc1: /bin/sh"))},
      {"HasUmlautsInItsZip", project, harmless,
       [](const std::string& folder) {
         const std::string path = folder + "/team.zip";
         run({"/usr/bin/env", "python3", "-c",
              "import sys, zipfile\nwith zipfile.ZipFile(sys.argv[1], 'w') as packed: "
              "packed.writestr('Gr\\u00f6\\u00dfe/team.cpp', sys.argv[2])",
              path, good});
         return read_file(path);
       }},
      {"ReadsTheHostFromAProject", project, refused,
       archive(tar_entry("src/x.cpp", "#include \"/etc/passwd\"\n"))},
  };
  return all;
}

plugins::CompilerKit kit() {
  const fs::path build = fs::path(program("mirocup")).parent_path();
  return {.headers = build / "include" / "mirocup",
          .predict = build / "lib" / "libmirocup_predict.a",
          .project_compiler = program("mirocup-project-compiler")};
}

class HostileSource : public testing::TestWithParam<Kind> {};

TEST_P(HostileSource, DoesNoHarm) {
  const Kind& kind = GetParam();
  const TemporaryFolder temporary;
  write_file(temporary / "secret.h", std::string("int ") + secret + " = 1;\n");
  fs::permissions(temporary / "secret.h", fs::perms::all);
  const auto done = plugins::compile_in_sandbox(
      kind.source(fs::path(temporary / "secret.h").parent_path()), kind.language, kit(),
      {.seconds = 120.0, .cpu_seconds = 2, .memory = std::size_t{400} << 20});
  if (!done && done.error().code == Errc::unavailable) GTEST_SKIP() << done.error().what;
  ASSERT_TRUE(is_ok(done));
  EXPECT_FALSE(contains(done->library, secret));
  EXPECT_FALSE(contains(done->library, "root:x:0:0"));
  EXPECT_FALSE(contains(done->output, secret));
  EXPECT_FALSE(contains(done->output, "root:x:0:0"));
  EXPECT_LE(done->output.size(), 1u << 17) << "what a compiler says has an end";
  EXPECT_NE(done->library.empty(), done->why_not.empty());
  if (kind.expected == Expected::refused) {
    EXPECT_TRUE(done->library.empty());
  } else {
    EXPECT_FALSE(done->library.empty()) << done->why_not << done->output;
  }
  EXPECT_TRUE(contains(done->why_not + done->output, kind.words));
}

// Catches a limit on the clock, by which a busy machine refuses a good source, and one of a single
// process: the compiler's driver uses nothing itself.
TEST(HostileSources, HaveProcessorTimeOfAllProcessesTogether) {
  const auto done =
      plugins::compile_in_sandbox("#include <regex>\nstd::regex any(\".*\");\n",
                                  plugins::SourceLanguage::cpp, kit(), {.seconds = 0.1});
  if (!done && done.error().code == Errc::unavailable) GTEST_SKIP() << done.error().what;
  ASSERT_TRUE(is_ok(done));
  EXPECT_EQ(done->why_not.find("compiling it takes more than 0 s of processor time"), 0u)
      << done->why_not;
}

INSTANTIATE_TEST_SUITE_P(Kinds, HostileSource, testing::ValuesIn(kinds()),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace mirocup
