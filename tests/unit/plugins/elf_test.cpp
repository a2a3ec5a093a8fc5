// SPDX-License-Identifier: MIT
#include "plugins/host/elf.hpp"

#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace mirocup::plugins {
namespace {

std::string library() {
  std::ifstream in(MIROCUP_LIBRARY, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

TEST(Elf, ShowsWhatALibraryExportsAndNeeds) {
  const auto found = read_shared_library(library());
  ASSERT_TRUE(found) << found.error();
  EXPECT_TRUE(found->exports_entry);
  EXPECT_EQ(std::count(found->needed.begin(), found->needed.end(), "libm.so.6"), 1);
  EXPECT_EQ(found->search_path, "");
}

TEST(Elf, RefusesALibraryThatIsCutOffAnywhere) {
  const std::string whole = library();
  for (std::size_t size = 0; size < whole.size(); size += size < 4096 ? 1 : 97) {
    EXPECT_FALSE(read_shared_library(std::string_view(whole).substr(0, size))) << size;
  }
}

// Catches a reader that follows an offset without checking it (under the sanitizers it crashes),
// that refuses without a reason, or that returns names which are not in the file.
TEST(Elf, RefusesOrReadsEveryDamagedLibrary) {
  const std::string whole = library();
  Random random(7);
  int refused = 0;
  constexpr int tries = 3000;
  for (int i = 0; i < tries; ++i) {
    std::string bytes = whole;
    for (int k = 0; k < 8; ++k) {
      // Most of the damage is near the beginning, where the tables are.
      const double where = random.uniform();
      const auto at = static_cast<std::size_t>(where * where * where * double(bytes.size() - 1));
      bytes[at] = static_cast<char>(random.uniform() < 0.5 ? 0xff : random.below(256));
    }
    const auto read = read_shared_library(bytes);
    if (!read) {
      ++refused;
      EXPECT_FALSE(read.error().empty()) << i;
      continue;
    }
    for (const std::string& name : read->needed) {
      EXPECT_NE(bytes.find(name + '\0'), std::string::npos) << i;
    }
    EXPECT_NE(bytes.find(read->search_path), std::string::npos) << i;
    if (read->exports_entry) {
      EXPECT_NE(bytes.find("mirocup_entry"), std::string::npos) << i;
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, tries);
}

}  // namespace
}  // namespace mirocup::plugins
