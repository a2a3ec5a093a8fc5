// SPDX-License-Identifier: MIT
//
// A team's library as it was handed in: copied once into sealed memory.
//
// The copy is what is hashed, looked into and played, so a file that changes meanwhile changes
// nothing. The server never loads it: only a sandboxed process does.
#pragma once

#include "core/base/error.hpp"
#include "plugins/host/descriptor.hpp"

#include <string>
#include <string_view>

namespace mirocup::plugins {

// Larger files are no strategies.
inline constexpr std::size_t max_entry_size = 32u << 20;  // bytes

class SealedEntry {
 public:
  // Errors: Errc::unavailable if the file cannot be read; Errc::input if it can be no entry: a
  // link, a folder, a device, empty or too large.
  static Result<SealedEntry> open(const std::string& path);

  SealedEntry(SealedEntry&& other) noexcept;
  SealedEntry& operator=(SealedEntry&& other) noexcept;
  ~SealedEntry();

  // Valid as long as the entry.
  std::string_view bytes() const { return bytes_; }

  // Of the sealed copy, open for reading.
  int descriptor() const { return descriptor_.get(); }

 private:
  SealedEntry(Descriptor descriptor, std::string_view bytes)
      : descriptor_(std::move(descriptor)), bytes_(bytes) {}

  Descriptor descriptor_;
  std::string_view bytes_;
};

}  // namespace mirocup::plugins
