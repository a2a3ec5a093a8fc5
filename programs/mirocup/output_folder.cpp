// SPDX-License-Identifier: MIT
#include "programs/mirocup/output_folder.hpp"

#include "system/files.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <unistd.h>

namespace mirocup::app {

Result<void> expect_writable_folder_of(const std::string& path) {
  if (system::is_written_in_place(path)) return {};
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  if (access(folder.c_str(), W_OK) == 0) return {};
  return fail(Errc::unavailable, path + ": nothing can be written into " + folder.string() + ": " +
                                     std::strerror(errno));
}

}  // namespace mirocup::app
