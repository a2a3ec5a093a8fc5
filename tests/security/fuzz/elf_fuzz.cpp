// SPDX-License-Identifier: MIT
//
// Reads any bytes as a library: the reader must return a sentence or what the library needs. The
// first byte is no part of the library: where it is odd, the bytes follow a header and two segments
// that are whole, since a fuzzer hardly finds them by itself.
#include "plugins/host/elf.hpp"
#include "tests/security/fuzz/fuzz_target.hpp"

#include <cstdlib>
#include <cstring>
#include <elf.h>

namespace {

// A header of this machine's kind, then a segment that loads all, and a dynamic segment behind the
// headers.
std::string with_headers(std::string_view rest) {
  Elf64_Ehdr header{};
  std::memcpy(header.e_ident, ELFMAG, SELFMAG);
  header.e_ident[EI_CLASS] = ELFCLASS64;
  header.e_ident[EI_DATA] = ELFDATA2LSB;
#if defined(__x86_64__)
  header.e_machine = EM_X86_64;
#else
  header.e_machine = EM_AARCH64;
#endif
  header.e_type = ET_DYN;
  header.e_phoff = sizeof header;
  header.e_phentsize = sizeof(Elf64_Phdr);
  header.e_phnum = 2;
  Elf64_Phdr segments[2]{};
  const std::size_t begin = sizeof header + sizeof segments;
  segments[0].p_type = PT_LOAD;
  segments[0].p_filesz = begin + rest.size();
  segments[1].p_type = PT_DYNAMIC;
  segments[1].p_offset = segments[1].p_vaddr = begin;
  segments[1].p_filesz = rest.size();
  std::string bytes(begin, '\0');
  std::memcpy(bytes.data(), &header, sizeof header);
  std::memcpy(bytes.data() + sizeof header, segments, sizeof segments);
  return bytes.append(rest);
}

}  // namespace

MIROCUP_FUZZ_TARGET(elf) {
  if (size == 0) return;
  const std::string_view rest = mirocup::fuzz::text_of(data + 1, size - 1);
  const std::string bytes = (*data & 1) != 0 ? with_headers(rest) : std::string(rest);
  const auto library = mirocup::plugins::read_shared_library(bytes);
  if (!library && library.error().empty()) std::abort();
}
