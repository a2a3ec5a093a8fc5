// SPDX-License-Identifier: MIT
#include "plugins/host/function_names.hpp"

#include "plugins/host/sealed_entry.hpp"

#include <gtest/gtest.h>

#include <dlfcn.h>
#include <elf.h>
#include <string>

namespace mirocup::plugins {
namespace {

TEST(FunctionNames, AreReadable) {
  EXPECT_EQ(readable_name("decide"), "decide");
  EXPECT_EQ(readable_name("_ZN4Mine6decideERK19mirocup_observation"), "Mine::decide");
  EXPECT_EQ(readable_name("_ZNK12_GLOBAL__N_17Crashes8look_forEPVi"), "Crashes::look_for");
  EXPECT_EQ(readable_name("_ZL3digPVi"), "dig");
  EXPECT_EQ(readable_name("_Z3digi"), "dig");
  EXPECT_EQ(readable_name("_ZZ13mirocup_entryENUlPvE_4_FUNES_"), "a function within mirocup_entry");
  // Catches an index that runs over the end.
  for (const std::string odd :
       {"_Z", "_ZN", "_ZN9", "_ZN9999Mine", "_ZN4MineIiE1fEv", "_ZN4Mine", "_ZNE"}) {
    EXPECT_EQ(readable_name(odd), odd);
  }
}

TEST(FunctionNames, AreThoseOfTheLibrary) {
  const auto entry = SealedEntry::open(MIROCUP_LIBRARY);
  ASSERT_TRUE(entry);
  void* library = dlopen(MIROCUP_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(library, nullptr);
  const void* function = dlsym(library, "mirocup_entry");
  Dl_info where{};
  ASSERT_NE(dladdr(function, &where), 0);
  const auto address = static_cast<std::uint64_t>(static_cast<const char*>(function) -
                                                  static_cast<const char*>(where.dli_fbase));
  EXPECT_EQ(function_at(entry->bytes(), address), "mirocup_entry");
  EXPECT_EQ(function_at(entry->bytes(), address + 1), "mirocup_entry");
  EXPECT_EQ(function_at(entry->bytes(), std::uint64_t{1} << 40), "");
  dlclose(library);
}

// Catches a table that leads beyond the end of the file, at each place where a file may be cut.
TEST(FunctionNames, OfACutOrChangedFileAreNotReadBeyondItsEnd) {
  const auto entry = SealedEntry::open(MIROCUP_LIBRARY);
  ASSERT_TRUE(entry);
  const std::string whole(entry->bytes());
  for (std::size_t size = 0; size < whole.size(); size += 97) {
    function_at(std::string(whole, 0, size), 0x1200);
  }
  for (std::size_t at = 0; at < sizeof(Elf64_Ehdr); ++at) {
    std::string changed = whole;
    changed[at] = static_cast<char>(0xff);
    function_at(changed, 0x1200);
  }
}

}  // namespace
}  // namespace mirocup::plugins
