// SPDX-License-Identifier: MIT
//
// An exclusive lock on a file, held from construction to destruction. It excludes other processes;
// the kernel releases it when the process ends, however it ends. The file may hold a text for
// people and other programs.
#pragma once

#include "core/base/error.hpp"

#include <optional>
#include <string>

namespace mirocup::league {

class FileLock {
 public:
  // Locks the file; blocks until another holder has released it.
  static Result<FileLock> acquire(const std::string& path);

  // Locks the file without waiting; returns an empty value if another process holds the lock. On
  // success `text` replaces the file's content.
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
