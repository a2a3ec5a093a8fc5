// SPDX-License-Identifier: MIT
//
// Catches a library for newer processors that looks like an old one, an old one that looks newer
// because of its constants, and a file whose tables make the reader read for ever.
#include "plugins/host/elf.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <elf.h>
#include <fstream>
#include <sstream>

namespace mirocup::plugins {
namespace {

using namespace std::string_literals;
using system::Processor;

// A library for x86-64 with this code, which many of its sections claim.
std::string with_code(const std::string& code, Elf64_Half sections = 1) {
  Elf64_Ehdr header{};
  std::memcpy(header.e_ident, ELFMAG, SELFMAG);
  header.e_machine = EM_X86_64;
  header.e_shoff = sizeof header;
  header.e_shnum = sections;
  Elf64_Shdr section{};
  section.sh_type = SHT_PROGBITS;
  section.sh_flags = SHF_EXECINSTR;
  section.sh_offset = sizeof header + sections * sizeof section;
  section.sh_size = code.size();
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
  for (int i = 0; i < sections; ++i)
    bytes.append(reinterpret_cast<const char*>(&section), sizeof section);
  return bytes + code;
}

Processor needs(const std::string& code) {
  return processor_for(with_code(code + code));
}

TEST(Instructions, TellTheProcessor) {
  EXPECT_EQ(needs("\x66\x0f\x58\xc1"), Processor::v1) << "addpd";
  EXPECT_EQ(needs("\x66\x0f\x38\x40\xc1"), Processor::v2) << "pmulld";
  EXPECT_EQ(needs("\x66\x0f\x3a\x0b\xc1\x09"), Processor::v2) << "roundsd";
  EXPECT_EQ(needs("\xc5\xf5\x58\xc2"), Processor::v3) << "vaddpd %ymm2, %ymm1, %ymm0";
  EXPECT_EQ(needs("\xc4\xe2\xf5\xb8\xc2"), Processor::v3) << "vfmadd231pd %ymm2, %ymm1, %ymm0";
  EXPECT_EQ(needs("\x62\xf1\xf5\x48\x58\xc2"), Processor::v4) << "vaddpd %zmm2, %zmm1, %zmm0";
  EXPECT_EQ(needs("\x62\xa1\x7c\x28\x28\xc1"), Processor::v4) << "vmovaps %ymm17, %ymm16";
  EXPECT_EQ(processor_for(with_code("\x62\xf1\xf5\x48\x58\xc2")), Processor::v1) << "once";
  EXPECT_EQ(processor_for("no library"), Processor::v1);
}

// An instruction that holds the bytes of vaddpd %zmm2, %zmm1, %zmm0 in its parts.
TEST(Instructions, AreNotFoundInsideOfOthers) {
  const std::string zmm = "\x62\xf1\xf5\x48\x58\xc2";
  for (const std::string& begin :
       {"\x48\xb8"s, "\xb8\x31\xc4"s, "\x48\x8d\x84\xc4"s, "\x48\x81\x05"s, "\xe8"s, "\x0f\x84"s,
        "\x66\xc7\x84\x24\xc5\xc5"s, "\xf7\x05"s, "\xf6\x80\xc4"s}) {
    const std::string nops(16, '\x90');
    EXPECT_EQ(needs(begin + zmm + nops), Processor::v1) << begin.size();
  }
}

TEST(Instructions, AreReadOnceWhateverTheTablesClaim) {
  const std::string code(std::size_t{2} << 20, '\x90');
  EXPECT_EQ(processor_for(with_code(code, 60'000)), Processor::v1);
  const std::string zmm = "\x62\xf1\xf5\x48\x58\xc2";
  const std::string whole = with_code(zmm + zmm);
  EXPECT_EQ(processor_for(whole), Processor::v4);
  for (std::size_t size = 0; size <= whole.size() - zmm.size(); ++size)
    EXPECT_EQ(processor_for(std::string_view(whole).substr(0, size)), Processor::v1) << size;
}

TEST(Instructions, OfAHouseTeamAreForEachProcessor) {
  std::ifstream in(MIROCUP_LIBRARY, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  ASSERT_GT(bytes.str().size(), 10'000u);
  EXPECT_EQ(processor_for(bytes.str()), Processor::v1);
}

}  // namespace
}  // namespace mirocup::plugins
