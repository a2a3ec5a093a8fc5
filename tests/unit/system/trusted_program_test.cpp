// SPDX-License-Identifier: MIT
//
// Catches a program that is run although another user could have put it there: by a link, by a
// folder anywhere on the way, or in a folder that all users share.
#include "system/trusted_program.hpp"

#include "tests/support/is_ok.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mirocup::system {
namespace {

namespace fs = std::filesystem;

constexpr uid_t stranger = 64777;

class TrustedProgram : public testing::Test {
 protected:
  TrustedProgram() {
    fs::create_directories(at("v/bin"));
    write("v/bin/mirocup");
  }

  std::string at(const std::string& name) const { return folder_ / name; }

  void write(const std::string& name) const {
    std::ofstream(at(name)) << "#!/bin/sh\n";
    EXPECT_EQ(chmod(at(name).c_str(), 0755), 0);
  }
  void link(const std::string& target, const std::string& name) const {
    fs::create_symlink(target, at(name));
  }
  void give_away(const std::string& name) const {
    EXPECT_EQ(lchown(at(name).c_str(), stranger, stranger), 0);
  }
  void set_mode(const std::string& name, mode_t mode) const {
    EXPECT_EQ(chmod(at(name).c_str(), mode), 0);
  }

  // The reason, "" if the program is trusted.
  std::string refusal(const std::string& name) const {
    const auto real = trusted_program(at(name), "mirocup");
    return real ? "" : real.error().what;
  }
  void expect_refusal(const std::string& name, const std::string& reason) const {
    EXPECT_NE(refusal(name).find(reason), std::string::npos) << name << ": " << refusal(name);
  }

  const test_support::TemporaryFolder folder_;
};

TEST_F(TrustedProgram, IsThatOfThisUserByItsRealPath) {
  link("v", "newest");
  link("../newest/./bin/../bin/mirocup", "v/mirocup");
  const auto real = trusted_program(at("v/mirocup"), "mirocup");
  ASSERT_TRUE(test_support::is_ok(real));
  EXPECT_EQ(*real, fs::canonical(at("v/bin/mirocup")));
}

TEST_F(TrustedProgram, IsInNoFolderThatOthersMayWriteTo) {
  const std::string others = "may be written by others than its owner";
  for (const char* name : {"v/bin/mirocup", "v/bin", "v", "."}) {
    const mode_t before = fs::is_directory(at(name)) ? 0700 : 0755;
    for (const mode_t bit : {S_IWGRP, S_IWOTH}) {
      set_mode(name, before | bit);
      expect_refusal("v/bin/mirocup", others);
    }
    set_mode(name, before);
  }
  EXPECT_EQ(refusal("v/bin/mirocup"), "");
}

TEST_F(TrustedProgram, HasItsNameAndIsAProgram) {
  link("/usr/bin/true", "mirocup");
  expect_refusal("mirocup", "is not called mirocup");
  set_mode("v/bin/mirocup", 0644);
  expect_refusal("v/bin/mirocup", "is not a program that this user may run");
  expect_refusal("nothing/mirocup", "cannot be read");
  fs::create_directories(at("w/mirocup"));
  expect_refusal("w/mirocup", "is not a program");
  link("circle", "circle");
  expect_refusal("circle", "too many links");
}

TEST_F(TrustedProgram, InASharedFolderIsThisUsersAndHasOneName) {
  if (geteuid() != 0) GTEST_SKIP() << "only root makes a shared folder of root's";
  fs::create_directory(at("shared"));
  set_mode("shared", 01777);
  write("shared/mirocup");
  EXPECT_EQ(refusal("shared/mirocup"), "") << "this user's own file";
  fs::create_hard_link(at("shared/mirocup"), at("other"));
  expect_refusal("shared/mirocup", "has a second name");
  fs::create_directories(at("shared/mine"));
  write("shared/mine/mirocup");
  EXPECT_EQ(refusal("shared/mine/mirocup"), "");
  EXPECT_EQ(refusal("shared/../shared/mine/mirocup"), "");
  if (mount("none", at("shared/mine").c_str(), "tmpfs", 0, "mode=755") != 0)
    GTEST_SKIP() << "this user may not mount";
  write("shared/mine/mirocup");
  expect_refusal("shared/mine/mirocup", "is mounted");
  EXPECT_EQ(umount(at("shared/mine").c_str()), 0);
}

TEST_F(TrustedProgram, IsReachedByNothingOfAnotherUser) {
  if (geteuid() != 0) GTEST_SKIP() << "only root gives files away";
  const std::string theirs = "belongs to user 64777";
  link("v", "a");
  link("a", "b");
  link("b/bin/mirocup", "mirocup");
  EXPECT_EQ(refusal("mirocup"), "");
  for (const char* name : {"mirocup", "b", "a", "v", "v/bin", "v/bin/mirocup"}) {
    give_away(name);
    expect_refusal("mirocup", theirs);
    EXPECT_EQ(lchown(at(name).c_str(), 0, 0), 0);
  }
  EXPECT_EQ(refusal("mirocup"), "");
  fs::create_directory(at("shared"));
  set_mode("shared", 01777);
  link(at("v/bin/mirocup"), "shared/mirocup");
  EXPECT_EQ(refusal("shared/mirocup"), "");
  give_away("shared/mirocup");
  expect_refusal("shared/mirocup", theirs);
  give_away("shared");
  EXPECT_EQ(lchown(at("shared/mirocup").c_str(), 0, 0), 0);
  expect_refusal("shared/mirocup", theirs);
}

}  // namespace
}  // namespace mirocup::system
