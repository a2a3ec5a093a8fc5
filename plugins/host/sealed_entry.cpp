// SPDX-License-Identifier: MIT
#include "plugins/host/sealed_entry.hpp"

#include "system/files.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

namespace mirocup::plugins {

namespace {

// Editors on Windows begin a text in UTF-8 with it, and Python skips it.
constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

tl::unexpected<Error> refused_entry(const std::string& path, const std::string& why) {
  return fail(Errc::input, path + ": " + why);
}

tl::unexpected<Error> system_error(const std::string& path) {
  return fail(Errc::unavailable, path + ": " + std::strerror(errno));
}

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = write(fd, bytes.data(), bytes.size());
    if (n < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

}  // namespace

Result<SealedEntry> SealedEntry::open(const std::string& path) {
  const auto file = system::open_file(
      path, {.max_size = system::size_limit::entry,
             .if_too_large = "; build it without debugging symbols and large tables"});
  if (!file) return tl::unexpected(file.error());
  const auto content = system::read_file(*file);
  if (!content) return tl::unexpected(content.error());
  if (content->empty()) return refused_entry(path, "it is empty");
  const std::size_t size = content->size();
  system::Descriptor sealed(memfd_create("entry", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!sealed.is_open() || !write_all(sealed.get(), *content)) return system_error(path);
  const int seals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL;
  if (fcntl(sealed.get(), F_ADD_SEALS, seals) != 0) return system_error(path);
  void* bytes = mmap(nullptr, size, PROT_READ, MAP_SHARED, sealed.get(), 0);
  if (bytes == MAP_FAILED) return system_error(path);
  return SealedEntry(std::move(sealed), {static_cast<const char*>(bytes), size});
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
