// SPDX-License-Identifier: MIT
//
// Access to the disk. A file that is written whole is at any moment either the old one or the new
// one, also after a crash. What is appended is on disk when append() returns. Tests replace the
// disk by one with faults.
//
// Errors are Errc::unavailable and name the file and the system's reason.
#pragma once

#include "core/base/error.hpp"

#include <string>
#include <string_view>

namespace mirocup::system {

class Files {
 public:
  virtual ~Files() = default;

  virtual Result<std::string> read(const std::string& path) = 0;

  // Returns the bytes behind the first `offset`.
  virtual Result<std::string> read_from(const std::string& path, std::size_t offset);

  // Replaces the file: writes a temporary file in the same folder, flushes it to disk, renames it
  // and flushes the folder. A device or a pipe is written into.
  virtual Result<void> write(const std::string& path, std::string_view bytes) = 0;

  // Removes the temporary files of killed writers from the folder and from those below it. Files
  // that are being written stay.
  virtual Result<void> remove_unfinished(const std::string& folder) = 0;

  // Appends and flushes to disk.
  virtual Result<void> append(const std::string& path, std::string_view bytes) = 0;

  // Cuts the file to its first `size` bytes.
  virtual Result<void> truncate(const std::string& path, std::size_t size) = 0;

  virtual bool exists(const std::string& path) = 0;

  // Makes the folder and its missing parents.
  virtual Result<void> make_folder(const std::string& path) = 0;
};

// The real disk. It has no state: any number of objects may be used from any thread.
class Disk final : public Files {
 public:
  Result<std::string> read(const std::string& path) override;
  Result<std::string> read_from(const std::string& path, std::size_t offset) override;
  Result<void> write(const std::string& path, std::string_view bytes) override;
  Result<void> remove_unfinished(const std::string& folder) override;
  Result<void> append(const std::string& path, std::string_view bytes) override;
  Result<void> truncate(const std::string& path, std::size_t size) override;
  bool exists(const std::string& path) override;
  Result<void> make_folder(const std::string& path) override;
};

}  // namespace mirocup::system
