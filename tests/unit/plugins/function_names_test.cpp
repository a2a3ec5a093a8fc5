// SPDX-License-Identifier: MIT
#include "plugins/host/function_names.hpp"

#include "plugins/host/sealed_entry.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <dlfcn.h>
#include <elf.h>
#include <string>
#include <string_view>
#include <vector>

namespace mirocup::plugins {
namespace {

std::string function_at(std::string_view library, std::uint64_t address) {
  return functions_at(library, {&address, 1}).names.at(0);
}

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

// A file of one table of symbols, `symbols` functions of one byte each, that `tables` sections
// claim for themselves: every second one for what is exported.
std::string library_of(std::size_t symbols, std::size_t tables) {
  const std::string texts("\0first\0other\0", 13);
  std::string file(sizeof(Elf64_Ehdr), '\0');
  const auto add = [&file](const auto& item) {
    file.append(reinterpret_cast<const char*>(&item), sizeof item);
  };
  for (std::size_t i = 0; i < symbols; ++i) {
    add(Elf64_Sym{.st_name = i == 0 ? 1u : 7u,
                  .st_info = ELF64_ST_INFO(STB_GLOBAL, STT_FUNC),
                  .st_other = 0,
                  .st_shndx = 1,
                  .st_value = 0x1000 + i,
                  .st_size = 1});
  }
  const std::size_t texts_at = file.size();
  file += texts;
  Elf64_Ehdr header{};
  std::memcpy(header.e_ident, ELFMAG, SELFMAG);
  header.e_shentsize = sizeof(Elf64_Shdr);
  header.e_shnum = static_cast<Elf64_Half>(tables + 1);
  header.e_shoff = file.size();
  Elf64_Shdr section{};
  section.sh_type = SHT_STRTAB;
  section.sh_offset = texts_at;
  section.sh_size = texts.size();
  add(section);
  for (std::size_t i = 0; i < tables; ++i) {
    section.sh_type = i % 2 == 0 ? SHT_SYMTAB : SHT_DYNSYM;
    section.sh_offset = sizeof header;
    section.sh_size = symbols * sizeof(Elf64_Sym);
    section.sh_link = 0;
    add(section);
  }
  std::memcpy(file.data(), &header, sizeof header);
  return file;
}

// Catches a reader that bounds each table, and not the number of tables or of addresses: a thousand
// sections on one table of a million symbols took trusted code 100 s for each crash.
TEST(FunctionNames, AreReadOnceForAllAddressesWhateverTheSectionsClaim) {
  constexpr std::size_t count = 1000;
  const std::string file = library_of(count, 1023);
  std::vector<std::uint64_t> addresses(24, 1);  // which no function has
  addresses[7] = 0x1000;
  addresses[23] = 0x1000 + count - 1;
  const FunctionNames found = functions_at(file, addresses);
  EXPECT_EQ(found.symbols_read, 2 * count);
  EXPECT_EQ(found.names.at(7), "first");
  EXPECT_EQ(found.names.at(23), "other");
  EXPECT_EQ(found.names.at(0), "");
  EXPECT_EQ(functions_at(file, {}).names.size(), 0u);
}

TEST(FunctionNames, AreLookedForInTwoMillionSymbolsAtMost) {
  const std::string file = library_of(std::size_t{3} << 19, 2);
  const std::uint64_t last = 0x1000 + (std::size_t{3} << 19) - 1;
  const FunctionNames found = functions_at(file, {&last, 1});
  EXPECT_EQ(found.symbols_read, std::size_t{1} << 21);
  EXPECT_EQ(found.names.at(0), "other");
}

}  // namespace
}  // namespace mirocup::plugins
