// SPDX-License-Identifier: MIT
#include "plugins/host/elf.hpp"

#include <cstdint>
#include <cstring>
#include <elf.h>
#include <optional>

namespace mirocup::plugins {

namespace {

constexpr std::string_view entry_name = "mirocup_entry";

// What is read of a file, whatever its tables claim. A library has about ten segments, thirty
// dynamic entries and ten libraries that it needs. Every loop below ends at one of these numbers or
// at the end of the file, and looks at a bounded number of bytes each time.
constexpr std::size_t max_segments = 256;
constexpr std::size_t max_loaded_segments = 64;  // each address is looked up in all of them
constexpr std::size_t max_dynamic_entries = 4096;
constexpr std::size_t max_needed = 256;
constexpr std::size_t max_name = 255;          // bytes: the longest name of a file
constexpr std::size_t max_search_path = 4095;  // bytes: the longest path
constexpr std::size_t max_chain_length = 1u << 20;

#if defined(__x86_64__)
constexpr Elf64_Half this_machine = EM_X86_64;
constexpr const char* this_machine_name = "x86-64";
#elif defined(__aarch64__)
constexpr Elf64_Half this_machine = EM_AARCH64;
constexpr const char* this_machine_name = "arm64";
#endif

// The file and the addresses that its segments would have in memory.
class Image {
 public:
  explicit Image(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  std::optional<T> at_offset(std::uint64_t offset) const {
    return item_at<T>(bytes_, offset);
  }

  template <class T>
  std::optional<T> at_address(std::uint64_t address) const {
    const auto offset = offset_of(address);
    return offset ? at_offset<T>(*offset) : std::nullopt;
  }

  // The text up to its zero; nothing if it has more than `max_size` bytes.
  std::optional<std::string_view> text_at_address(std::uint64_t address,
                                                  std::size_t max_size) const {
    const auto offset = offset_of(address);
    if (!offset || *offset >= bytes_.size()) return std::nullopt;
    const std::string_view rest = bytes_.substr(*offset, max_size + 1);
    const std::size_t end = rest.find('\0');
    if (end == std::string_view::npos) return std::nullopt;
    return rest.substr(0, end);
  }

  // True if this text with its zero is there. Does not look for the end of a longer one.
  bool has_text_at_address(std::uint64_t address, std::string_view text) const {
    const auto offset = offset_of(address);
    return offset && contains(*offset, text.size() + 1) &&
           bytes_.substr(*offset, text.size()) == text && bytes_[*offset + text.size()] == '\0';
  }

  bool contains(std::uint64_t offset, std::uint64_t size) const {
    return offset <= bytes_.size() && size <= bytes_.size() - offset;
  }

  std::vector<Elf64_Phdr> loaded;

 private:
  std::optional<std::uint64_t> offset_of(std::uint64_t address) const {
    for (const Elf64_Phdr& segment : loaded) {
      if (address >= segment.p_vaddr && address - segment.p_vaddr < segment.p_filesz) {
        return segment.p_offset + (address - segment.p_vaddr);
      }
    }
    return std::nullopt;
  }

  std::string_view bytes_;
};

// The addresses and values of the dynamic section.
struct Dynamic {
  std::uint64_t strings = 0, symbols = 0, hash = 0, gnu_hash = 0, flags_1 = 0;
  std::vector<std::uint64_t> needed;
  std::optional<std::uint64_t> search_path;
};

tl::unexpected<std::string> bad(const char* why) {
  return tl::unexpected<std::string>(why);
}

tl::expected<Elf64_Ehdr, std::string> read_header(const Image& image) {
  const auto ident = image.at_offset<std::uint32_t>(0);
  if (!ident || std::memcmp(&*ident, ELFMAG, SELFMAG) != 0)
    return bad("it is not an ELF file: hand in the shared library (.so) that the build made");
  const auto header = image.at_offset<Elf64_Ehdr>(0);
  if (!header) return bad("it is cut off in its first bytes: copy it again");
  if (header->e_ident[EI_CLASS] != ELFCLASS64 || header->e_ident[EI_DATA] != ELFDATA2LSB ||
      header->e_machine != this_machine) {
    return tl::unexpected<std::string>(
        std::string("it was built for another kind of processor: build it for ") +
        this_machine_name);
  }
  if (header->e_type == ET_REL) return bad("it is an object file: link it with -shared");
  if (header->e_type != ET_DYN) return bad("it is a program, not a library: link it with -shared");
  if (header->e_phentsize != sizeof(Elf64_Phdr) || header->e_phnum == 0 ||
      header->e_phnum > max_segments) {
    return bad("its program headers are damaged: build it again");
  }
  return *header;
}

// Fills image.loaded and returns the dynamic segment.
tl::expected<Elf64_Phdr, std::string> read_segments(Image& image, const Elf64_Ehdr& header) {
  std::optional<Elf64_Phdr> dynamic;
  for (std::size_t i = 0; i < header.e_phnum; ++i) {
    const auto segment = image.at_offset<Elf64_Phdr>(header.e_phoff + i * sizeof(Elf64_Phdr));
    if (!segment) return bad("it is cut off: copy it again");
    if (segment->p_type != PT_LOAD && segment->p_type != PT_DYNAMIC) continue;
    if (!image.contains(segment->p_offset, segment->p_filesz))
      return bad("it is cut off: parts that it describes are missing; copy it again");
    if (segment->p_type == PT_LOAD) image.loaded.push_back(*segment);
    if (image.loaded.size() > max_loaded_segments)
      return bad("its program headers are damaged: build it again");
    if (segment->p_type == PT_DYNAMIC) dynamic = *segment;
  }
  if (image.loaded.empty() || !dynamic) return bad("it has nothing to load: link it with -shared");
  return *dynamic;
}

tl::expected<Dynamic, std::string> read_dynamic(const Image& image, const Elf64_Phdr& segment) {
  Dynamic dynamic;
  for (std::size_t i = 0; i < max_dynamic_entries; ++i) {
    const auto item = image.at_address<Elf64_Dyn>(segment.p_vaddr + i * sizeof(Elf64_Dyn));
    if (!item) break;
    const std::uint64_t value = item->d_un.d_val;
    switch (item->d_tag) {
      case DT_NULL:
        if (dynamic.strings == 0 || dynamic.symbols == 0)
          return bad("it has no table of symbols: link it with -shared");
        return dynamic;
      case DT_STRTAB:
        dynamic.strings = value;
        break;
      case DT_SYMTAB:
        dynamic.symbols = value;
        break;
      case DT_HASH:
        dynamic.hash = value;
        break;
      case DT_GNU_HASH:
        dynamic.gnu_hash = value;
        break;
      case DT_FLAGS_1:
        dynamic.flags_1 = value;
        break;
      case DT_NEEDED:
        if (dynamic.needed.size() == max_needed)
          return bad("it needs too many libraries: link them statically");
        dynamic.needed.push_back(value);
        break;
      case DT_RPATH:
      case DT_RUNPATH:
        dynamic.search_path = value;
        break;
      default:
        break;
    }
  }
  return bad("its dynamic section has no end: build it again");
}

std::optional<Elf64_Sym> symbol_at(const Image& image, const Dynamic& dynamic,
                                   std::uint64_t index) {
  return image.at_address<Elf64_Sym>(dynamic.symbols + index * sizeof(Elf64_Sym));
}

// True if the symbol is a defined function named mirocup_entry.
bool is_entry(const Image& image, const Dynamic& dynamic, const Elf64_Sym& symbol) {
  if (symbol.st_shndx == SHN_UNDEF) return false;
  const unsigned type = ELF64_ST_TYPE(symbol.st_info);
  return (type == STT_FUNC || type == STT_GNU_IFUNC) &&
         image.has_text_at_address(dynamic.strings + symbol.st_name, entry_name);
}

// Follows the chain of the entry's name in the GNU hash table.
bool is_in_gnu_hash(const Image& image, const Dynamic& dynamic) {
  std::uint32_t hash = 5381;
  for (const char c : entry_name) hash = hash * 33 + static_cast<unsigned char>(c);
  const auto buckets = image.at_address<std::uint32_t>(dynamic.gnu_hash);
  const auto first = image.at_address<std::uint32_t>(dynamic.gnu_hash + 4);
  const auto bloom = image.at_address<std::uint32_t>(dynamic.gnu_hash + 8);
  if (!buckets || !first || !bloom || *buckets == 0) return false;
  const std::uint64_t table = dynamic.gnu_hash + 16 + std::uint64_t{8} * *bloom;
  const std::uint64_t chains = table + std::uint64_t{4} * *buckets;
  const auto begin = image.at_address<std::uint32_t>(table + 4 * (hash % *buckets));
  if (!begin || *begin < *first) return false;
  for (std::uint64_t i = *begin; i - *begin < max_chain_length; ++i) {
    const auto link = image.at_address<std::uint32_t>(chains + 4 * (i - *first));
    if (!link) return false;
    if ((*link | 1) == (hash | 1)) {
      const auto symbol = symbol_at(image, dynamic, i);
      if (!symbol) return false;
      if (is_entry(image, dynamic, *symbol)) return true;
    }
    if ((*link & 1) != 0) return false;
  }
  return false;
}

bool is_in_any_hash(const Image& image, const Dynamic& dynamic) {
  if (dynamic.gnu_hash != 0) return is_in_gnu_hash(image, dynamic);
  const auto symbols = image.at_address<std::uint32_t>(dynamic.hash + 4);
  if (dynamic.hash == 0 || !symbols) return false;
  for (std::uint64_t i = 0; i < *symbols && i < max_chain_length; ++i) {
    const auto symbol = symbol_at(image, dynamic, i);
    if (!symbol) return false;
    if (is_entry(image, dynamic, *symbol)) return true;
  }
  return false;
}

}  // namespace

tl::expected<SharedLibrary, std::string> read_shared_library(std::string_view bytes) {
  Image image(bytes);
  MIROCUP_TRY(const auto header, read_header(image));
  MIROCUP_TRY(const auto segment, read_segments(image, header));
  // The section headers come last in the file, so this finds a file that has lost its end.
  const std::uint64_t sections = std::uint64_t{header.e_shnum} * header.e_shentsize;
  if (sections > 0 && !image.contains(header.e_shoff, sections))
    return bad("it is cut off: its end is missing; copy it again");
  MIROCUP_TRY(const auto dynamic, read_dynamic(image, segment));
  if ((dynamic.flags_1 & DF_1_PIE) != 0)
    return bad("it is a program, not a library: link it with -shared");

  SharedLibrary library;
  for (const std::uint64_t name : dynamic.needed) {
    const auto text = image.text_at_address(dynamic.strings + name, max_name);
    if (!text)
      return bad(
          "the names of the libraries that it needs are damaged or too long: build it again");
    library.needed.emplace_back(*text);
  }
  if (dynamic.search_path) {
    const auto text =
        image.text_at_address(dynamic.strings + *dynamic.search_path, max_search_path);
    if (!text) return bad("its search path is damaged or too long: build it again");
    library.search_path = *text;
  }
  library.exports_entry = is_in_any_hash(image, dynamic);
  return library;
}

}  // namespace mirocup::plugins
