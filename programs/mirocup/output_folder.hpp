// SPDX-License-Identifier: MIT
//
// Checks, before the work, that its result can be written.
#pragma once

#include "core/base/error.hpp"

#include <string>
#include <vector>

namespace mirocup::app {

// Errc::unavailable if this process may not write into the folder of the file at `path`. A device
// or a pipe needs no folder: system::is_written_in_place().
Result<void> expect_writable_folder_of(const std::string& path);

// The same for an output that must not replace one of the input files. "": there is no output.
Result<void> expect_writable_output(const std::string& path,
                                    const std::vector<std::string>& inputs);

}  // namespace mirocup::app
