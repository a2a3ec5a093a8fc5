// SPDX-License-Identifier: MIT
#include "plugins/host/function_names.hpp"

#include "plugins/host/elf.hpp"

#include <algorithm>
#include <cstring>
#include <elf.h>
#include <optional>

namespace mirocup::plugins {

namespace {

constexpr std::size_t max_sections = 1024;
constexpr std::size_t max_symbols = 1u << 21;  // of all tables
constexpr std::size_t max_symbol_name = 511;   // bytes
constexpr std::size_t max_parts = 8;           // of a name, as A::b

std::string_view part_of(std::string_view bytes, std::uint64_t offset, std::uint64_t size) {
  if (offset > bytes.size() || size > bytes.size() - offset) return {};
  return bytes.substr(offset, size);
}

// Looks all addresses without a name up in one table of symbols, whose section names the one with
// its texts.
void name_from(std::string_view library, const Elf64_Shdr& table, const Elf64_Shdr& texts,
               std::span<const std::uint64_t> addresses, FunctionNames& found) {
  const std::string_view symbols = part_of(library, table.sh_offset, table.sh_size);
  const std::string_view names = part_of(library, texts.sh_offset, texts.sh_size);
  const std::size_t count =
      std::min(symbols.size() / sizeof(Elf64_Sym), max_symbols - found.symbols_read);
  found.symbols_read += count;
  for (std::size_t i = 0; i < count; ++i) {
    const auto symbol = *item_at<Elf64_Sym>(symbols, i * sizeof(Elf64_Sym));
    if (ELF64_ST_TYPE(symbol.st_info) != STT_FUNC || symbol.st_shndx == SHN_UNDEF ||
        symbol.st_name >= names.size()) {
      continue;
    }
    for (std::size_t k = 0; k < addresses.size(); ++k) {
      if (!found.names[k].empty() || addresses[k] < symbol.st_value ||
          addresses[k] - symbol.st_value >= symbol.st_size) {
        continue;
      }
      const std::string_view name = names.substr(symbol.st_name, max_symbol_name);
      found.names[k] = name.substr(0, name.find('\0'));
    }
  }
}

// Takes "4Mine" off the front of `text`. Returns nothing, and leaves it, if there is no such part.
std::optional<std::string_view> take_part(std::string_view& text) {
  std::size_t digits = 0, length = 0;
  while (digits < 4 && digits < text.size() && text[digits] >= '0' && text[digits] <= '9') {
    length = 10 * length + static_cast<std::size_t>(text[digits++] - '0');
  }
  if (length == 0 || length > text.size() - digits) return std::nullopt;
  const std::string_view part = text.substr(digits, length);
  text.remove_prefix(digits + length);
  return part;
}

}  // namespace

FunctionNames functions_at(std::string_view library, std::span<const std::uint64_t> addresses) {
  FunctionNames found;
  found.names.resize(addresses.size());
  const auto header = item_at<Elf64_Ehdr>(library, 0);
  if (!header || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0 ||
      header->e_shentsize != sizeof(Elf64_Shdr)) {
    return found;
  }
  const std::size_t sections = std::min<std::size_t>(header->e_shnum, max_sections);
  const auto section = [&](std::uint64_t i) {
    return i < sections ? item_at<Elf64_Shdr>(library, header->e_shoff + i * sizeof(Elf64_Shdr))
                        : std::nullopt;
  };
  // The whole table, which a stripped library lacks, and that of what it exports. A library has one
  // of each kind, so further ones are not read.
  for (const Elf64_Word kind : {SHT_SYMTAB, SHT_DYNSYM}) {
    std::optional<Elf64_Shdr> table;
    for (std::size_t i = 0; i < sections && !table; ++i) {
      table = section(i);
      if (table && table->sh_type != kind) table.reset();
    }
    const auto texts = table ? section(table->sh_link) : std::nullopt;
    if (texts) name_from(library, *table, *texts, addresses, found);
  }
  for (std::string& name : found.names) name = readable_name(name);
  return found;
}

// The names of C++ as GCC and Clang write them: _Z, then a name with its length before it, or N and
// several of them and E. What follows, the types of the arguments, is left out. Templates and
// operators stay as they are.
std::string readable_name(std::string_view symbol) {
  std::string_view rest = symbol;
  if (!rest.starts_with("_Z")) return std::string(symbol);
  rest.remove_prefix(2);
  // A lambda, as those that MIROCUP_EXPORT_TEAM makes.
  const bool is_within = rest.starts_with("Z");
  if (is_within) rest.remove_prefix(1);
  const bool is_nested = rest.starts_with("N");
  if (is_nested) rest.remove_prefix(1);
  while (is_nested && (rest.starts_with("K") || rest.starts_with("L"))) rest.remove_prefix(1);
  if (!is_nested && rest.starts_with("L")) rest.remove_prefix(1);  // a static function
  std::string name;
  for (std::size_t i = 0; i < (is_nested ? max_parts : 1); ++i) {
    const auto part = take_part(rest);
    if (!part) break;
    if (part->starts_with("_GLOBAL__N")) continue;  // an unnamed namespace
    if (!name.empty()) name += "::";
    name += *part;
  }
  const bool is_whole = !is_nested || rest.starts_with("E");
  if (name.empty() || !is_whole) return std::string(symbol);
  return is_within ? "a function within " + name : name;
}

}  // namespace mirocup::plugins
