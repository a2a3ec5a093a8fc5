// SPDX-License-Identifier: MIT
#include "labs/training/policy/npz.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>
#include <zip.h>

namespace mirocup::policy {

namespace {

constexpr std::string_view npy_suffix = ".npy";

// The header of an .npy file: a Python dictionary.
struct NpyHeader {
  std::string kind;  // "<f4", "<U12", "|S7"
  std::vector<std::size_t> shape;
  std::size_t data = 0;  // offset
};

// Returns the text between the key and the end of its value, "'descr': '<f4'" gives "'<f4'".
std::optional<std::string_view> value_of(std::string_view dictionary, std::string_view key) {
  const std::size_t at = dictionary.find("'" + std::string(key) + "':");
  if (at == std::string_view::npos) return std::nullopt;
  std::string_view value = dictionary.substr(at + key.size() + 3);
  while (!value.empty() && value.front() == ' ') value.remove_prefix(1);
  const std::size_t end = value.find_first_of(value.starts_with("(") ? ")" : ",}");
  if (end == std::string_view::npos) return std::nullopt;
  return value.substr(0, end);
}

// "(64, 49" gives {64, 49}; nothing if it is no list of numbers, or the product is too large.
std::optional<std::vector<std::size_t>> shape_of(std::string_view text) {
  if (!text.starts_with("(")) return std::nullopt;
  std::vector<std::size_t> shape;
  std::size_t product = 1;
  std::optional<std::size_t> number;
  for (const char c : text.substr(1)) {
    if (c >= '0' && c <= '9') {
      number = 10 * number.value_or(0) + static_cast<std::size_t>(c - '0');
      if (*number > max_array_bytes) return std::nullopt;
    } else if (c == ',' && number) {
      shape.push_back(*std::exchange(number, std::nullopt));
    } else if (c != ' ' && c != ',') {
      return std::nullopt;
    }
  }
  if (number) shape.push_back(*number);
  if (shape.size() > 4) return std::nullopt;
  for (const std::size_t n : shape) {
    product *= n;  // two factors of at most 2^26, so it cannot overflow
    if (product > max_array_bytes) return std::nullopt;
  }
  return shape;
}

std::optional<NpyHeader> header_of(std::string_view bytes) {
  constexpr std::string_view magic = "\x93NUMPY";
  if (!bytes.starts_with(magic) || bytes.size() < 12) return std::nullopt;
  const auto byte = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i]));
  };
  const bool is_long = byte(6) >= 2;  // the size of the header has four bytes instead of two
  std::size_t size = byte(8) | byte(9) << 8;
  if (is_long) size |= byte(10) << 16 | byte(11) << 24;
  const std::size_t begin = is_long ? 12 : 10;
  if (size > bytes.size() - begin) return std::nullopt;
  const std::string_view dictionary = bytes.substr(begin, size);
  const auto kind = value_of(dictionary, "descr");
  const auto order = value_of(dictionary, "fortran_order");
  const auto shape_text = value_of(dictionary, "shape");
  if (!kind || kind->size() < 4 || !order || *order != "False" || !shape_text) return std::nullopt;
  auto shape = shape_of(*shape_text);
  if (!shape) return std::nullopt;
  return NpyHeader{std::string(kind->substr(1, kind->size() - 2)), std::move(*shape), begin + size};
}

// The characters of numpy's texts: 4 bytes each (U) or 1 (S), filled up with 0.
std::optional<std::string> text_of(std::string_view kind, std::string_view data) {
  const std::size_t width = kind[1] == 'U' ? 4 : 1;
  std::string text;
  for (std::size_t i = 0; i + width <= data.size(); i += width) {
    std::uint32_t c = 0;
    for (std::size_t k = 0; k < width; ++k) {
      c |= std::uint32_t{static_cast<unsigned char>(data[i + k])} << (8 * k);
    }
    if (c == 0) break;
    if (c > 127) return std::nullopt;
    text.push_back(static_cast<char>(c));
  }
  return text;
}

Result<Array> array_of(std::string_view bytes, const std::string& name) {
  const auto header = header_of(bytes);
  if (!header) return fail(Errc::damaged, name + " is not an array in C order");
  const std::string_view data = bytes.substr(header->data);
  Array array;
  if (header->kind.starts_with("<U") || header->kind.starts_with("|S")) {
    auto text = text_of(header->kind, data);
    if (!header->shape.empty() || !text) return fail(Errc::input, name + " is no plain text");
    array.is_text = true;
    array.text = std::move(*text);
    return array;
  }
  if (header->kind != "<f4") {
    return fail(Errc::input, name + ": numbers are float32 (<f4), not " + header->kind);
  }
  array.shape = header->shape;
  std::size_t count = 1;
  for (const std::size_t n : array.shape) count *= n;
  if (data.size() != count * sizeof(float)) {
    return fail(Errc::damaged, name + ": its size does not fit its shape");
  }
  array.numbers.resize(count);
  if (count > 0) std::memcpy(array.numbers.data(), data.data(), data.size());
  return array;
}

struct CloseArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseMember {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

// The name of the array in a file of the archive.
std::string name_of(const zip_stat_t& member) {
  std::string name = member.name;
  if (name.ends_with(npy_suffix)) name.resize(name.size() - npy_suffix.size());
  return name;
}

// Lists the arrays. Each may be small enough where all together are not, so the sizes are summed
// here, before memory is taken for the first.
Result<std::vector<zip_stat_t>> members_of(zip_t* archive, const std::string& path) {
  const auto count = static_cast<std::size_t>(zip_get_num_entries(archive, 0));
  if (count > max_arrays) {
    return fail(Errc::input, path + ": it has " + std::to_string(count) + " arrays, and at most " +
                                 std::to_string(max_arrays) + " are read");
  }
  constexpr zip_uint64_t known = ZIP_STAT_NAME | ZIP_STAT_INDEX | ZIP_STAT_SIZE;
  std::vector<zip_stat_t> members(count);
  std::size_t total = 0;
  for (std::size_t i = 0; i < count; ++i) {
    zip_stat_t& member = members[i];
    if (zip_stat_index(archive, i, 0, &member) != 0 || (member.valid & known) != known)
      return fail(Errc::damaged, path + ": array " + std::to_string(i + 1) + " cannot be read");
    const std::string where = path + ": " + name_of(member);
    if (member.size > max_array_bytes) {
      return fail(Errc::input, where + " is larger than " + std::to_string(max_array_bytes >> 20) +
                                   " MiB, the most for one array");
    }
    total += member.size;
    if (total > max_total_bytes) {
      return fail(Errc::input, where + ": with this array all arrays take more than " +
                                   std::to_string(max_total_bytes >> 20) +
                                   " MiB together, the most for one file; save only the arrays of "
                                   "the policy");
    }
  }
  return members;
}

Result<std::string> bytes_of(zip_t* archive, const zip_stat_t& member, const std::string& where) {
  const std::unique_ptr<zip_file_t, CloseMember> file(zip_fopen_index(archive, member.index, 0));
  std::string bytes(member.size, '\0');
  if (!file ||
      zip_fread(file.get(), bytes.data(), bytes.size()) != static_cast<zip_int64_t>(bytes.size())) {
    return fail(Errc::damaged, where + " cannot be read");
  }
  return bytes;
}

}  // namespace

Result<std::map<std::string, Array>> read_npz(std::string_view bytes, const std::string& path) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  const std::unique_ptr<zip_t, CloseArchive> archive(
      source == nullptr ? nullptr
                        : zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error));
  zip_error_fini(&error);
  if (!archive || bytes.empty()) {
    if (!archive) zip_source_free(source);
    return fail(Errc::damaged, path + ": it is no .npz file, as numpy.savez writes it");
  }
  MIROCUP_TRY(const auto members, members_of(archive.get(), path));
  std::map<std::string, Array> arrays;
  for (const zip_stat_t& member : members) {
    const std::string name = name_of(member);
    const std::string where = path + ": " + name;
    MIROCUP_TRY(const auto data, bytes_of(archive.get(), member, where));
    MIROCUP_TRY(auto array, array_of(data, where));
    arrays.emplace(name, std::move(array));
  }
  return arrays;
}

}  // namespace mirocup::policy
