// SPDX-License-Identifier: MIT
//
// An inbox that everybody may write to. Catches one file that stops the others, a link or a second
// name by which the host's files are read, a team that plays with another's library or another
// user's file, text that steers the host's terminal, and hand-ins without a limit.
#include "tests/programs/league/league_command.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <sstream>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace mirocup {
namespace {

namespace fs = std::filesystem;
using test_support::house;
using test_support::init_league;
using test_support::league;
using test_support::Outcome;
using test_support::read_file;
using test_support::read_json;
using test_support::run;
using test_support::Running;
using test_support::TemporaryFolder;
using test_support::write_file;

// Users without an account.
constexpr uid_t alice = 64001;
constexpr uid_t mallory = 64002;

int lines_in(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

class Inbox : public testing::Test {
 protected:
  Inbox() {
    fs::create_directory(inbox_);
    init_league(folder_, {});
    write_file(secret_, "secret");
    chmod(secret_.c_str(), 0600);
  }

  std::string in(const std::string& name) const { return inbox_ + "/" + name; }

  void copy(const std::string& name, const std::string& library) {
    fs::remove(in(name));
    fs::copy_file(house(library), in(name));
  }

  // As if the user had copied the file.
  void copy_as(uid_t user, const std::string& name, const std::string& library) {
    copy(name, library);
    ASSERT_EQ(lchown(in(name).c_str(), user, user), 0);
  }

  // Everybody may write, nobody may remove files of others.
  void share() { ASSERT_EQ(chmod(inbox_.c_str(), 01777), 0); }

  Outcome submit() { return run(league("submit", folder_, {"--inbox", inbox_})); }

  void expect_one_line(const Outcome& outcome, const std::string& line) {
    const std::string text = "\n" + outcome.out;
    EXPECT_NE(text.find("\n" + line + "\n"), std::string::npos) << line << "\n-- in\n" << text;
  }

  // No copy of the secret below the league's folder.
  void expect_kept_secret() {
    for (const auto& file : fs::recursive_directory_iterator(folder_)) {
      if (!file.is_regular_file()) continue;
      EXPECT_EQ(read_file(file.path()).find("secret"), std::string::npos);
    }
  }

  TemporaryFolder temporary_;
  std::string folder_ = temporary_ / "l";
  std::string inbox_ = temporary_ / "inbox";
  std::string secret_ = temporary_ / "key";
};

TEST_F(Inbox, TakesEachFileByItself) {
  copy("good.so", "chaser");
  copy("zz.so", "keeper");
  for (const char* name : {"!.so", "Zo\u00eb.so", "a\nb: entry 7 was accepted\n.so",
                           "\x1b[31m\xff.so", "\u202eevil.so", ".so", "../up.so"}) {
    if (std::string(name).find('/') == std::string::npos) copy(name, "idle");
  }
  fs::create_symlink(secret_, in("link.so"));
  fs::create_symlink("loop.so", in("loop.so"));
  fs::create_symlink("nowhere", in("dangling.so"));
  fs::create_symlink("/dev/zero", in("zero.so"));
  fs::create_symlink("/proc/self/fd/0", in("descriptor.so"));
  fs::create_directory(in("folder.so"));
  ASSERT_EQ(mkfifo(in("pipe.so").c_str(), 0666), 0);
  write_file(in("big.so"), "");
  ASSERT_EQ(truncate(in("big.so").c_str(), off_t{8} << 30), 0);
  write_file(in("empty.so"), "");
  write_file(in("notes.txt"), "no library");

  const Outcome outcome = submit();
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_EQ(lines_in(outcome.out), 17) << outcome.out;
  for (const unsigned char c : outcome.out) EXPECT_TRUE(c == '\n' || c >= 0x20) << int{c};
  expect_one_line(outcome, "good: entry 1 was accepted");
  expect_one_line(outcome, "zz: entry 1 was accepted");
  expect_one_line(outcome, "link: not taken: " + in("link.so") +
                               ": it is a symbolic link; name the file itself");
  expect_one_line(outcome, "pipe: not taken: " + in("pipe.so") + ": it is not a regular file");
  expect_one_line(outcome, "big: not taken: " + in("big.so") + ": it is larger than 32 MiB");
  expect_one_line(
      outcome, "folder: not taken: " + in("folder.so") + ": it is a folder and not a regular file");
  expect_one_line(outcome,
                  in("Zo\u00eb.so") +
                      ": not taken: \"Zo\u00eb\" is no name: letters, digits, '-', '_' and "
                      "'.', at most 40");
  EXPECT_NE(outcome.out.find("a\\x0ab: entry 7 was accepted\\x0a"), std::string::npos);
  EXPECT_NE(outcome.out.find("\\x1b[31m\\xff"), std::string::npos);
  EXPECT_EQ(outcome.out.find("\u202e"), std::string::npos);
  EXPECT_EQ(read_json(folder_ + "/league.json")["teams"].size(), 2u);
  expect_kept_secret();

  const Outcome again = run(league("submit", folder_, {"--inbox", inbox_, "--json"}));
  EXPECT_EQ(again.exit_code, 1);
  std::istringstream lines(again.out);
  int told = 0;
  for (std::string line; std::getline(lines, line); ++told) {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    ASSERT_TRUE(json.is_object()) << line;
    EXPECT_EQ(json["accepted"], false);
    EXPECT_TRUE(json["file"].is_string());
  }
  EXPECT_EQ(told, 14) << "what was accepted and what was checked is no news";
}

TEST_F(Inbox, IsReadWithoutALibraryToo) {
  EXPECT_EQ(submit().exit_code, 0);
  EXPECT_EQ(run(league("submit", folder_, {"--inbox", temporary_ / "nowhere"})).exit_code, 3);
  EXPECT_EQ(run(league("submit", folder_, {"--inbox", secret_})).exit_code, 2);
}

TEST_F(Inbox, KeepsEntriesFromOtherUsers) {
  copy("alpha.so", "chaser");
  ASSERT_EQ(submit().exit_code, 0);
  for (const auto& file : fs::recursive_directory_iterator(folder_ + "/entries")) {
    const auto expected = file.is_directory() ? fs::perms(0700) : fs::perms(0600);
    EXPECT_EQ(file.status().permissions(), expected) << file.path();
  }
  EXPECT_EQ(fs::status(folder_ + "/entries").permissions(), fs::perms(0700));
  EXPECT_EQ(fs::status(folder_ + "/.submitting").permissions(), fs::perms(0600));
}

TEST_F(Inbox, LetsNobodyPlayWithAnothersLibrary) {
  copy("alpha.so", "chaser");
  ASSERT_EQ(submit().exit_code, 0);
  share();
  fs::create_symlink(folder_ + "/entries/alpha/1/strategy.so", in("spy.so"));
  fs::create_hard_link(folder_ + "/entries/alpha/1/strategy.so", in("twin.so"));
  const Outcome outcome = submit();
  EXPECT_EQ(outcome.exit_code, 1);
  expect_one_line(outcome, "twin: not taken: " + in("twin.so") +
                               ": it has a second name (a hard link); copy it instead");
  EXPECT_EQ(read_json(folder_ + "/league.json")["teams"].size(), 1u);
  EXPECT_FALSE(fs::exists(folder_ + "/entries/spy"));
  EXPECT_FALSE(fs::exists(folder_ + "/entries/twin"));
  const Outcome direct = run(league("submit", folder_, {"spy", in("spy.so")}));
  EXPECT_EQ(direct.exit_code, 1) << direct.out << direct.err;
}

TEST_F(Inbox, RefusesANameThatDiffersInCapitalsOnly) {
  copy("alpha.so", "chaser");
  ASSERT_EQ(submit().exit_code, 0);
  copy("ALPHA.so", "keeper");
  const Outcome outcome = submit();
  EXPECT_EQ(outcome.exit_code, 1);
  expect_one_line(outcome,
                  "ALPHA: not taken: the league has a team alpha, whose name is too similar; "
                  "choose another name");
}

TEST_F(Inbox, LimitsTriesAndVersions) {
  const std::string library = read_file(house("chaser"));
  copy("alpha.so", "chaser");
  ASSERT_EQ(submit().exit_code, 0);
  for (std::size_t i = 2; i <= 20; ++i) {
    write_file(in("alpha.so"), library.substr(0, 3000 + i));
    EXPECT_NE(submit().out.find("alpha: entry " + std::to_string(i) + " was not accepted"),
              std::string::npos);
  }
  write_file(in("alpha.so"), library.substr(0, 2000));
  const Outcome outcome = submit();
  EXPECT_EQ(outcome.exit_code, 1);
  expect_one_line(outcome,
                  "alpha: not taken: it has had 20 tries in the last hour; hand it in later");
  int libraries = 0;
  for (const auto& file : fs::recursive_directory_iterator(folder_ + "/entries/alpha"))
    libraries += file.path().extension() == ".so" ? 1 : 0;
  EXPECT_EQ(libraries, 2) << "the one that plays, and the last that was refused";
  copy("beta.so", "keeper");
  expect_one_line(submit(), "beta: entry 1 was accepted");
}

// A file that stays in an inbox is one try, however often the inbox is read.
TEST_F(Inbox, DoesNotCountAFileAgain) {
  copy("alpha.so", "chaser");
  ASSERT_EQ(submit().exit_code, 0);
  fs::remove(in("alpha.so"));
  fs::create_symlink(secret_, in("alpha.so"));
  for (int i = 0; i < 25; ++i) ASSERT_NE(submit().out.find("symbolic link"), std::string::npos);
  copy("alpha.so", "keeper");
  expect_one_line(submit(), "alpha: entry 2 was accepted");
}

TEST_F(Inbox, KeepsTheBytesThatWereChecked) {
  const std::string good = read_file(house("chaser"));
  write_file(temporary_ / "good.so", good);
  write_file(temporary_ / "evil.so", read_file(house("keeper")) + "evil");
  std::atomic<bool> is_over = false;
  std::thread swapper([&] {
    while (!is_over) {
      for (const char* name : {"good.so", "evil.so"}) {
        fs::copy_file(temporary_ / name, temporary_ / "next", fs::copy_options::overwrite_existing);
        fs::rename(temporary_ / "next", in("alpha.so"));
      }
    }
  });
  for (int i = 0; i < 6; ++i) submit();
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

TEST_F(Inbox, IsReadByTwoProcessesAtOnce) {
  const std::string other = temporary_ / "other";
  fs::create_directory(other);
  for (const char* name : {"a.so", "b.so", "c.so"}) copy(name, "idle");
  for (const char* name : {"b.so", "c.so", "d.so"})
    fs::copy_file(house("idle"), other + "/" + name);
  Running first(league("submit", folder_, {"--inbox", inbox_}));
  Running second(league("submit", folder_, {"--inbox", other}));
  const Outcome one = first.wait();
  const Outcome two = second.wait();
  EXPECT_EQ(one.exit_code, 0) << one.out << one.err;
  EXPECT_EQ(two.exit_code, 0) << two.out << two.err;
  EXPECT_EQ(lines_in(one.out) + lines_in(two.out), 4) << "each team once";
  EXPECT_EQ(read_json(folder_ + "/league.json")["teams"].size(), 4u);
}

// Nobody waits for a stranger while the lock is held, and a stranger cannot hold it.
TEST_F(Inbox, IsNotStoppedByALinkInPlaceOfTheLock) {
  copy("alpha.so", "chaser");
  fs::create_symlink(secret_, folder_ + "/.submitting");
  const Outcome outcome = submit();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find(".submitting cannot be locked: it is a symbolic link"),
            std::string::npos)
      << outcome.out;
  EXPECT_EQ(read_file(secret_), "secret");
}

class SharedInbox : public Inbox {
 protected:
  void SetUp() override {
    if (geteuid() != 0) GTEST_SKIP() << "only the superuser makes files of two users";
    share();
  }
};

TEST_F(SharedInbox, BindsATeamToTheUserOfItsFirstAcceptedFile) {
  copy_as(alice, "alpha.so", "chaser");
  expect_one_line(submit(),
                  "alpha: entry 1 was accepted; from now on user 64001 hands in for alpha");
  copy_as(mallory, "alpha.so", "keeper");
  const Outcome refused = submit();
  EXPECT_EQ(refused.exit_code, 1);
  expect_one_line(refused,
                  "alpha: not taken: the file belongs to user 64002, and user 64001 hands in for "
                  "alpha; league owner changes that");
  EXPECT_FALSE(fs::exists(folder_ + "/entries/alpha/2"));
  copy_as(alice, "alpha.so", "striker");
  expect_one_line(submit(), "alpha: entry 2 was accepted");
  copy("alpha.so", "idle");
  expect_one_line(submit(), "alpha: entry 3 was accepted");  // the host hands in for everybody

  EXPECT_EQ(run(league("owner", folder_, {"alpha"})).out,
            "alpha: user 64001 hands in by a shared inbox\n");
  EXPECT_EQ(run(league("owner", folder_, {"alpha", "nobody-of-that-name"})).exit_code, 2);
  EXPECT_EQ(run(league("owner", folder_, {"alpha", "64002"})).exit_code, 0);
  copy_as(mallory, "alpha.so", "keeper");
  expect_one_line(submit(), "alpha: entry 4 was accepted");
  EXPECT_EQ(run(league("owner", folder_, {"alpha", "--free"})).exit_code, 0);
  copy_as(alice, "alpha.so", "chaser");
  expect_one_line(submit(),
                  "alpha: entry 5 was accepted; from now on user 64001 hands in for alpha");
}

TEST_F(SharedInbox, LetsNobodyUseUpTheTriesOfAnother) {
  copy_as(alice, "alpha.so", "chaser");
  ASSERT_EQ(submit().exit_code, 0);
  for (int i = 0; i < 25; ++i) {
    copy_as(mallory, "alpha.so", "keeper");
    EXPECT_EQ(submit().exit_code, 1);
    fs::remove(in("alpha.so"));
    fs::create_symlink(secret_ + std::to_string(i), in("alpha.so"));
    ASSERT_EQ(lchown(in("alpha.so").c_str(), mallory, mallory), 0);
    EXPECT_EQ(submit().exit_code, 1);
  }
  copy_as(alice, "alpha.so", "striker");
  expect_one_line(submit(), "alpha: entry 2 was accepted");
}

TEST_F(SharedInbox, LimitsTheTeamsOfOneUserAndLetsUsersTakeTurns) {
  for (int i = 0; i < 10; ++i) copy_as(mallory, "m" + std::to_string(i) + ".so", "idle");
  copy_as(alice, "zeta.so", "idle");
  const Outcome outcome = submit();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out.substr(outcome.out.find('\n') + 1, 5), "zeta:") << outcome.out;
  expect_one_line(outcome,
                  "m9: not taken: user 64002 hands in for 8 teams already, which is the most for "
                  "one user");
  EXPECT_EQ(read_json(folder_ + "/league.json")["teams"].size(), 9u);
}

// One user who copies the files of all teams owns the inbox, or nobody else writes to it.
TEST_F(SharedInbox, TakesAnyNumberOfTeamsFromItsOwner) {
  ASSERT_EQ(chown(inbox_.c_str(), alice, alice), 0);
  for (int i = 0; i < 10; ++i) copy_as(alice, "t" + std::to_string(i) + ".so", "idle");
  EXPECT_EQ(submit().exit_code, 0);
  ASSERT_EQ(chown(inbox_.c_str(), 0, 0), 0);
  ASSERT_EQ(chmod(inbox_.c_str(), 0755), 0);
  copy_as(alice, "t0.so", "keeper");
  copy_as(mallory, "t1.so", "keeper");  // as rsync -a copies them
  const Outcome outcome = submit();
  EXPECT_EQ(outcome.out, "t0: entry 2 was accepted\nt1: entry 2 was accepted\n");
}

TEST_F(SharedInbox, ReadsNoFileOfTheHostBySecondNames) {
  fs::create_hard_link(secret_, in("alpha.so"));
  expect_one_line(submit(), "alpha: not taken: " + in("alpha.so") +
                                ": it has a second name (a hard link); copy it instead");
  expect_kept_secret();
}

// A user who may only read the league's folder can neither lock it nor misdirect a stop.
TEST_F(SharedInbox, CannotBeLockedByAReader) {
  const std::string tool = "/usr/bin/setpriv";
  if (!fs::exists(tool)) GTEST_SKIP() << tool << " is not there";
  copy("alpha.so", "chaser");
  ASSERT_EQ(submit().exit_code, 0);
  ASSERT_EQ(chmod((temporary_ / ".").c_str(), 0755), 0);
  ASSERT_EQ(chmod(folder_.c_str(), 0755), 0);
  EXPECT_NE(run({tool, "--reuid", "64001", "--regid", "64001", "--clear-groups", "flock",
                 "--nonblock", folder_ + "/.submitting", "true"})
                .exit_code,
            0);
  EXPECT_NE(run({tool, "--reuid", "64001", "--regid", "64001", "--clear-groups", "cat",
                 folder_ + "/entries/alpha/1/strategy.so"})
                .exit_code,
            0);
  write_file(folder_ + "/.running", std::to_string(getpid()) + "\n");
  const Outcome stop = run(league("stop", folder_));
  EXPECT_EQ(stop.exit_code, 1);
  EXPECT_EQ(stop.out, folder_ + " is not being played\n");
}

}  // namespace
}  // namespace mirocup
