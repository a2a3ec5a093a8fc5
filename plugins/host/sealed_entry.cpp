// SPDX-License-Identifier: MIT
#include "plugins/host/sealed_entry.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <utility>

namespace mirocup::plugins {

namespace {

tl::unexpected<Error> no_entry(const std::string& path, const std::string& why) {
  return fail(Errc::input, path + ": " + why);
}

tl::unexpected<Error> system_error(const std::string& path) {
  return fail(Errc::unavailable, path + ": " + std::strerror(errno));
}

// Copies until the end of the file or until more than max_entry_size bytes are copied. Returns the
// number of bytes, or -1.
ssize_t copy(int from, int to) {
  std::array<char, 1 << 16> buffer;
  std::size_t total = 0;
  while (total <= max_entry_size) {
    const ssize_t n = read(from, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return -1;
    if (n == 0) break;
    for (ssize_t done = 0; done < n;) {
      const ssize_t written = write(to, buffer.data() + done, static_cast<std::size_t>(n - done));
      if (written < 0) return -1;
      done += written;
    }
    total += static_cast<std::size_t>(n);
  }
  return static_cast<ssize_t>(total);
}

}  // namespace

Result<SealedEntry> SealedEntry::open(const std::string& path) {
  // O_NONBLOCK, because opening a pipe would wait for its other end.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (file.get() < 0 && errno == ELOOP)
    return no_entry(path, "it is a symbolic link; name the library itself");
  if (file.get() < 0) return system_error(path);
  struct stat status {};
  if (fstat(file.get(), &status) != 0) return system_error(path);
  if (!S_ISREG(status.st_mode)) return no_entry(path, "it is not a regular file");

  Descriptor sealed(memfd_create("entry", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (sealed.get() < 0) return system_error(path);
  const ssize_t size = copy(file.get(), sealed.get());
  if (size < 0) return system_error(path);
  if (size == 0) return no_entry(path, "it is empty");
  if (static_cast<std::size_t>(size) > max_entry_size) {
    return no_entry(path, "it is larger than " + std::to_string(max_entry_size >> 20) +
                              " MiB; build it without debugging symbols and large tables");
  }
  const int seals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL;
  if (fcntl(sealed.get(), F_ADD_SEALS, seals) != 0) return system_error(path);
  void* bytes =
      mmap(nullptr, static_cast<std::size_t>(size), PROT_READ, MAP_SHARED, sealed.get(), 0);
  if (bytes == MAP_FAILED) return system_error(path);
  return SealedEntry(std::move(sealed),
                     {static_cast<const char*>(bytes), static_cast<std::size_t>(size)});
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
