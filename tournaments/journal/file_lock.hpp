// SPDX-License-Identifier: MIT
//
// Keeps other processes out for as long as it lives: an exclusive lock on a file, which the kernel
// gives up when the process ends, however it ends. The file's text is for people and other
// programs.
#pragma once

#include "core/base/error.hpp"

#include <optional>
#include <string>

namespace mirocup::league {

class FileLock {
 public:
  // Waits for whoever has it.
  static Result<FileLock> acquire(const std::string& path);

  // Nothing if somebody else has it. `text` replaces what the file says.
  static Result<std::optional<FileLock>> try_acquire(const std::string& path,
                                                     const std::string& text);

  // Does anybody have it?
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
