// SPDX-License-Identifier: MIT
//
// A league's folder of a stranger, in which a link stands in the place of each folder that mirocup
// writes to. Catches a command that writes, replaces or removes anything outside of the league, or
// that goes on without a word; a command that removes files of the host beside the pages; and pages
// on another disk (the key `site`) that are not found, that overwrite files of the host, or that
// look like changed rules.
#include "tests/programs/league/league_command.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>

namespace mirocup::test_support {
namespace {

namespace fs = std::filesystem;

// Everything below a folder: the bytes and permissions of files, the targets of links.
std::map<std::string, std::string> content_of(const std::string& folder) {
  std::map<std::string, std::string> content;
  if (!fs::is_directory(folder)) return {{folder, read_file(folder)}};
  for (const auto& one : fs::recursive_directory_iterator(folder)) {
    content[one.path()] = one.is_symlink()        ? fs::read_symlink(one.path()).string()
                          : one.is_regular_file() ? read_file(one.path())
                                                  : std::string("a folder");
    content[one.path()] += " " + std::to_string(static_cast<int>(one.status().permissions()));
  }
  return content;
}

void set_day(int day) {
  setenv("MIROCUP_CLOCK_OFFSET", std::to_string(day * 86'400).c_str(), 1);
}

class LeagueOfAStranger : public testing::Test {
 protected:
  // A nightly league after one night; the same for all tests.
  static void SetUpTestSuite() {
    unsetenv("MIROCUP_CLOCK_OFFSET");
    played_ = new TemporaryFolder();
    setenv("XDG_STATE_HOME", (*played_ / "state").c_str(), 1);
    const std::string folder = *played_ / "l";
    init_league(folder, {"alpha=submitted", "beta=house:idle"}, "1", "nightly");
    ASSERT_EQ(run(league("submit", folder, {"alpha", house("idle")})).exit_code, 0);
    for (const int day : {0, 1}) {
      set_day(day);
      ASSERT_EQ(run(league("nightly", folder)).exit_code, 0);
    }
  }
  static void TearDownTestSuite() {
    delete played_;
    unsetenv("MIROCUP_CLOCK_OFFSET");
    unsetenv("XDG_STATE_HOME");
  }

  LeagueOfAStranger() {
    set_day(2);
    fs::copy(*played_ / "l", league_, fs::copy_options::recursive);
  }

  // Puts a link in the place of that part of a folder, which leads to a copy outside with files of
  // the host, and gives the command.
  void expect_refused(const std::string& part, const std::string& command,
                      const std::vector<std::string>& more = {}, const std::string& in = "") const {
    const std::string path = (in.empty() ? league_ : in) + "/" + part;
    const std::string outside = temporary_ / "outside";
    const std::string aside = temporary_ / "aside";
    const bool was_there = fs::exists(path);
    fs::remove_all(outside);
    if (was_there) {
      fs::copy(path, outside, fs::copy_options::recursive);
      fs::rename(path, aside);
    } else {
      fs::create_directories(outside);
      fs::create_directories(fs::path(path).parent_path());
    }
    if (fs::is_directory(outside)) {
      fs::create_directory(outside + "/.ssh");
      for (const char* name : {".ssh/id", "notes.txt", "index.html", "r9-f9-9-9.html"})
        write_file(outside + "/" + name, "precious");
    }
    fs::create_symlink(outside, path);
    const auto before = content_of(outside);
    const Outcome outcome = run(league(command, league_, more));
    EXPECT_GE(outcome.exit_code, 1) << part << ": " << command;
    EXPECT_LE(outcome.exit_code, 5) << part << ": " << command << outcome.err;
    const std::string said = outcome.out + outcome.err;
    EXPECT_TRUE(contains(said, path)) << command;
    EXPECT_TRUE(contains(said, "symbolic link")) << command;
    EXPECT_TRUE(content_of(outside) == before) << part << ": " << command;
    fs::remove(path);
    if (was_there) fs::rename(aside, path);
  }

  static inline TemporaryFolder* played_ = nullptr;
  const TemporaryFolder temporary_;
  const std::string league_ = temporary_ / "l";
};

TEST_F(LeagueOfAStranger, HasItsPagesInItsFolder) {
  for (const char* part : {"site", "site/replays", "site/statistics", "site/module", "site/rounds",
                           "site/teams", "site/digests", "site/index.html", "site/night.html",
                           "site/replays/r1-f1-1-1.html", "site/teams/alpha.html"}) {
    // Pages that are there are not made again, unless what the league has beside them is gone.
    fs::remove(league_ + "/site/replays/r1-f1-1-1.league.json");
    if (part == std::string("site/statistics")) fs::remove_all(league_ + "/site/replays");
    if (part == std::string("site/module")) fs::remove_all(league_ + "/site/statistics");
    expect_refused(part, "publish");
  }
  fs::remove_all(league_ + "/site");
  for (const char* part : {"site", "site/replays", "site/statistics"}) {
    expect_refused(part, "nightly");
    expect_refused(part, "start");
    expect_refused(part, "prune", {"--before", "2"});
  }
}

TEST_F(LeagueOfAStranger, HasItsRecordsEntriesAndNightsInItsFolder) {
  expect_refused("entries", "submit", {"alpha", house("chaser")});
  expect_refused("entries/alpha", "submit", {"alpha", house("chaser")});
  expect_refused("entries/.uploads", "serve", {"--hand-in"});
  expect_refused("entries", "serve", {"--hand-in"});
  expect_refused("records", "nightly");
  expect_refused("records", "start");
  if (fs::exists(league_ + "/programs")) {  // the module for browsers was built
    expect_refused("programs", "nightly");
    const std::string kept = fs::directory_iterator(league_ + "/programs")->path().filename();
    expect_refused("programs/" + kept, "nightly");
  }
  expect_refused("nights", "nightly");
  expect_refused("nights/4", "nightly", {"--another"});
  expect_refused("credentials", "credentials");
  fs::create_directories(league_ + "/credentials");
  expect_refused("credentials/teams", "credentials");
  for (const char* file : {"journal.jsonl", "notice.txt", "pruned.json", "teams.json", ".lock"})
    expect_refused(file, "team", {"alpha", "--display", "A"});
}

TEST_F(LeagueOfAStranger, IsNotWrittenThroughLinksOfItsCopies) {
  const std::string copy = temporary_ / "copy";
  fs::create_directories(league_ + "/programs/5f");
  write_file(league_ + "/programs/5f/mirocup.wasm", "a module");
  ASSERT_EQ(run(league("backup", league_, {copy})).exit_code, 0);
  for (const char* part : {"records", "entries", "entries/alpha", "nights", "programs"}) {
    fs::remove_all(copy + "/records");  // they are copied once
    expect_refused(part, "backup", {copy}, copy);
  }
}

// The way to the league, and to a folder that the host names, is the host's own.
TEST_F(LeagueOfAStranger, MayBeReachedByALink) {
  fs::create_directory_symlink(league_, temporary_ / "way");
  EXPECT_EQ(run(league("publish", temporary_ / "way")).exit_code, 0);
  EXPECT_EQ(run(league("nightly", temporary_ / "way")).exit_code, 0);
  fs::create_directory(temporary_ / "real");
  fs::create_directory_symlink(temporary_ / "real", temporary_ / "shown");
  EXPECT_EQ(run(league("export", league_, {"-o", temporary_ / "shown"})).exit_code, 0);
  EXPECT_TRUE(fs::exists(temporary_ / "real/table.json"));
}

TEST_F(LeagueOfAStranger, LosesOnlyPagesThatPublishingMakes) {
  const std::vector<std::string> kept{
      "replays/holiday.html", "replays/.ssh/id",   "replays/r9-f9-1-1.html/thesis.tex",
      "statistics/x.json",    "rounds/plan.html",  "module/app.js",
      "module/app.css",       "digests/notes.txt", "teams/notes.txt",
      "thesis/feed.xml"};
  const std::vector<std::string> gone{
      "replays/r9-f9-1-2.html", "replays/r9-f9-1-2.proof.js", "statistics/g1-r9-f9-1-2.json",
      "rounds/k9.html",         "module/0123456789abcdef.js", "module/0123456789abcdef.css",
      "teams/omega.html",       "digests/omega.html",         "feed.xml"};
  for (const auto* names : {&kept, &gone}) {
    for (const std::string& name : *names) {
      const fs::path path = league_ + "/site/" + name;
      fs::create_directories(path.parent_path());
      write_file(path, "precious");
    }
  }
  ASSERT_EQ(run(league("publish", league_)).exit_code, 0);
  for (const std::string& name : kept)
    EXPECT_EQ(read_file(league_ + "/site/" + name), "precious") << name;
  for (const std::string& name : gone) EXPECT_FALSE(fs::exists(league_ + "/site/" + name)) << name;
}

// The host names another disk, also while the league is played.
class SiteElsewhere : public LeagueOfAStranger {
 protected:
  SiteElsewhere() : config_(read_file(league_ + "/league.json")) {}

  // Adds a key behind the first mark of that text.
  void edit(const std::string& behind, const std::string& line) const {
    std::string text = config_;
    text.insert(text.find(behind) + behind.size(), line);
    write_file(league_ + "/league.json", text);
  }

  void expect_code(int code, const std::string& said,
                   const std::string& command = "publish") const {
    const Outcome outcome = expect_exit(code, run(league(command, league_)));
    EXPECT_TRUE(contains(outcome.out + outcome.err, said));
  }

  const std::string config_;
  const std::string site_ = temporary_ / "disk/site";
};

TEST_F(SiteElsewhere, HasThePagesOfEachCommand) {
  edit("{", "\n  \"site\": \"" + site_ + "/\",");
  expect_code(3, "/site: " + site_ + "/ is not there");
  fs::create_directories(site_);
  const auto before = content_of(league_ + "/site");
  expect_code(0, site_ + "/index.html");
  EXPECT_TRUE(fs::exists(site_ + "/replays/r1-f1-1-1.html"));
  fs::remove_all(site_ + "/rounds");
  ASSERT_EQ(run(league("nightly", league_)).exit_code, 0);
  EXPECT_TRUE(fs::exists(site_ + "/rounds/r3.html"));
  expect_code(0, "", "start");
  EXPECT_TRUE(content_of(league_ + "/site") == before)
      << "the former pages are the host's to remove";
  const Outcome pruned = run(league("prune", league_, {"--before", "2"}));
  EXPECT_TRUE(contains(pruned.out, "pages of 1 night are removed")) << pruned.err;
  EXPECT_FALSE(fs::exists(site_ + "/replays/r1-f1-1-1.html"));
}

TEST_F(SiteElsewhere, IsNoFolderOfTheHost) {
  edit("{", "\"site\": \"home\",");
  expect_code(2, "/site: the absolute path of a folder is expected");
  edit("{", "\"site\": \"" + site_ + "\",");
  fs::create_directories(site_);
  for (const char* name : {"index.html", "site.js", "thesis.tex"}) {
    write_file(site_ + "/" + name, "precious");
    const auto before = content_of(site_);
    for (const char* command : {"publish", "start", "nightly"})
      expect_code(2, site_ + " has other files than", command);
    EXPECT_TRUE(content_of(site_) == before);
  }
  // Pages may be moved there.
  fs::remove_all(site_);
  fs::rename(league_ + "/site", site_);
  expect_code(0, site_ + "/index.html");
}

}  // namespace
}  // namespace mirocup::test_support
