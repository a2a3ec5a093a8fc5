// SPDX-License-Identifier: MIT
//
// The door to the disk. Whole files are written so that there is always either the old one or the
// new one; journals grow line by line, each on disk before anybody acts on it. Tests put a disk
// with faults behind it.
#pragma once

#include "core/base/error.hpp"

#include <string>
#include <string_view>

namespace mirocup::system {

class Files {
 public:
  virtual ~Files() = default;

  virtual Result<std::string> read(const std::string& path) = 0;

  // What stands behind the first `offset` bytes.
  virtual Result<std::string> read_from(const std::string& path, std::size_t offset);

  // Replaces the file: a temporary name in the same folder, flushed to disk, renamed, the folder
  // flushed. A device or a pipe is written into.
  virtual Result<void> write(const std::string& path, std::string_view bytes) = 0;

  // Removes what writers that were killed left in the folder and those below it; what is being
  // written stays.
  virtual Result<void> remove_unfinished(const std::string& folder) = 0;

  // Appends and flushes to disk.
  virtual Result<void> append(const std::string& path, std::string_view bytes) = 0;

  // Cuts the file to its first `size` bytes.
  virtual Result<void> truncate(const std::string& path, std::size_t size) = 0;

  virtual bool exists(const std::string& path) = 0;

  // Makes the folder and those above it.
  virtual Result<void> make_folder(const std::string& path) = 0;
};

// The real one. It holds no state: any number of them may be used from any thread.
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
