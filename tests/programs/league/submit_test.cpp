// SPDX-License-Identifier: MIT
//
// The files that a host hands in with `mirocup league submit`. Catches a link by which a file of
// the host or another team's library becomes an entry, a wait for a pipe, a text that steers the
// host's terminal, hand-ins without a limit, an entry that others read, and bytes that nobody
// checked.
#include "tests/programs/league/league_command.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <set>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace mirocup::test_support {
namespace {

namespace fs = std::filesystem;

class Submit : public testing::Test {
 protected:
  Submit() {
    init_league(folder_, {});
    write_file(secret_, "secret");
  }

  Outcome submit(const std::string& team, const std::string& file) const {
    return run(league("submit", folder_, {team, file}));
  }

  void submit_good(const std::string& team, const std::string& file) const {
    expect_exit(0, submit(team, file));
  }

  TemporaryFolder temporary_;
  std::string folder_ = temporary_ / "l";
  std::string secret_ = temporary_ / "key";
};

TEST_F(Submit, TakesNoFileThatCannotBeALibrary) {
  submit_good("alpha", house("chaser"));
  const std::string link = "it is a symbolic link; name the file itself";
  const std::map<std::string, std::string> reasons{
      {"link", link},
      {"loop", link},
      {"dangling", link},
      {"zero", link},
      {"descriptor", link},
      {"spy", link},
      {"folder", "it is a folder and not a regular file"},
      {"pipe", "it is not a regular file"},
      {"big", "it is larger than 32 MiB"}};
  const std::string in = temporary_ / "";
  fs::create_symlink(secret_, in + "link");
  fs::create_symlink("loop", in + "loop");
  fs::create_symlink("nowhere", in + "dangling");
  fs::create_symlink("/dev/zero", in + "zero");
  fs::create_symlink("/proc/self/fd/0", in + "descriptor");
  fs::create_symlink(folder_ + "/entries/alpha/1/strategy.so", in + "spy");
  fs::create_directory(in + "folder");
  ASSERT_EQ(mkfifo((in + "pipe").c_str(), 0666), 0);
  write_file(in + "big", "");
  ASSERT_EQ(truncate((in + "big").c_str(), off_t{8} << 30), 0);
  for (const auto& [name, reason] : reasons) {
    std::string told = name;
    told += ": not taken: " + in + name;
    told += ": " + reason + "\n";
    const Outcome outcome = submit(name, in + name);
    EXPECT_EQ(outcome.exit_code, 1) << name << outcome.err;
    EXPECT_EQ(outcome.out, told);
    EXPECT_FALSE(fs::exists(folder_ + "/entries/" + name));
    EXPECT_TRUE(contains(submit("alpha", in + name).out, reason)) << name;
  }
  write_file(in + "empty", "");
  EXPECT_EQ(submit("empty", in + "empty").exit_code, 1);
  EXPECT_EQ(submit("alpha", in + "nothing").exit_code, 3);
  EXPECT_EQ(submit("alpha", "").exit_code, 2);
  EXPECT_EQ(read_json(folder_ + "/league.json")["teams"].size(), 1u);
  EXPECT_FALSE(fs::exists(folder_ + "/entries/alpha/2"));
  for (const auto& file : fs::recursive_directory_iterator(folder_)) {
    if (!file.is_regular_file()) continue;
    EXPECT_FALSE(contains(read_file(file.path()), "secret")) << file.path();
  }
}

TEST_F(Submit, PrintsNoTextThatSteersTheTerminal) {
  for (const char* team : {"!", "Zo\u00eb", "a\nb: entry 7 was accepted\n", "../up", ""}) {
    const Outcome outcome = expect_exit(2, submit(team, house("idle")));
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  }
  EXPECT_TRUE(contains(submit("a\nb", house("idle")).err, "a\\x0ab\" is no name"));
  const std::string red = temporary_ / "\x1b[31m\xff.so";
  const std::string right_to_left = temporary_ / "\u202eevil.so";
  for (const std::string& path : {red, right_to_left}) {
    fs::create_symlink(secret_, path);
    const Outcome outcome = expect_exit(1, submit("a", path));
    for (const unsigned char c : outcome.out) EXPECT_TRUE(c == '\n' || c >= 0x20) << int{c};
    EXPECT_FALSE(contains(outcome.out, "\u202e"));
    const Outcome json = expect_exit(1, run(league("submit", folder_, {"a", path, "--json"})));
    const auto answer = nlohmann::json::parse(json.out, nullptr, false);
    ASSERT_TRUE(answer.is_object()) << json.out;
    EXPECT_EQ(answer["accepted"], false);
    EXPECT_TRUE(answer["file"].is_string());
  }
  EXPECT_TRUE(contains(submit("a", red).out, "\\x1b[31m\\xff"));
}

TEST_F(Submit, KeepsEntriesFromOtherUsers) {
  submit_good("alpha", house("chaser"));
  for (const auto& file : fs::recursive_directory_iterator(folder_ + "/entries")) {
    const auto expected = file.is_directory() ? fs::perms(0700) : fs::perms(0600);
    EXPECT_EQ(file.status().permissions(), expected) << file.path();
  }
  EXPECT_EQ(fs::status(folder_ + "/entries").permissions(), fs::perms(0700));
  EXPECT_EQ(fs::status(folder_ + "/.submitting").permissions(), fs::perms(0600));
}

TEST_F(Submit, LimitsTriesAndVersions) {
  const std::string library = read_file(house("chaser"));
  const std::string cut = temporary_ / "cut.so";
  submit_good("alpha", house("chaser"));
  for (std::size_t i = 2; i <= 20; ++i) {
    write_file(cut, library.substr(0, 3000 + i));
    EXPECT_TRUE(contains(submit("alpha", cut).out,
                         "alpha: entry " + std::to_string(i) + " was not accepted"));
  }
  const Outcome outcome = expect_exit(1, submit("alpha", cut));
  EXPECT_EQ(outcome.out,
            "alpha: not taken: it has had 20 tries in the last hour; hand it in later\n");
  int libraries = 0;
  for (const auto& file : fs::recursive_directory_iterator(folder_ + "/entries/alpha"))
    libraries += file.path().extension() == ".so" ? 1 : 0;
  EXPECT_EQ(libraries, 2) << "the one that plays, and the last that was refused";
  submit_good("beta", house("keeper"));
}

TEST_F(Submit, KeepsTheBytesThatWereChecked) {
  const std::string handed_in = temporary_ / "alpha.so";
  const std::string good = read_file(house("chaser"));
  write_file(temporary_ / "good.so", good);
  write_file(handed_in, good);
  write_file(temporary_ / "evil.so", read_file(house("keeper")) + "evil");
  std::atomic<bool> is_over = false;
  std::thread swapper([&] {
    while (!is_over) {
      for (const char* name : {"good.so", "evil.so"}) {
        fs::copy_file(temporary_ / name, temporary_ / "next", fs::copy_options::overwrite_existing);
        fs::rename(temporary_ / "next", handed_in);
      }
    }
  });
  for (int i = 0; i < 6; ++i) submit("alpha", handed_in);
  is_over = true;
  swapper.join();
  int entries = 0;
  for (const auto& entry : fs::directory_iterator(folder_ + "/entries/alpha")) {
    if (!entry.is_directory()) continue;
    ++entries;
    const std::string kept = read_file(entry.path().string() + "/strategy.so");
    EXPECT_TRUE(kept == good || kept.ends_with("evil"));
    EXPECT_EQ(read_json(entry.path().string() + "/verdict.json")["sha256"],
              read_json(entry.path().string() + "/entry.json")["sha256"]);
  }
  EXPECT_GE(entries, 1);
}

TEST_F(Submit, NumbersEachEntryThoughSeveralAreHandedInAtOnce) {
  Running first(league("submit", folder_, {"alpha", house("keeper")}));
  Running second(league("submit", folder_, {"alpha", house("chaser")}));
  Running third(league("submit", folder_, {"beta", house("keeper")}));
  std::set<std::string> told;
  for (Running* const one : {&first, &second, &third}) {
    const Outcome outcome = expect_exit(0, one->wait());
    told.insert(outcome.out);
  }
  EXPECT_EQ(told,
            (std::set<std::string>{"alpha: entry 1 was accepted\n", "alpha: entry 2 was accepted\n",
                                   "beta: entry 1 was accepted\n"}));
  EXPECT_EQ(read_json(folder_ + "/league.json")["teams"].size(), 2u);
}

}  // namespace
}  // namespace mirocup::test_support
