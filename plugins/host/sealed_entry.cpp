// SPDX-License-Identifier: MIT
#include "plugins/host/sealed_entry.hpp"

#include "system/files.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sys/mman.h>
#include <utility>

namespace mirocup::plugins {

namespace {

// Editors on Windows begin a text in UTF-8 with it, and Python skips it.
constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

}  // namespace

Result<SealedEntry> SealedEntry::open(const std::string& path) {
  MIROCUP_TRY(const auto file,
              system::open_file(
                  path, {.max_size = system::size_limit::entry,
                         .if_too_large = "; build it without debugging symbols and large tables"}));
  MIROCUP_TRY(const auto content, system::read_file(file));
  if (content.empty()) return fail(Errc::input, path + ": it is empty");
  const std::size_t size = content.size();
  auto sealed = system::sealed_copy(content);
  if (!sealed) return fail(sealed.error().code, path + ": " + sealed.error().what);
  void* bytes = mmap(nullptr, size, PROT_READ, MAP_SHARED, sealed->get(), 0);
  if (bytes == MAP_FAILED) return fail(Errc::unavailable, path + ": " + std::strerror(errno));
  return SealedEntry(std::move(*sealed), {static_cast<const char*>(bytes), size});
}

bool SealedEntry::is_python() const {
  if (bytes_.find('\0') != std::string_view::npos) return false;
  for (std::size_t begin = bytes_.starts_with(utf8_mark) ? utf8_mark.size() : 0;
       begin < bytes_.size();) {
    const std::size_t end = std::min(bytes_.find('\n', begin), bytes_.size());
    const std::string_view line = bytes_.substr(begin, end - begin);
    if (line.starts_with("from mirocup") || line.starts_with("import mirocup")) return true;
    begin = end + 1;
  }
  return false;
}

SealedEntry::SealedEntry(SealedEntry&& other) noexcept
    : descriptor_(std::move(other.descriptor_)), bytes_(std::exchange(other.bytes_, {})) {}

SealedEntry& SealedEntry::operator=(SealedEntry&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

SealedEntry::~SealedEntry() {
  if (!bytes_.empty()) munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

}  // namespace mirocup::plugins
