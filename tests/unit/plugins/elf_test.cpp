// SPDX-License-Identifier: MIT
#include "plugins/host/elf.hpp"

#include "core/base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <elf.h>
#include <fstream>
#include <sstream>
#include <vector>

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

// A library of one segment: a dynamic section of these entries and a zero entry, then `tail`, whose
// address is tail_address(entries).
std::uint64_t tail_address(std::size_t entries) {
  return sizeof(Elf64_Ehdr) + 2 * sizeof(Elf64_Phdr) + (entries + 1) * sizeof(Elf64_Dyn);
}
std::string made_up(const std::vector<Elf64_Dyn>& entries, const std::string& tail) {
  Elf64_Ehdr header{};
  const std::string real = library();
  std::memcpy(&header, real.data(), sizeof header);
  header.e_phoff = sizeof header;
  header.e_phnum = 2;
  header.e_shnum = 0;
  Elf64_Phdr segments[2]{};
  segments[0].p_type = PT_LOAD;
  segments[0].p_filesz = tail_address(entries.size()) + tail.size();
  segments[1].p_type = PT_DYNAMIC;
  segments[1].p_vaddr = segments[1].p_offset = sizeof header + sizeof segments;
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
  bytes.append(reinterpret_cast<const char*>(segments), sizeof segments);
  for (const Elf64_Dyn& entry : entries)
    bytes.append(reinterpret_cast<const char*>(&entry), sizeof entry);
  return bytes.append(sizeof(Elf64_Dyn), '\0') + tail;
}

// Entries that name `count` libraries, all at the beginning of the tail.
std::vector<Elf64_Dyn> needing(std::size_t count) {
  const std::uint64_t tail = tail_address(count + 2);
  std::vector<Elf64_Dyn> entries{{DT_STRTAB, {tail}}, {DT_SYMTAB, {tail}}};
  entries.resize(count + 2, {DT_NEEDED, {0}});
  return entries;
}

// Catches names without end and without number, each of which was copied: 128 GiB from 32 MiB.
TEST(Elf, BoundsTheNamesOfLibraries) {
  const auto name = [](std::size_t size) { return std::string(size, 'x') + '\0'; };
  const auto longest = read_shared_library(made_up(needing(256), name(255)));
  ASSERT_TRUE(longest) << longest.error();
  EXPECT_EQ(longest->needed.size(), 256u);
  EXPECT_EQ(longest->needed[0].size(), 255u);
  EXPECT_FALSE(read_shared_library(made_up(needing(1), name(256))));
  EXPECT_FALSE(read_shared_library(made_up(needing(257), name(1))));
  EXPECT_FALSE(read_shared_library(made_up(needing(4080), name(1u << 20))));
}

// Catches a search for the end of each symbol's name. It took hours for this one, and the test
// would run into its time limit.
TEST(Elf, ComparesTheNamesOfSymbolsAtTheirPlace) {
  constexpr std::uint32_t symbols = 1u << 20;
  const std::uint64_t tail = tail_address(3);
  std::string table(8 + sizeof(Elf64_Sym) * symbols, '\0');
  const std::uint32_t count[2]{1, symbols};
  std::memcpy(table.data(), count, sizeof count);
  Elf64_Sym symbol{};
  symbol.st_info = ELF64_ST_INFO(STB_GLOBAL, STT_FUNC);
  symbol.st_shndx = 1;
  symbol.st_name = 1;
  for (std::size_t i = 0; i < symbols; ++i)
    std::memcpy(table.data() + 8 + i * sizeof symbol, &symbol, sizeof symbol);
  const std::uint64_t strings = tail + table.size();
  const std::vector<Elf64_Dyn> entries{
      {DT_STRTAB, {strings}}, {DT_SYMTAB, {tail + 8}}, {DT_HASH, {tail}}};
  const auto read = [&](const std::string& names) {
    return read_shared_library(made_up(entries, table + names));
  };
  EXPECT_FALSE(read(std::string(6u << 20, 'm') + '\0')->exports_entry);
  EXPECT_TRUE(read(std::string("\0mirocup_entry\0", 15))->exports_entry);
  EXPECT_FALSE(read(std::string("\0mirocup_entry2\0", 16))->exports_entry);
  EXPECT_FALSE(read(std::string("\0mirocup_entry", 14))->exports_entry) << "no zero follows";
}

}  // namespace
}  // namespace mirocup::plugins
