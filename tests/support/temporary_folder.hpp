// SPDX-License-Identifier: MIT
//
// A folder for the files of one test.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace mirocup::test_support {

// A folder that is empty at construction and is removed by the destructor.
class TemporaryFolder {
 public:
  // `place`: the folder in which it is made.
  explicit TemporaryFolder(
      const std::filesystem::path& place = std::filesystem::temp_directory_path())
      : path_((place / "mirocup-test-XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("no temporary folder");
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace mirocup::test_support
