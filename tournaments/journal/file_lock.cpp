// SPDX-License-Identifier: MIT
#include "tournaments/journal/file_lock.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace mirocup::league {

namespace {

tl::unexpected<Error> problem(const std::string& path) {
  return fail(Errc::unavailable, path + " cannot be locked: " + std::strerror(errno));
}

int open_lock(const std::string& path) {
  return open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
}

int lock(int fd, int how) {
  int result = 0;
  do {
    result = flock(fd, how);
  } while (result != 0 && errno == EINTR);
  return result;
}

}  // namespace

Result<FileLock> FileLock::acquire(const std::string& path) {
  FileLock taken(open_lock(path));
  if (taken.fd_ < 0 || lock(taken.fd_, LOCK_EX) != 0) return problem(path);
  return Result<FileLock>(std::move(taken));
}

Result<std::optional<FileLock>> FileLock::try_acquire(const std::string& path,
                                                      const std::string& text) {
  FileLock taken(open_lock(path));
  if (taken.fd_ < 0) return problem(path);
  if (lock(taken.fd_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return std::nullopt;
    return problem(path);
  }
  const auto size = static_cast<ssize_t>(text.size());
  if (ftruncate(taken.fd_, 0) != 0 || ::write(taken.fd_, text.data(), text.size()) != size)
    return problem(path);
  return std::optional<FileLock>(std::move(taken));
}

bool FileLock::is_held(const std::string& path) {
  const FileLock tried(open(path.c_str(), O_RDWR | O_CLOEXEC));
  return tried.fd_ >= 0 && lock(tried.fd_, LOCK_EX | LOCK_NB) != 0;
}

FileLock::FileLock(FileLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

FileLock::~FileLock() {
  if (fd_ >= 0) close(fd_);
}

}  // namespace mirocup::league
