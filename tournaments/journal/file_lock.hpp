// SPDX-License-Identifier: MIT
//
// An exclusive lock on a file (flock), held as long as the object lives. The kernel releases it
// when the process ends, in whatever manner. The text of the file is for people and other programs.
#pragma once

#include "core/base/error.hpp"

#include <optional>
#include <string>

namespace mirocup::league {

class FileLock {
 public:
  // Waits until the lock is free.
  static Result<FileLock> acquire(const std::string& path);

  // Returns nothing if another process holds the lock. Otherwise `text` replaces the file's text.
  static Result<std::optional<FileLock>> try_acquire(const std::string& path,
                                                     const std::string& text);

  // True if a process holds the lock.
  static bool is_held(const std::string& path);

  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  ~FileLock();

 private:
  explicit FileLock(int fd) : fd_(fd) {}
  int fd_;
};

}  // namespace mirocup::league
