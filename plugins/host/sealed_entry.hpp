// SPDX-License-Identifier: MIT
//
// A team's library or Python text as it was handed in, copied once into sealed memory.
//
// The copy is hashed, inspected and played, so a file that changes later has no effect. The server
// never loads the library; only a sandboxed process does.
#pragma once

#include "core/base/error.hpp"
#include "system/descriptor.hpp"

#include <string>
#include <string_view>

namespace mirocup::plugins {

class SealedEntry {
 public:
  // Copies the file. Errors: Errc::unavailable if the file cannot be read; Errc::input if it is a
  // symbolic link, a folder, a device, empty or too large.
  static Result<SealedEntry> open(const std::string& path);

  SealedEntry(SealedEntry&& other) noexcept;
  SealedEntry& operator=(SealedEntry&& other) noexcept;
  ~SealedEntry();

  // Returns the contents of the copy, which are valid as long as this object lives.
  std::string_view bytes() const { return bytes_; }

  // True if the entry is a team in Python: a text, not a library, without a zero byte, and with a
  // line that imports from mirocup.
  bool is_python() const;

  // Returns the descriptor of the sealed copy, open for reading; this object still owns the
  // descriptor.
  int descriptor() const { return descriptor_.get(); }

 private:
  SealedEntry(system::Descriptor descriptor, std::string_view bytes)
      : descriptor_(std::move(descriptor)), bytes_(bytes) {}

  system::Descriptor descriptor_;
  std::string_view bytes_;
};

}  // namespace mirocup::plugins
