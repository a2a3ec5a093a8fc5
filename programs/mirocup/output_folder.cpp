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

Result<void> expect_writable_output(const std::string& path,
                                    const std::vector<std::string>& inputs) {
  if (path.empty()) return {};
  std::error_code none;
  for (const std::string& input : inputs) {
    if (std::filesystem::weakly_canonical(std::filesystem::absolute(input), none) ==
        std::filesystem::weakly_canonical(std::filesystem::absolute(path), none))
      return fail(Errc::input, path + " is an input and cannot be the output as well");
  }
  if (std::filesystem::is_directory(path, none)) return fail(Errc::input, path + " is a folder");
  return expect_writable_folder_of(path);
}

}  // namespace mirocup::app
