// SPDX-License-Identifier: MIT
//
// An exclusive lock on a file (flock), held as long as the object lives. The kernel releases it
// when the process ends, in any way, so a lock file alone does not mean that the lock is held.
//
// Only this user can open the file (mode 0600), because a user who can read a file can lock it. A
// link is refused; a file that belongs neither to this user nor to the owner of the folder is also
// refused.
#pragma once

#include "core/base/error.hpp"
#include "system/descriptor.hpp"

#include <optional>
#include <span>
#include <string>
#include <utility>

namespace mirocup::system {

class FileLock {
 public:
  // Waits until the lock is free.
  static Result<FileLock> acquire(const std::string& path);

  // Waits at most 0.2 s, and returns nothing if another process still holds the lock. Otherwise the
  // file names this process until the process ends, so that signal_holder() finds it.
  static Result<std::optional<FileLock>> try_acquire(const std::string& path);

  // Sends the signals to the process that holds the lock. Returns false if no process holds the
  // lock. If the holder is uncertain, for example because it runs on another computer, no process
  // is signalled, and the error is Errc::unavailable.
  static Result<bool> signal_holder(const std::string& path, std::span<const int> signals);

 private:
  explicit FileLock(Descriptor file) : file_(std::move(file)) {}
  Descriptor file_;
};

}  // namespace mirocup::system
