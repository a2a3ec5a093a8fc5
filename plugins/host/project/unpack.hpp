// SPDX-License-Identifier: MIT
//
// Unpacks the archive of a team's project: tar, plain or compressed by gzip, or zip. An archive may
// have only regular files and folders with plain names; any other entry makes the archive invalid.
#pragma once

#include "core/base/error.hpp"

#include <cstdint>
#include <string>

namespace mirocup::plugins {

struct UnpackLimits {
  int files = 1000;                             // the most files, skipped files included
  std::uint64_t file = std::uint64_t{8} << 20;  // the most bytes of a file
  std::uint64_t all = std::uint64_t{32} << 20;  // the most bytes of all kept files
  // The most bytes of all files, skipped files included, because a small archive may unpack to very
  // many bytes.
  std::uint64_t read = std::uint64_t{256} << 20;
  std::size_t path = 200;  // the most bytes of a path
  int depth = 10;          // the most folders above a file
};

// Unpacks an archive into an empty folder that exists. Skips folders whose names start with '.' or
// are "build" or "__MACOSX", and files whose names start with '.'. Errors: Errc::input with a
// sentence about the archive, Errc::host if a file cannot be written.
Result<void> unpack(const std::string& archive, const std::string& folder,
                    const UnpackLimits& limits = {});

}  // namespace mirocup::plugins
