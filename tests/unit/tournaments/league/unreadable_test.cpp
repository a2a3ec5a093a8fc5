// SPDX-License-Identifier: MIT
//
// Catches a reader of a league's folder that takes a file which cannot be read for one that is not
// there, and decides by that: a verdict, a pin, tokens, books, lists of versions.
#include "tests/support/unreadable.hpp"

#include "record/kept_module.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/tournaments/kept_entry.hpp"
#include "tournaments/handin/entry_report.hpp"
#include "tournaments/handin/tokens.hpp"
#include "tournaments/journal/journal.hpp"
#include "tournaments/league/people.hpp"
#include "tournaments/league/roster.hpp"
#include "tournaments/league/submission.hpp"
#include "tournaments/publish/site.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <optional>

namespace mirocup::league {
namespace {

using test_support::Unreadable;

// What a reader says of the folder; nothing if it reads it.
using Look = std::function<std::optional<Error>()>;

template <class T>
std::optional<Error> error_of(const Result<T>& result) {
  return result ? std::nullopt : std::optional(result.error());
}

class FileOfALeague : public testing::Test {
 protected:
  FileOfALeague() {
    EXPECT_TRUE(disk_.make_folder(folder_.path));
    for (int number = 1; number <= 2; ++number) keep_entry(disk_, folder_, "a", "library");
    EXPECT_TRUE(disk_.write(folder_.verdict("a", 1), R"({"accepted": true})"));
  }

  // The reader must be content with the whole folder, and with no folder if the file may be
  // missing. It must name the file once that cannot be read.
  void expect_told(const std::string& path, const Look& look) {
    EXPECT_FALSE(look()) << path;
    for (const Unreadable way : test_support::ways_to_be_unreadable) {
      test_support::make_unreadable(path, way);
      const auto told = look();
      ASSERT_TRUE(told) << path << " " << static_cast<int>(way);
      EXPECT_NE(told->what.find(path), std::string::npos) << told->what;
      EXPECT_GE(exit_code(told->code), 3) << told->what;
    }
    std::filesystem::remove_all(path);
    EXPECT_FALSE(look()) << path << " is not there";
  }

  // A folder is read as what it is, so only links can stand in its place.
  void expect_told_of_folder(const std::string& path, const Look& look) {
    EXPECT_FALSE(look()) << path;
    for (const Unreadable way : {Unreadable::is_loop_of_links, Unreadable::leads_to_nothing}) {
      test_support::make_unreadable(path, way);
      const auto told = look();
      ASSERT_TRUE(told) << path << " " << static_cast<int>(way);
      EXPECT_EQ(told->code, Errc::input) << told->what;
      EXPECT_TRUE(told->what.starts_with(path + ": it is a symbolic link")) << told->what;
    }
    std::filesystem::remove_all(path);
    EXPECT_FALSE(look()) << path << " is not there";
  }

  const test_support::TemporaryFolder temporary_;
  system::Disk disk_;
  const Folder folder_{temporary_ / "league"};
};

TEST_F(FileOfALeague, VerdictIsNoRefusalIfItCannotBeRead) {
  const HandedIn handed = *Book::open(disk_, folder_)->hand_ins().find("a", 1);
  expect_told(folder_.verdict("a", 1),
              [&] { return error_of(entry_report(disk_, folder_, handed, 0, {}, true)); });
}

TEST_F(FileOfALeague, FoldersAreNotEmptyIfTheyCannotBeRead) {
  const std::string entries = folder_.entries();
  EXPECT_TRUE(disk_.write(folder_.config(), print_league_file({})));
  auto store = LeagueStore::open(disk_, folder_);
  ASSERT_TRUE(store) << store.error().what;
  const auto book = Book::open(disk_, folder_);
  expect_told_of_folder(
      entries + "/a", [&] { return error_of(follow_book(disk_, *store, book->hand_ins(), "a")); });
  expect_told_of_folder(entries, [&] { return error_of(everybody(disk_, *store)); });
  const std::string site = folder_.site();
  expect_told_of_folder(site + "/replays",
                        [&] { return error_of(remove_former_pages(disk_, site, "replays/", {})); });
}

TEST_F(FileOfALeague, BooksAreNotBegunAnewIfTheyCannotBeRead) {
  expect_told(folder_.journal(),
              [&] { return error_of(Journal::open(disk_, folder_.journal(), nullptr)); });
  std::string notice;
  expect_told(folder_.hand_in_book(),
              [&] { return error_of(Book::open(disk_, folder_, &notice)); });
}

TEST_F(FileOfALeague, ListsOfPeopleAndTokensAreNotEmptyIfTheyCannotBeRead) {
  expect_told(tokens_path(folder_), [&] { return error_of(read_tokens(disk_, folder_)); });
  expect_told(folder_.people(), [&] { return error_of(read_people(disk_, folder_)); });
}

TEST_F(FileOfALeague, ModuleIsTrustedOrIsAnError) {
  expect_told(folder_.path + "/programs/5f/mirocup.wasm",
              [&] { return error_of(record::trust_modules(disk_, folder_.path)); });
}

}  // namespace
}  // namespace mirocup::league
