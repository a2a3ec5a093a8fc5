// SPDX-License-Identifier: MIT
//
// Copies of a league that is being played, a disk that is full, and teams that are written into
// league.json by hand. MIROCUP_BACKUPS=50 build/league_tests --gtest_filter='Backup.*' takes many
// copies. Catches a copy whose journal names what it does not have, a journal whose last lines are
// lost and that is played on, a command that leaves out a leg and ends with 0, a league that tries
// each leg again on a full disk, a house team that cannot be added.
#include "system/text.hpp"
#include "tests/programs/league/league_command.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <sys/mount.h>
#include <unistd.h>

namespace mirocup {
namespace {

namespace fs = std::filesystem;

using namespace test_support;

const std::vector<std::string> backup_teams{"a=house:chaser", "b=house:keeper", "c=house:striker",
                                            "d=house:idle"};

TEST(Backup, OfALeagueThatIsPlayedEndsWithTheSamePages) {
  const char* wanted = std::getenv("MIROCUP_BACKUPS");
  const int most = wanted != nullptr ? std::atoi(wanted) : 3;
  const TemporaryFolder temporary;
  const std::string whole = temporary / "whole/l";
  init_league(whole, backup_teams, "10");
  std::mt19937 random(5);
  int taken = 0;
  // Each play gives some moments; the copies of one are updates of the copy before.
  for (int play = 0; taken < most; ++play) {
    const std::string folder = temporary / ("play" + std::to_string(play) + "/l");
    const std::string copy = temporary / ("copy" + std::to_string(play) + "/l");
    init_league(folder, backup_teams, "10");
    Running running(league("start", folder, {"--jobs", "2"}));
    ASSERT_TRUE(wait_until_it_plays(folder));
    for (int i = 0; i < 3 && taken < most; ++i, ++taken) {
      usleep(static_cast<useconds_t>(random() % 700'000));
      expect_exit(0, run(league("backup", folder, {copy})));
      const std::string restored =
          temporary / ("restored" + std::to_string(play) + std::to_string(i) + "/l");
      fs::create_directories(fs::path(restored).parent_path());
      fs::copy(copy, restored, fs::copy_options::recursive);
      expect_exit(0, run(league("start", restored)));
      if (!fs::exists(whole + "/site")) {
        ASSERT_EQ(run(league("start", whole)).exit_code, 0);
      }
      expect_same_site(restored, whole);
      EXPECT_EQ(count_kind(restored, "leg"), 12);
      EXPECT_EQ(run(league("verify", restored)).exit_code, 0);
      fs::remove_all(fs::path(restored).parent_path());
    }
    running.signal(SIGTERM);
    running.wait();
  }
  std::printf("%d copies of a league that is played were restored\n", taken);
}

TEST(Backup, IsNeitherInsideTheLeagueNorOverAnotherOne) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:chaser", "b=house:keeper"});
  ASSERT_EQ(run(league("start", folder)).exit_code, 0);
  const auto refusal_of = [&](const std::string& to) {
    const Outcome outcome = run(league("backup", folder, {to}));
    EXPECT_EQ(outcome.exit_code, 2) << to;
    return outcome.err;
  };
  EXPECT_TRUE(contains(refusal_of(folder), "in the folder of the league itself"));
  EXPECT_TRUE(contains(refusal_of(folder + "/./backup"), "in the folder of"));
  EXPECT_FALSE(fs::exists(folder + "/backup"));

  ASSERT_EQ(run(league("backup", folder, {temporary / "copy"})).exit_code, 0);
  ASSERT_EQ(run(league("backup", folder, {temporary / "copy"})).exit_code, 0) << "again";
  const std::vector<std::string> decision{"r1-f1", "--leg", "1", "--reason", "cable fault"};
  ASSERT_EQ(run(league("void", temporary / "copy", decision)).exit_code, 0);
  const std::string decided = read_file(temporary / "copy/journal.jsonl");
  EXPECT_TRUE(contains(refusal_of(temporary / "copy"),
                       "is a copy of another league, or legs were played in the copy"));
  EXPECT_EQ(read_file(temporary / "copy/journal.jsonl"), decided);
}

// Two nights of a league, then a decision; and a copy of the league after the first night.
class LostLines : public testing::Test {
 protected:
  LostLines() {
    setenv("XDG_STATE_HOME", (temporary_ / "state").c_str(), 1);
    init_league(whole_, {"a=house:idle", "b=house:idle"}, "0.2", "nightly");
    EXPECT_EQ(run(league("nightly", whole_)).exit_code, 0);
    EXPECT_EQ(run(league("backup", whole_, {old_})).exit_code, 0);
    EXPECT_EQ(run(league("nightly", whole_, {"--another"})).exit_code, 0);
    EXPECT_EQ(run(league("award", whole_, {"r2-f1", "b", "--all-legs", "--reason", "x"})).exit_code,
              0);
  }
  ~LostLines() override { unsetenv("XDG_STATE_HOME"); }

  std::string path(const std::string& name) const { return folder_ + "/" + name; }

  void begin() const {
    fs::remove_all(folder_);
    fs::copy(whole_, folder_, fs::copy_options::recursive);
  }

  // The journal without its last lines.
  static std::string first_lines(const std::string& journal, int lines) {
    std::size_t end = 0;
    for (; lines > 0; --lines) end = journal.find('\n', end) + 1;
    return journal.substr(0, end);
  }

  // Expects that a command ends with this code, says these words, and leaves journal and pages.
  void expect_said(const std::vector<std::string>& words, int code, const std::string& said) const {
    const std::string journal = read_file(path("journal.jsonl"));
    const auto site = site_of(folder_);
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, code) << words[2] << ": " << outcome.out << outcome.err;
    EXPECT_TRUE(contains(outcome.out + outcome.err, said)) << words[2];
    EXPECT_EQ(read_file(path("journal.jsonl")), journal) << words[2];
    EXPECT_TRUE(site_of(folder_) == site) << words[2];
  }

  void expect_lost(const std::string& said) const {
    expect_said(league("verify", folder_), 1, said);
    expect_said(league("health", folder_), 1, said);
    expect_said(league("health", folder_, {"--json"}), 1, "\"needs_person\":true");
    expect_said(league("status", folder_), 0, said);
    expect_said(league("decisions", folder_), 0, said);
    expect_said(league("grades", folder_), 1, said);
    expect_said(league("publish", folder_), 1, said);
    expect_said(league("export", folder_, {"-o", temporary_ / "export"}), 1, said);
    fs::remove_all(temporary_ / "copy");
    expect_said(league("backup", folder_, {temporary_ / "copy"}), 1, said);
    for (const char* command : {"nightly", "start"}) {
      expect_said(league(command, folder_), 4, said);
      expect_said(league(command, folder_), 4, "from the last copy that league backup made");
    }
    expect_said(league("nightly", folder_, {"--another"}), 4, said);
  }

  const TemporaryFolder temporary_;
  const std::string whole_ = temporary_ / "whole";
  const std::string old_ = temporary_ / "old";
  const std::string folder_ = temporary_ / "l";
};

// Catches a decision that is gone without a word, and one that is then made over the gap.
TEST_F(LostLines, AreNamedByTheHead) {
  const std::string journal = read_file(whole_ + "/journal.jsonl");
  const int lines = static_cast<int>(std::count(journal.begin(), journal.end(), '\n'));
  const std::string last = "it ends before line " + std::to_string(lines) + ", the last line by";
  for (const std::string& left : {first_lines(journal, lines - 1), journal.substr(0, 2000),
                                  journal.substr(0, journal.size() - 1), first_lines(journal, 1)}) {
    SCOPED_TRACE(left.size());
    begin();
    write_file(path("journal.jsonl"), left);
    expect_lost(last);
    if (left.size() + 2 > journal.size())
      expect_said(league("void", folder_, {"r1-f1", "--leg", "1", "--reason", "x"}), 4, last);
  }
  begin();
  fs::copy_file(old_ + "/journal.jsonl", path("journal.jsonl"),
                fs::copy_options::overwrite_existing);
  expect_lost(last);
  begin();
  write_file(path("journal.head"), "{}");
  expect_lost("journal.head: ");
  // The remedies.
  ASSERT_EQ(run(league("backup", whole_, {temporary_ / "new"})).exit_code, 0);
  for (const char* file : {"journal.jsonl", "journal.head"})
    fs::copy_file(temporary_ / "new/" + file, path(file), fs::copy_options::overwrite_existing);
  expect_said(league("verify", folder_), 0, "4 of 4 records reproduced");
  expect_said(league("health", folder_), 0, "night 2 began");
}

// Catches a journal that agrees with its head, or has none, and lacks a night that was played.
TEST_F(LostLines, AreNamedByNightsAndRecords) {
  const std::string journal = read_file(whole_ + "/journal.jsonl");
  begin();
  fs::remove(path("journal.head"));
  write_file(path("journal.jsonl"), first_lines(journal, 1));
  expect_lost("the lines of nights/1, nights/2, records/r1-f1-1-1.json");
  // Catches a copy without its journal that plays the league anew: the decisions were lost.
  fs::remove(path("journal.jsonl"));
  for (const char* command : {"nightly", "start"})
    expect_said(league(command, folder_), 4, "the lines of nights/1, nights/2");
  begin();
  for (const char* file : {"journal.jsonl", "journal.head"})
    fs::copy_file(old_ + "/" + file, path(file), fs::copy_options::overwrite_existing);
  expect_lost("the lines of nights/2, records/r2-f1-1-1.json, records/r2-f1-2-1.json");
  expect_said(league("verify", folder_), 1, "\nrecords/r2-f1-1-1.json: the journal has no line");
  fs::rename(path("nights/2"), temporary_ / "night");
  fs::remove_all(temporary_ / "copy");
  expect_lost("the lines of records/r2-f1-1-1.json, records/r2-f1-2-1.json are lost");
  for (const char* leg : {"1", "2"}) {
    for (const char* end : {"-1.json", "-1.replay.zst"})
      fs::remove(path("records/r2-f1-") + leg + end);
  }
  expect_exit(0, run(league("nightly", folder_, {"--another"})));
  EXPECT_EQ(run(league("verify", folder_)).exit_code, 0);
}

// Catches a played leg that nobody mentions, and one whose alarm keeps the league from entering it.
TEST(UnbookedRecord, IsNamedAndEntered) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:idle", "b=house:idle"}, "0.2");
  ASSERT_EQ(run(league("start", folder)).exit_code, 0);
  const std::string journal = read_file(folder + "/journal.jsonl");
  write_file(folder + "/journal.jsonl",
             journal.substr(0, journal.rfind('\n', journal.size() - 2) + 1));
  fs::remove(folder + "/journal.head");
  for (const char* command : {"verify", "health"}) {
    const Outcome outcome = run(league(command, folder));
    EXPECT_EQ(outcome.exit_code, 1) << command;
    EXPECT_TRUE(contains(outcome.out, "records/r1-f1-2-1.json"));
  }
  ASSERT_EQ(run(league("start", folder)).exit_code, 0);
  EXPECT_EQ(count_kind(folder, "leg"), 2);
  EXPECT_EQ(run(league("verify", folder)).exit_code, 0);
}

// Catches a command that leaves out what the journal names and ends with 0. The pages were made
// before, so that only the file itself is missing.
TEST(NamedFile, ThatIsMissingOrALinkIsNamed) {
  const TemporaryFolder temporary;
  const std::string whole = temporary / "whole";
  init_league(whole, {"site=house:idle", "b=house:idle"}, "0.2");
  ASSERT_EQ(run(league("start", whole)).exit_code, 0);
  const Outcome first = expect_exit(0, run(league("backup", whole, {temporary / "first"})));
  int files = 0;
  for (const auto& file : fs::recursive_directory_iterator(temporary / "first"))
    files += file.is_regular_file() ? 1 : 0;
  EXPECT_TRUE(
      contains(first.out, ": " + std::to_string(files) + " files copied, 0 files of records were"));
  const Outcome again = run(league("backup", whole, {temporary / "first"}));
  EXPECT_TRUE(contains(again.out, ", 4 files of records were in the copy already"));

  const std::string folder = temporary / "l";
  const std::string record = "records/r1-f1-1-1.json";
  const std::string replay = "records/r1-f1-2-1.replay.zst";
  for (const std::string& name : {record, replay, std::string("entries/site/1/strategy.so")}) {
    for (const bool is_link : {true, false}) {
      SCOPED_TRACE(name + (is_link ? " is a link" : " is gone"));
      fs::remove_all(folder);
      fs::copy(whole, folder, fs::copy_options::recursive);
      fs::rename(folder + "/" + name, temporary / "away");
      if (is_link) fs::create_symlink(temporary / "away", folder + "/" + name);
      for (const auto& words :
           {league("backup", folder, {temporary / "second"}), league("publish", folder),
            league("export", folder, {"-o", temporary / "export"}),
            league("export", folder, {"--sources", "-o", temporary / "sources"}),
            league("health", folder)}) {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 1) << words[2] << outcome.out << outcome.err;
        EXPECT_TRUE(contains(outcome.out + outcome.err, name)) << words[2];
      }
      EXPECT_FALSE(fs::exists(temporary / "second/" + name));
      for (const char* made : {"second", "export", "sources"}) fs::remove_all(temporary / made);
    }
  }
  // A folder that is a link is not copied, although the files in it can be read.
  fs::remove_all(folder);
  fs::copy(whole, folder, fs::copy_options::recursive);
  fs::rename(folder + "/records", temporary / "elsewhere");
  fs::create_directory_symlink(temporary / "elsewhere", folder + "/records");
  const Outcome linked = run(league("backup", folder, {temporary / "second"}));
  EXPECT_NE(linked.exit_code, 0);
  EXPECT_TRUE(contains(linked.err, "records"));
}

// Catches pages that every visitor loads anew, and a disk that is written to for nothing.
TEST(Publish, WritesOnlyWhatHasChanged) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:striker", "b=house:idle"}, "1");
  ASSERT_EQ(run(league("start", folder)).exit_code, 0);
  namespace fs = std::filesystem;
  const auto times = [&] {
    std::map<std::string, fs::file_time_type> times;
    for (const auto& file : fs::recursive_directory_iterator(folder + "/site"))
      times[file.path()] = file.last_write_time();
    return times;
  };
  const auto before = times();
  EXPECT_GT(before.size(), 10u);
  EXPECT_EQ(run(league("publish", folder)).exit_code, 0);
  EXPECT_TRUE(times() == before);
  const std::string page = folder + "/site/teams/a.html";
  write_file(page, "another page");
  EXPECT_EQ(run(league("publish", folder)).exit_code, 0);
  EXPECT_NE(read_file(page), "another page");
}

// Catches tables with fewer legs than the league, of which only the replay pages know.
TEST(Publish, NamesTheLegsWithoutPageOrNumbers) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:striker", "b=house:idle"}, "1");
  ASSERT_EQ(run(league("start", folder)).exit_code, 0);
  EXPECT_EQ(run(league("publish", folder)).exit_code, 0);
  const std::string replay = folder + "/records/r1-f1-1-1.replay.zst";
  write_file(replay, read_file(replay).substr(1));
  EXPECT_EQ(run(league("publish", folder)).exit_code, 1) << "its page is older than its replay";
  fs::remove_all(folder + "/site");
  for (const char* command : {"publish", "start", "nightly"}) {
    const Outcome outcome = run(league(command, folder));
    EXPECT_EQ(outcome.exit_code, 1) << command;
    EXPECT_TRUE(contains(outcome.err, "1 replay pages could not be made: records/r1-f1-1-1.json; "))
        << command;
    EXPECT_TRUE(contains(outcome.err, "statistics and goals lack 1 legs: records/r1-f1-1-1.json; "))
        << command;
  }
}

TEST(Verify, NamesARecordThatWasChangedOrIsGone) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:chaser", "b=house:keeper"});
  ASSERT_EQ(run(league("start", folder)).exit_code, 0);
  EXPECT_EQ(run(league("verify", folder)).exit_code, 0);
  const std::string record = folder + "/records/r1-f1-1-1.json";
  const std::string text = read_file(record);
  write_file(record, text.substr(0, text.size() / 2));
  Outcome outcome = expect_exit(4, run(league("verify", folder)));
  EXPECT_TRUE(contains(outcome.out, "records/r1-f1-1-1.json: "));
  fs::remove(record);
  outcome = run(league("verify", folder));
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_TRUE(contains(outcome.out, "the journal names it"));
}

// Needs the right to mount, as the tests of full disks of the match server do.
TEST(FullDisk, StopsALeagueAtOnceAndSaysSo) {
  const TemporaryFolder temporary;
  const std::string disk = temporary / "disk";
  fs::create_directory(disk);
  constexpr std::uintmax_t room = 16 << 20;
  if (mount("none", disk.c_str(), "tmpfs", 0, ("size=" + std::to_string(room)).c_str()) != 0)
    GTEST_SKIP() << "this user may not mount";
  const std::string folder = disk + "/l";
  init_league(folder, backup_teams, "10");
  expect_exit(0, run(league("start", folder, {"--jobs", "1"})));
  fs::remove_all(folder + "/site");
  // The next league finds no room for its records.
  const std::string other = disk + "/other";
  init_league(other, backup_teams, "10");
  if (fs::exists(folder + "/programs"))
    fs::copy(folder + "/programs", other + "/programs",
             fs::copy_options::recursive | fs::copy_options::create_hard_links);
  // There is room for lines of the journal, but not for a record and its replay.
  constexpr std::uintmax_t left = 16 << 10;
  const std::string filling(4 << 10, 'x');
  const std::string filler = disk + "/filler";
  fs::create_directory(filler);
  for (int i = 0; fs::space(disk).available > left; ++i)
    write_file(filler + "/" + std::to_string(i), filling);
  expect_exit(3, run(league("start", other, {"--jobs", "1"})), "full");
  EXPECT_EQ(count_kind(other, "void"), 0) << "no leg is tried again";
  fs::remove_all(filler);
  EXPECT_EQ(run(league("start", other)).exit_code, 0);
  EXPECT_EQ(count_kind(other, "leg"), 12);
  EXPECT_EQ(umount(disk.c_str()), 0);
}

// A check that goes on, or was killed, used to be called a refusal.
TEST(Teams, AreNotRefusedBeforeTheirCheckHasEnded) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:chaser", "b=house:keeper"});
  Running check(league("submit", folder, {"a", house("striker")}));
  ASSERT_TRUE(wait_until(
      [&] { return read_file(folder + "/hand-ins.jsonl").find("striker") != std::string::npos; }));
  check.signal(SIGKILL);
  check.wait();
  ASSERT_FALSE(fs::exists(folder + "/entries/a/2/entry.json")) << "it was too quick";
  const Outcome outcome = run(league("status", folder, {"--entries"}));
  EXPECT_TRUE(contains(outcome.out, "a: waits for its check, "));
  EXPECT_FALSE(contains(outcome.out, "refused"));
}

// Three books used to know different teams: the class list, the league, and the tokens.
TEST(Teams, AreThoseOfTheClassListEverywhere) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  const std::string list = temporary / "class.csv";
  init_league(folder, {}, "0.2", "nightly");
  expect_exit(2, run(league("token", folder, {"--all", "--csv"})), "the league has no team");

  const std::string text =
      "\xef\xbb\xbfteam;display;members;mail\r\na;Zoë & Co;\"Ada;Bo\";\"ada@x;bo@x\"\r\n"
      "b;\"=cmd|' /C calc'!A0\";Cy;cy@x\r\nc;;Di;di@x\r\nd;;;\r\n";
  write_file(list, text);
  const std::string before = read_file(folder + "/league.json");
  const Outcome dry = run(league("team", folder, {"--csv", list, "--dry-run"}));
  EXPECT_EQ(read_file(folder + "/league.json"), before);
  EXPECT_FALSE(fs::exists(folder + "/teams.json") || fs::exists(folder + "/class-list"));
  const Outcome made = run(league("team", folder, {"--csv", list}));
  EXPECT_EQ(system::replaced(dry.out, " (not written: a dry run)", ""), made.out);
  EXPECT_EQ(made.out, list +
                          ": 4 teams, 4 members, 4 mails, 4 new to the league\ncolumns kept for "
                          "the grades: mail\n");
  EXPECT_EQ(run(league("team", folder, {"--csv", list})).out,
            list +
                ": 4 teams, 4 members, 4 mails, 0 new to the league\ncolumns kept for the grades: "
                "mail\n");
  EXPECT_EQ(read_json(folder + "/league.json")["teams"].size(), 4u);

  // What docs/hosting.md once said to do: the shell empties the list before the program begins.
  const auto words = league("token", folder, {"--all", "--csv"});
  const Outcome over =
      expect_exit(2, run({"/bin/sh", "-c",
                          "'" + words[0] + "' league token " + folder + " --all --csv > " + list}));
  EXPECT_EQ(read_file(list), text) << over.err;
  const std::string tokens = run(words).out;
  EXPECT_EQ(tokens.rfind("team,display,token,members,mail\na,Zoë & Co,", 0), 0u) << tokens;
  EXPECT_TRUE(contains(tokens, ",Ada; Bo,ada@x;bo@x\nb,"));
  EXPECT_EQ(std::count(tokens.begin(), tokens.end(), '\n'), 5) << tokens;
  EXPECT_TRUE(contains(tokens, "\nb,'=cmd|' /C calc'!A0,"));
  EXPECT_EQ(run(words).out, "team,display,token,members,mail\n");
  const std::string each = run(league("token", folder, {"a", "--csv", "--per-member"})).out;
  EXPECT_EQ(std::count(each.begin(), each.end(), '\n'), 3) << each;
  EXPECT_TRUE(contains(each, ",Bo,bo@x\n"));

  for (const std::string team : {"a", "b"})
    EXPECT_EQ(run(league("submit", folder, {team, house("chaser")})).exit_code, 0);
  write_file(temporary / "bad.so", "no library");
  EXPECT_EQ(run(league("submit", folder, {"c", temporary / "bad.so"})).exit_code, 1);
  const Outcome night = expect_exit(0, run(league("nightly", folder)));
  EXPECT_TRUE(contains(night.out, "d: nothing was handed in"));
  // A student who comes later, and a typing error that is taken out again.
  write_file(list, text + "e;Echo;Ed;ed@x\r\nx;;;\r\n");
  EXPECT_EQ(run(league("team", folder, {"--csv", list})).exit_code, 0);
  EXPECT_EQ(count_kind(folder, "join"), 2);
  EXPECT_EQ(run(league("team", folder, {"x", "--remove"})).exit_code, 2) << "it is in the journal";
  const auto status =
      nlohmann::json::parse(run(league("status", folder, {"--entries", "--json"})).out);
  EXPECT_EQ(status["teams"].size(), 6u);
  const std::string grades = run(league("grades", folder)).out;
  EXPECT_EQ(std::count(grades.begin(), grades.end(), '\n'), 7) << grades;
  const std::string moodle = run(league("grades", folder, {"--moodle"})).out;
  EXPECT_EQ(std::count(moodle.begin(), moodle.end(), '\n'), 6) << moodle;
}

TEST(Teams, OfAClassListAreRefusedWithLineAndReason) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  const std::string list = temporary / "class.csv";
  init_league(folder, {"Beta=submitted"});
  const std::string config = read_file(folder + "/league.json");
  const std::pair<const char*, const char*> cases[]{
      {"name,members\na,b\n", "line 1: the first line names the columns, as in "},
      {"team,display,members\n\na,A,x\na,B,y\n", "line 4: a is in line 3 as well"},
      {"team,display,members\na,A,x\nA,B,y\n", "line 3: A is in line 2 as well"},
      {"team,display,members\na,Alpha,x\nb,alpha,y\n", "line 3: b would be called \"alpha\""},
      {"team,display,members\na,b,x\nb,Bee,y\n", "line 2: a would be called \"b\""},
      {"team,display,members\na,A B,x\nb,A\xc2\xa0"
       "B,y\n",
       "line 3: b would be called"},
      {"team,display,members\na,L\u00f6wen,x\nb,Lo\u0308wen,y\n", "line 3: b would be called"},
      {"team,display,members\na,M\u00dcLLER,x\nb,m\u00fcller,y\n", "line 3: b would be called"},
      {"team,display,members\na,A\xe2\x80\xae"
       "B,x\n",
       "line 2: a: a name has a character that nobody sees, U+202E"},
      {"team,display,members\nbeta,B,x\n", "line 2: beta is new to the league: the league has a "},
      {"team,display,members\nZoë,B,x\n", "line 2: \"Zoë\" is no name of a team"},
      {"team,display,members\na,B\n", "line 2: 3 cells are expected, and it has 2"},
      {"team,team,members\na,B,x\n", "line 1: two columns are called \"team\""},
      {"team,display\na,\"B\nb,C\n", "line 2: a quotation mark"},
      {"\xff\xfet", "line 1: it is damaged text in UTF-16"}};
  for (const auto& [text, why] : cases) {
    write_file(list, text);
    const Outcome outcome = run(league("team", folder, {"--csv", list}));
    EXPECT_EQ(outcome.exit_code, 2) << text;
    EXPECT_TRUE(contains(outcome.err, "class.csv: " + std::string(why))) << why;
  }
  EXPECT_EQ(read_file(folder + "/league.json"), config);
  write_file(list, "team;display\na;M\xfcller\n");
  expect_exit(0, run(league("team", folder, {"--csv", list})), "Windows-1252");
  EXPECT_EQ(run(league("team", folder, {"a", "--display", "Müller"})).out, "a: Müller\n");
  EXPECT_EQ(run(league("team", folder, {"Beta", "--display", "müller"})).exit_code, 2);
  EXPECT_EQ(run(league("team", folder, {"Beta", "--display", "A"})).exit_code, 2);
  EXPECT_EQ(run(league("team", folder, {"a", "--remove"})).exit_code, 0);
  EXPECT_EQ(read_json(folder + "/league.json")["teams"].size(), 1u);
  // Before the start, a team that does not come is left out.
  expect_exit(2, run(league("start", folder)));
  EXPECT_EQ(run(league("withdraw", folder, {"Beta", "--reason", "does not come"})).exit_code, 0);
  EXPECT_EQ(read_json(folder + "/league.json")["teams"].size(), 0u);
}

// After root had written once, the owner could not go on.
TEST(Leagues, AreWrittenByTheirOwnerOnly) {
  if (geteuid() != 0) GTEST_SKIP() << "only the superuser makes files of two users";
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:idle", "b=house:idle"}, "0.1");
  constexpr uid_t other = 4711;
  ASSERT_EQ(lchown((folder + "/league.json").c_str(), other, other), 0);
  for (const auto& words :
       {league("start", folder), league("team", folder, {"a", "--display", "A"}),
        league("token", folder, {"a"}), league("submit", folder, {"c", "house:idle"}),
        league("withdraw", folder, {"a", "--reason", "x"})}) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 3) << words[2] << outcome.err;
    EXPECT_TRUE(contains(outcome.err, folder + " belongs to user 4711"));
  }
  EXPECT_FALSE(fs::exists(folder + "/journal.jsonl"));
  EXPECT_EQ(run(league("status", folder)).exit_code, 1) << "whoever may read may look";
  ASSERT_EQ(lchown((folder + "/league.json").c_str(), 0, 0), 0);
  ASSERT_EQ(run(league("start", folder)).exit_code, 0);
  std::string journal = read_file(folder + "/journal.jsonl");
  write_file(folder + "/journal.jsonl", journal.insert(journal.find('\n'), "\r"));
  const Outcome damaged =
      expect_exit(4, run(league("status", folder)), "its line ends were changed");
  EXPECT_TRUE(contains(damaged.err, "put back journal.jsonl and journal.head from the last copy"));
}

TEST(Teams, MayBeAddedAfterInit) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:chaser"});
  EXPECT_EQ(run(league("submit", folder, {"striker", "house:striker"})).out,
            "striker: entry 1 was accepted\n");
  EXPECT_EQ(run(league("submit", folder, {"x", "house:nobody"})).exit_code, 2);
  const Outcome past =
      expect_exit(2, run(league("freeze", folder, {"--at", "2020-01-30 18:00", "--reason", "x"})),
                  "2020-01-30 18:00 UTC is past, it is ");
  EXPECT_TRUE(contains(past.err, "or none to take no entry from now on"));
  auto config = read_json(folder + "/league.json");
  config["teams"].push_back({{"name", "keeper"}, {"entry", "house:keeper"}});
  config["teams"].push_back({{"name", "own"}, {"entry", "own.so"}});
  config["freeze"] = "2126-11-30T19:00:00+01:00";
  write_file(folder + "/league.json", config.dump());
  fs::copy_file(house("idle"), folder + "/own.so");
  expect_exit(0, run(league("start", folder)));
  EXPECT_EQ(count_kind(folder, "entry"), 4);
}

// The mail of a team that was refused, or has not handed in, has to say so.
TEST(Nights, TellTeamsWhatBecameOfTheirHandIns) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:chaser", "b=house:chaser", "c=submitted", "d=submitted"}, "1",
              "nightly");
  write_file(temporary / "bad.so", "MZ");
  EXPECT_EQ(run(league("submit", folder, {"c", temporary / "bad.so"})).exit_code, 1);
  ASSERT_EQ(run(league("nightly", folder)).exit_code, 0);
  const auto digest = [&](const std::string& team) {
    return read_file(folder + "/nights/1/" + team + ".txt");
  };
  EXPECT_TRUE(contains(digest("c"), "Note:     entry 1 was not accepted: "));
  EXPECT_TRUE(contains(digest("d"), "Note:     nothing was handed in"));
  EXPECT_FALSE(contains(digest("d"), "Lost to:")) << "it played no leg";
  EXPECT_TRUE(contains(digest("d"), "Legs:     none\n"));
  EXPECT_FALSE(contains(digest("a"), "Note:"));
  EXPECT_FALSE(contains(digest("a"), "yesterday")) << "it was the first night";
}

// One team hands in after the deadline. Why is its business: neither journal nor pages have it.
TEST(Teams, MayHaveAnExtension) {
  const TemporaryFolder temporary;
  const std::string folder = temporary / "l";
  init_league(folder, {"a=house:idle", "b=house:idle", "c=house:idle"}, "1", "nightly");
  const auto take = [&](const std::string& team) {
    return run(league("submit", folder, {team, "house:chaser"})).exit_code;
  };
  const auto extend = [&](const std::string& team, const std::string& until) {
    return run(league("freeze", folder,
                      {"--except", team, "--until", until, "--reason", "is in hospital"}));
  };
  ASSERT_EQ(run(league("freeze", folder, {"--reason", "last day"})).exit_code, 0);
  EXPECT_EQ(take("a"), 1);
  EXPECT_EQ(extend("a", "2126-11-30").exit_code, 2) << "a day is no time";
  EXPECT_TRUE(contains(extend("a", "2020-11-30 18:00").err, "is past, it is "));
  EXPECT_EQ(extend("a", "2126-11-30T18:00:00Z").exit_code, 0);
  EXPECT_EQ(take("a"), 0) << "before the start league.json has the extension";
  EXPECT_EQ(take("b"), 1);

  ASSERT_EQ(run(league("nightly", folder)).exit_code, 0);
  EXPECT_EQ(take("a"), 0);
  EXPECT_EQ(extend("nobody", "2126-11-30T18:00:00Z").exit_code, 2);
  EXPECT_EQ(extend("b", "2126-11-30T18:00:00Z").exit_code, 0);
  EXPECT_EQ(take("b"), 0);
  EXPECT_EQ(take("c"), 1);
  ASSERT_EQ(run(league("publish", folder)).exit_code, 0);
  for (const auto& [name, bytes] : site_of(folder))
    EXPECT_FALSE(contains(bytes, "hospital")) << name;
  EXPECT_FALSE(contains(read_file(folder + "/journal.jsonl"), "hospital"));
  const std::string kept = read_file(folder + "/reasons.txt");
  EXPECT_TRUE(contains(kept, " on, no entry is taken: last day\n"));
  const std::string last = kept.substr(kept.rfind('\n', kept.size() - 2) + 1);
  EXPECT_TRUE(contains(last, ": b may hand in until 2126-11-30 18:00 UTC: is in hospital\n"));
  EXPECT_TRUE(
      contains(read_file(folder + "/journal.jsonl"), "\"reason_sha256\":\"" + last.substr(0, 64)));
  EXPECT_EQ(fs::status(folder + "/reasons.txt").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(run(league("undo", folder, {"1", "--reason", "a mistake"})).exit_code, 0);
  EXPECT_EQ(take("b"), 1) << "the extension was decision 1";
  ASSERT_EQ(run(league("close", folder, {"--reason", "over"})).exit_code, 0);
  EXPECT_EQ(extend("b", "2126-11-30T18:00:00Z").exit_code, 2);
  EXPECT_EQ(read_file(folder + "/reasons.txt"), kept) << "a reason of what was refused";
}

}  // namespace
}  // namespace mirocup
