// SPDX-License-Identifier: MIT
//
// Catches a writer, a remover or a reader that follows a link below a folder whose files may come
// from a stranger, at any depth and however the path is spelled, and a refusal that does not name
// the link. Catches a guard that refuses the host's own links on the way to the folder.
#include "system/links.hpp"

#include "system/child_process.hpp"
#include "system/files.hpp"
#include "tests/support/is_ok.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>

namespace mirocup::system {
namespace {

namespace fs = std::filesystem;

using test_support::is_ok;

constexpr ReadOptions any{.max_size = 100};

// Everything below a folder, with the bytes of files.
std::map<std::string, std::string> content_of(const std::string& folder) {
  std::map<std::string, std::string> content;
  for (const auto& one : fs::recursive_directory_iterator(folder)) {
    content[one.path()] =
        one.is_regular_file() ? *Disk().read(one.path(), any) : std::string("no file");
  }
  return content;
}

class LinksTest : public testing::Test {
 protected:
  LinksTest() {
    for (const std::string folder : {"outside/a/b", "root/a/b"}) {
      fs::create_directories(temporary_ / folder);
      EXPECT_TRUE(disk_.write(temporary_ / folder + "/file", "precious"));
      EXPECT_TRUE(
          disk_.write(temporary_ / folder + "/file.unfinished-" + std::string(32, '1'), "half"));
    }
    follow_no_links_below(root_);
  }

  // Puts a link to its twin outside in the place of a file or folder.
  std::string plant(const std::string& name) {
    fs::remove_all(root_ + "/" + name);
    fs::create_symlink(temporary_ / ("outside/" + name), root_ + "/" + name);
    return root_ + "/" + name;
  }

  using Acts = std::map<std::string, std::function<Result<void>()>>;

  // Each function that reaches the file a/b/file.
  Acts acts_on_file() {
    const std::string file = root_ + "/a/b/file";
    return {
        {"read", [=, this] { return disk_.read(file, any).map([](auto) {}); }},
        {"read if there", [=, this] { return disk_.read_if_there(file, any).map([](auto) {}); }},
        {"write", [=, this] { return disk_.write(file, "new"); }},
        {"append", [=, this] { return disk_.append(file, "more"); }},
        {"truncate", [=, this] { return disk_.truncate(file, 1); }},
        {"remove", [=, this] { return disk_.remove(file); }},
        {"incoming",
         [=] {
           return IncomingFile::begin(file).and_then(
               [=](IncomingFile incoming) { return incoming.keep(file); });
         }},
        {"output of a child",
         [=] { return run_child({.arguments = {"echo"}, .log = file}).map([](auto) {}); }}};
  }

  // Each function that reaches the folder a/b.
  Acts acts_on_folder() {
    const std::string folder = root_ + "/a/b";
    return {{"names", [=, this] { return disk_.names_in(folder).map([](auto) {}); }},
            {"names if there", [=, this] { return disk_.names_if_there(folder).map([](auto) {}); }},
            {"make", [=, this] { return disk_.make_folder(folder); }},
            {"make closed", [=, this] { return disk_.make_folder(folder, Readers::owner); }},
            {"make below", [=, this] { return disk_.make_folder(folder + "/c/d"); }},
            {"remove", [=, this] { return disk_.remove(folder); }},
            {"unfinished", [=, this] { return disk_.remove_unfinished(folder); }}};
  }

  const test_support::TemporaryFolder temporary_;
  const std::string root_ = temporary_ / "root";
  Disk disk_;
};

void expect_refused(const Result<void>& done, const std::string& link, const std::string& act) {
  ASSERT_FALSE(done) << act << " " << link;
  EXPECT_TRUE(done.error().what.starts_with(link + ": it is a symbolic link")) << done.error().what;
  EXPECT_TRUE(done.error().code == Errc::input || done.error().code == Errc::damaged) << act;
}

TEST_F(LinksTest, AreFollowedAtNoLevel) {
  for (const std::string name : {"a", "a/b", "a/b/file"}) {
    const std::string link = plant(name);
    const auto before = content_of(temporary_ / "outside");
    for (const auto& [what, act] : acts_on_file()) expect_refused(act(), link, what);
    for (const auto& [what, act] : acts_on_folder()) {
      if (name != "a/b/file") expect_refused(act(), link, what);
    }
    EXPECT_TRUE(disk_.exists(root_ + "/a/b/file")) << "it is not known to be absent";
    EXPECT_EQ(content_of(temporary_ / "outside"), before) << name;
    fs::remove(link);
    fs::create_directories(root_ + "/a/b");
  }
}

// A folder is removed with its files, but neither with a folder in it nor through a link in it.
TEST_F(LinksTest, KeepTheirFolder) {
  plant("a/b/file");
  EXPECT_FALSE(disk_.remove(root_ + "/a/b"));
  EXPECT_EQ(*disk_.read(temporary_ / "outside/a/b/file", any), "precious");
  fs::remove(root_ + "/a/b/file");
  EXPECT_FALSE(disk_.remove(root_ + "/a")) << "a tree";
  EXPECT_TRUE(is_ok(disk_.remove(root_ + "/a/b")));
  EXPECT_FALSE(fs::exists(root_ + "/a/b"));
}

TEST_F(LinksTest, AreKnownByAnySpellingOfThePath) {
  plant("a");
  const std::string relative = fs::path(root_).lexically_relative(fs::current_path());
  follow_no_links_below(relative + "//");
  for (const std::string& path : {root_ + "//a//b/file", root_ + "/./a/b/file",
                                  relative + "/a/b/file", root_ + "/a/b/../b/file"})
    EXPECT_FALSE(disk_.write(path, "new")) << path;
  EXPECT_FALSE(disk_.write(root_ + "/../outside/a/b/file", "new")) << "it leads out of the folder";
  EXPECT_EQ(*disk_.read(temporary_ / "outside/a/b/file", any), "precious");
}

TEST_F(LinksTest, MayLeadToTheFolder) {
  fs::create_directory_symlink(root_, temporary_ / "way");
  follow_no_links_below(temporary_ / "way");
  EXPECT_TRUE(is_ok(disk_.write(temporary_ / "way/a/b/file", "new")));
  EXPECT_EQ(*disk_.read(root_ + "/a/b/file", any), "new");
  EXPECT_TRUE(is_ok(disk_.make_folder(temporary_ / "way/a/c/d")));
  EXPECT_EQ(disk_.names_in(root_ + "/a/c"), (std::vector<std::string>{"d"}));
  // The host names a file, and may name a link; a league.json names a library beside its league.
  const std::string link = plant("a/b/file");
  EXPECT_EQ(*disk_.read_named(link, 100), "precious");
  EXPECT_EQ(*disk_.read(root_ + "/../outside/a/b/file", any), "precious");
}

TEST_F(LinksTest, BesideFilesThatAreNotThereNameNothing) {
  for (const std::string name : {"none", "none/none", "a/none"}) {
    const std::string path = root_ + "/" + name;
    EXPECT_FALSE(disk_.exists(path)) << name;
    EXPECT_EQ(disk_.read_if_there(path, any), std::nullopt) << name;
    EXPECT_EQ(disk_.names_if_there(path), std::vector<std::string>{}) << name;
    EXPECT_TRUE(is_ok(disk_.remove(path))) << name;
    EXPECT_EQ(disk_.read(path, any).error().what,
              path + " cannot be read: No such file or directory");
  }
}

}  // namespace
}  // namespace mirocup::system
