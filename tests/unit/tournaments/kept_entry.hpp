// SPDX-License-Identifier: MIT
//
// An entry in the folder of a league, as if the host had handed it in by `league submit`.
#pragma once

#include "system/digest.hpp"
#include "tests/support/is_ok.hpp"
#include "tournaments/league/book.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {

inline void keep_entry(system::Files& disk, const Folder& folder, const std::string& team,
                       const std::string& library, HandInState state = HandInState::accepted) {
  auto book = Book::open(disk, folder);
  ASSERT_TRUE(test_support::is_ok(book));
  const auto entry = book->take({.team = team, .file = "team.so", .sha256 = "s"},
                                [&](const auto& path) { return disk.write(path, library); });
  ASSERT_TRUE(test_support::is_ok(entry));
  const auto answered = book->write(
      Answered{.team = team, .entry = *entry, .state = state, .library = system::sha256(library)});
  ASSERT_TRUE(test_support::is_ok(answered));
}

}  // namespace mirocup::league
