// SPDX-License-Identifier: MIT
//
// Catches a record of another name.
#include "tournaments/league/folder.hpp"

#include <gtest/gtest.h>

namespace mirocup::league {
namespace {

TEST(Folder, NamesRecordsByFixtureLegAndVersion) {
  Fixture fixture;
  fixture.round = 2;
  EXPECT_EQ(Folder::record_name(fixture, 1, 3), "records/r2-f1-1-3.json");
}

}  // namespace
}  // namespace mirocup::league
