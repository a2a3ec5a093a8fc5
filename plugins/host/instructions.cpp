// SPDX-License-Identifier: MIT
#include "plugins/host/elf.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <elf.h>
#include <optional>

namespace mirocup::plugins {

namespace {

using system::Processor;

// The bytes behind each opcode in 64-bit mode, a letter for each opcode, 32 opcodes a line: . none,
// m the byte ModRM, b one byte, M both, z 4 bytes (2 behind the prefix 66), Z ModRM and these. g
// and G are like M and Z if the instruction is TEST, and otherwise like m. i has 4 bytes, h 2, q 8,
// and w 8 or as many as z. p and r are prefixes.
constexpr std::string_view one_byte_opcodes =
    "mmmmbz..mmmmbz..mmmmbz..mmmmbz.."
    "mmmmbzp.mmmmbzp.mmmmbzp.mmmmbzp."
    "rrrrrrrrrrrrrrrr................"
    "...mppppzZbM....bbbbbbbbbbbbbbbb"
    "MZ.Mmmmmmmmmmmmm................"
    "qqqq....bz......bbbbbbbbwwwwwwww"
    "MMh...MZh.h..b..mmmm....mmmmmmmm"
    "bbbbbbbbii.b....p.pp..gG......mm";
constexpr std::string_view two_byte_opcodes =  // behind 0f
    "mmmm.........m.Mmmmmmmmmmmmmmmmm"
    "mmmm....mmmmmmmm................"
    "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm"
    "mmmmmmmmmmmmmmmmMMMMmmm.mmmmmmmm"
    "iiiiiiiiiiiiiiiimmmmmmmmmmmmmmmm"
    "...mMm.....mMmmmmmmmmmmmmmMmmmmm"
    "mmMmMMMm........mmmmmmmmmmmmmmmm"
    "mmmmmmmmmmmmmmmmmmmmmmmmmmmmmmmm";
static_assert(one_byte_opcodes.size() == 256 && two_byte_opcodes.size() == 256);

struct Instruction {
  std::size_t size;  // bytes, also if the code ends before
  Processor needs;
};

Instruction read_instruction(std::string_view code) {
  const auto byte = [code](std::size_t i) {
    return i < code.size() ? static_cast<unsigned char>(code[i]) : 0U;
  };
  constexpr std::size_t max_prefixes = 14;
  std::size_t at = 0;
  bool is_short = false;
  while (one_byte_opcodes[byte(at)] == 'p' && at < max_prefixes) is_short |= byte(at++) == 0x66;
  const bool has_rex = one_byte_opcodes[byte(at)] == 'r';
  const bool is_wide = has_rex && (byte(at) & 8) != 0;
  if (has_rex) ++at;
  Processor needs = Processor::v1;
  unsigned map = 0;  // 1: behind 0f; 2: behind 0f 38; 3: behind 0f 3a
  if (byte(at) == 0xc5 || byte(at) == 0xc4) {
    needs = Processor::v3;
    map = byte(at) == 0xc5 ? 1 : byte(at + 1) & 31;
    at += byte(at) == 0xc5 ? 2 : 3;
  } else if (byte(at) == 0x62) {
    const bool is_whole = (byte(at + 1) & 8) == 0 && (byte(at + 2) & 4) != 0;
    needs = is_whole ? Processor::v4 : Processor::v1;
    map = byte(at + 1) & 7;
    at += 4;
  } else if (byte(at) == 0x0f) {
    map = byte(at + 1) == 0x38 ? 2 : byte(at + 1) == 0x3a ? 3 : 1;
    needs = map == 1 ? Processor::v1 : Processor::v2;
    at += map == 1 ? 1 : 2;
  }
  const unsigned opcode = byte(at++);
  char form = map == 0   ? one_byte_opcodes[opcode]
              : map == 1 ? two_byte_opcodes[opcode]
              : map == 3 ? 'M'
                         : 'm';
  if (std::string_view("mMZgG").find(form) != std::string_view::npos) {
    const unsigned modrm = byte(at++);
    if ((form == 'g' || form == 'G') && (modrm & 0x30) != 0) form = 'm';
    const bool has_sib = modrm < 0xc0 && (modrm & 7) == 4;
    const unsigned base = has_sib ? byte(at++) & 7 : modrm & 7;
    at += modrm >= 0xc0 ? 0 : modrm >= 0x80 || (modrm < 0x40 && base == 5) ? 4 : modrm >= 0x40;
  }
  const bool has_word = form == 'z' || form == 'Z' || form == 'G' || (form == 'w' && !is_wide);
  at += has_word                                    ? (is_short ? 2 : 4)
        : form == 'b' || form == 'M' || form == 'g' ? 1
        : form == 'h'                               ? 2
        : form == 'i'                               ? 4
        : form == 'q' || form == 'w'                ? 8
                                                    : 0;
  return {at, needs};
}

}  // namespace

Processor processor_for(std::string_view library) {
  std::array<std::size_t, 4> count{};  // of instructions of each level
  std::size_t left = library.size();   // bytes to read
  const auto header = item_at<Elf64_Ehdr>(library, 0);
  const bool is_known = header && std::memcmp(header->e_ident, ELFMAG, SELFMAG) == 0 &&
                        header->e_machine == EM_X86_64;
  for (std::uint64_t i = 0; is_known && i < header->e_shnum; ++i) {
    const auto section = item_at<Elf64_Shdr>(library, header->e_shoff + i * sizeof(Elf64_Shdr));
    if (!section || section->sh_type != SHT_PROGBITS || (section->sh_flags & SHF_EXECINSTR) == 0 ||
        section->sh_offset > library.size())
      continue;
    std::string_view code = library.substr(section->sh_offset, section->sh_size).substr(0, left);
    left -= code.size();
    while (!code.empty()) {
      const Instruction next = read_instruction(code);
      ++count[static_cast<std::size_t>(next.needs)];
      code.remove_prefix(std::min(next.size, code.size()));
    }
  }
  for (const Processor level : {Processor::v4, Processor::v3, Processor::v2}) {
    if (count[static_cast<std::size_t>(level)] > 1) return level;
  }
  return Processor::v1;
}

}  // namespace mirocup::plugins
