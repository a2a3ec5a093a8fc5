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

TEST(Elf, ThatIsCutOffAnywhereIsRefused) {
  const std::string whole = library();
  for (std::size_t size = 0; size < whole.size(); size += size < 4096 ? 1 : 97) {
    EXPECT_FALSE(read_shared_library(std::string_view(whole).substr(0, size))) << size;
  }
}

// Under the sanitizers this finds a reader that follows an offset without looking.
TEST(Elf, OfAnyBytesIsReadOrRefused) {
  const std::string whole = library();
  Random random(7);
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = whole;
    for (int k = 0; k < 8; ++k) {
      // Most where the tables are.
      const double where = random.uniform();
      const auto at = static_cast<std::size_t>(where * where * where * double(bytes.size() - 1));
      bytes[at] = static_cast<char>(random.uniform() < 0.5 ? 0xff : random.below(256));
    }
    (void)read_shared_library(bytes);
  }
}

}  // namespace
}  // namespace mirocup::plugins
