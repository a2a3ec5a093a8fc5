// SPDX-License-Identifier: MIT
//
// Checks, before some work, that its result can be written.
#pragma once

#include "core/base/error.hpp"

#include <string>
#include <vector>

namespace mirocup::app {

// Errc::unavailable if this process may not write into the folder of the file at `path`. A device
// or a pipe needs no folder: system::is_written_in_place().
Result<void> expect_writable_folder_of(const std::string& path);

// Like the function above, for an output that must not replace an input file. For "" it checks
// nothing.
Result<void> expect_writable_output(const std::string& path,
                                    const std::vector<std::string>& inputs);

}  // namespace mirocup::app
